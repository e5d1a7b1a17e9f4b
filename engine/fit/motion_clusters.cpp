#include "engine/fit/motion_clusters.h"

#include <algorithm>
#include <numeric>

#include "engine/core/interrupt.h"
#include "engine/core/parallel.h"
#include "engine/fit/rigid_motion.h"

namespace sinew {
namespace {

constexpr std::size_t patch = 20;  ///< vertices from which a new bone takes its first transform: Le and Deng's
constexpr int rounds = 5;          ///< of vertices to bones and transforms in turn, a split

/// Two vertices that move alike within this share of the mesh's diagonal move as one.
constexpr double apart = 1e-7;

/// The bone of each vertex and how far it misses it.
struct Grouping {
  std::vector<std::uint32_t> bone;
  std::vector<double> error;
};

void assign(const MovingMesh& mesh, const BonePoses& bones, Grouping& grouping) {
  parallel_for(
      mesh.vertices(),
      [&](std::size_t v) {
        grouping.bone[v] = 0;
        grouping.error[v] = mesh.error(v, bones, 0);
        for (std::uint32_t b = 1; b < bones.bones; ++b) {
          const double error = mesh.error(v, bones, b);
          if (error >= grouping.error[v]) continue;
          grouping.error[v] = error;
          grouping.bone[v] = b;
        }
      },
      64);
}

void fit_groups(const MovingMesh& mesh, const Grouping& grouping, BonePoses& bones) {
  parallel_for(
      mesh.poses,
      [&](std::size_t k) {
        std::vector<RigidMotion> motions(bones.bones);
        for (std::size_t v = 0; v < mesh.vertices(); ++v)
          motions[grouping.bone[v]].add(mesh.rest[v], mesh.posed[v * mesh.poses + k], 1.0);
        for (std::size_t b = 0; b < bones.bones; ++b) bones.at(b, k) = motions[b].solve(bones.at(b, k));
      },
      1);
}

/// A vertex to split each group at: missed by much, far from the group's middle; and the groups, the worst first.
struct Seeds {
  std::vector<std::size_t> vertex;
  std::vector<std::size_t> order;
};

Seeds find_seeds(const MovingMesh& mesh, const Grouping& grouping, std::size_t groups) {
  std::vector<Vec3> middle(groups, Vec3(0.0));
  std::vector<double> size(groups), error(groups), best(groups, -1.0);
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    middle[grouping.bone[v]] += mesh.rest[v];
    size[grouping.bone[v]] += 1.0;
    error[grouping.bone[v]] += grouping.error[v];
  }
  Seeds seeds{std::vector<std::size_t>(groups), std::vector<std::size_t>(groups)};
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    const std::uint32_t b = grouping.bone[v];
    const double far = grouping.error[v] * glm::length(mesh.rest[v] - middle[b] / size[b]);
    if (far <= best[b]) continue;
    best[b] = far;
    seeds.vertex[b] = v;
  }
  std::iota(seeds.order.begin(), seeds.order.end(), std::size_t{0});
  std::stable_sort(seeds.order.begin(), seeds.order.end(),
                   [&](std::size_t a, std::size_t b) { return error[a] > error[b]; });
  return seeds;
}

BonePoses grown(const BonePoses& bones, std::size_t count) {
  BonePoses out(count, bones.poses);
  std::copy(bones.transforms.begin(), bones.transforms.end(), out.transforms.begin());
  return out;
}

}  // namespace

double MovingMesh::error(std::size_t vertex, const BonePoses& bones, std::size_t bone) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < poses; ++k) {
    const Vec3 off = bones.at(bone, k).transform_point(rest[vertex]) - posed[vertex * poses + k];
    sum += glm::dot(off, off);
  }
  return sum;
}

double MovingMesh::diagonal() const {
  Bounds bounds;
  for (const Vec3& p : rest) bounds.add(p);
  return bounds.diagonal();
}

void start_bone(const MovingMesh& mesh, std::size_t vertex, std::size_t bone, BonePoses& bones) {
  std::vector<std::pair<double, std::size_t>> near(mesh.vertices());
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    const Vec3 off = mesh.rest[v] - mesh.rest[vertex];
    near[v] = {glm::dot(off, off), v};
  }
  const std::size_t count = std::min(patch, near.size());
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
  for (std::size_t k = 0; k < mesh.poses; ++k) {
    RigidMotion motion;
    for (std::size_t i = 0; i < count; ++i)
      motion.add(mesh.rest[near[i].second], mesh.posed[near[i].second * mesh.poses + k], 1.0);
    bones.at(bone, k) = motion.solve({});
  }
}

Result<BonePoses> clustered_motions(const MovingMesh& mesh, std::size_t count) {
  const double noticed = apart * mesh.diagonal();
  Grouping grouping{std::vector<std::uint32_t>(mesh.vertices()), std::vector<double>(mesh.vertices())};
  BonePoses bones(1, mesh.poses);
  fit_groups(mesh, grouping, bones);
  assign(mesh, bones, grouping);
  while (bones.bones < count) {
    if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
    const double worst = *std::max_element(grouping.error.begin(), grouping.error.end());
    if (worst <= noticed * noticed * static_cast<double>(mesh.poses))
      return bad_input("{} bones are more than can be told apart: {} rigid motions explain all examples", count,
                       bones.bones);
    const Seeds seeds = find_seeds(mesh, grouping, bones.bones);
    const std::size_t before = bones.bones, after = std::min(count, 2 * before);
    bones = grown(bones, after);
    for (std::size_t i = before; i < after; ++i) start_bone(mesh, seeds.vertex[seeds.order[i - before]], i, bones);
    for (int round = 0; round < rounds; ++round) {
      assign(mesh, bones, grouping);
      fit_groups(mesh, grouping, bones);
    }
    assign(mesh, bones, grouping);
  }
  return bones;
}

}  // namespace sinew
