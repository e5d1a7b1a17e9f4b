#include "engine/fit/rigid_bones.h"

#include <algorithm>

#include <tbb/enumerable_thread_specific.h>

#include "engine/core/interrupt.h"
#include "engine/core/parallel.h"
#include "engine/fit/motion_clusters.h"
#include "engine/fit/rigid_motion.h"
#include "engine/fit/skin_fit.h"
#include "engine/fit/vertex_fit.h"
#include "engine/fit/weight_run.h"

namespace sinew {
namespace {

/// A bone with less than this sum of squared weights does nothing and starts anew elsewhere: Le and Deng, 3.3.
constexpr double least_use = 1e-2;

/// Rounds go on while the squared error falls by this share.
constexpr double worth_a_round = 2e-3;

/// Weights and transforms in turn.
class Alternation {
 public:
  Alternation(const RigidBonesJob& job, const MovingMesh& mesh, BonePoses bones)
      : job_(job), mesh_(mesh), bones(std::move(bones)), supports(mesh.vertices()) {}

  /// `anew`: with the bones chosen among all, else from the choice of the round before on.
  Result<void> fit_weights(bool anew) {
    constexpr std::size_t block = 4096;
    tbb::enumerable_thread_specific<VertexFit> fits([&] { return VertexFit(bones); });
    for (std::size_t begin = 0; begin < mesh_.vertices(); begin += block) {
      if (auto ok = check_interrupt(); !ok) return ok;
      parallel_for(
          std::min(block, mesh_.vertices() - begin),
          [&](std::size_t i) {
            const std::size_t v = begin + i;
            VertexFit& fit = fits.local();
            fit.begin(mesh_.rest[v], mesh_.posed.subspan(v * mesh_.poses, mesh_.poses));
            supports[v] = anew ? fit.convex(job_.influences) : fit.convex_from(supports[v], job_.influences);
          },
          32);
    }
    return {};
  }

  double squared_error() const {
    double sum = 0.0;
    for (const Support& support : supports) sum += support.error;
    return sum;
  }

  /// Each bone to what the others leave, one after the other; poses are apart from each other.
  void fit_transforms() {
    std::vector<std::vector<std::pair<std::size_t, double>>> followers(bones.bones);
    for (std::size_t v = 0; v < supports.size(); ++v)
      for (std::size_t i = 0; i < supports[v].size; ++i)
        if (supports[v].weight[i] > 0.0) followers[supports[v].bone[i]].emplace_back(v, supports[v].weight[i]);
    parallel_for(
        mesh_.poses,
        [&](std::size_t k) {
          std::vector<Vec3> left(mesh_.vertices());
          for (std::size_t v = 0; v < left.size(); ++v) left[v] = mesh_.posed[v * mesh_.poses + k];
          const auto move = [&](std::size_t b, double sign) {
            for (const auto& [v, weight] : followers[b])
              left[v] += sign * weight * bones.at(b, k).transform_point(mesh_.rest[v]);
          };
          for (std::size_t b = 0; b < bones.bones; ++b) move(b, -1.0);
          for (std::size_t b = 0; b < bones.bones; ++b) {
            move(b, 1.0);
            RigidMotion motion;
            for (const auto& [v, weight] : followers[b]) motion.add(mesh_.rest[v], left[v], weight);
            bones.at(b, k) = motion.solve(bones.at(b, k));
            move(b, -1.0);
          }
        },
        1);
  }

  /// Bones that nothing follows start anew where the fit is worst. True where there was one.
  bool restart_idle() {
    std::vector<double> use(bones.bones);
    for (const Support& support : supports)
      for (std::size_t i = 0; i < support.size; ++i) use[support.bone[i]] += support.weight[i] * support.weight[i];
    bool any = false;
    for (std::size_t b = 0; b < bones.bones; ++b) {
      if (use[b] >= least_use) continue;
      any = true;
      const auto worst = std::max_element(supports.begin(), supports.end(),
                                          [](const Support& a, const Support& c) { return a.error < c.error; });
      start_bone(mesh_, static_cast<std::size_t>(worst - supports.begin()), b, bones);
      worst->error = 0.0;
    }
    return any;
  }

 private:
  const RigidBonesJob& job_;
  const MovingMesh& mesh_;

 public:
  BonePoses bones;
  std::vector<Support> supports;
};

Result<void> check(const RigidBonesJob& job) {
  if (job.count < 1) return bad_input("0 bones; expected 1 or more");
  if (job.poses == 0) return bad_input("there is no example pose; expected one or more");
  constexpr std::size_t vertices_a_bone = 4;  // fewer do not tell how it turns
  if (vertices_a_bone * job.count > job.rest.size())
    return bad_input("{} bones are more than can be told apart: there are {} vertices, and each takes {} or more",
                     job.count, job.rest.size(), vertices_a_bone);
  BonePoses any(1, job.poses);
  return SkinFitJob{job.rest, job.posed, job.triangles, any, FitMethod::convex, 1}.validate();
}

}  // namespace

Result<RigidBones> RigidBonesJob::run() const {
  if (auto ok = check(*this); !ok) return pass_on(std::move(ok));
  const MovingMesh mesh{rest, posed, poses};
  auto start = clustered_motions(mesh, count);
  if (!start) return pass_on(std::move(start));
  advance();
  Alternation turn(*this, mesh, std::move(*start));
  RigidBones out;
  double before = INFINITY;
  bool anew = true;
  while (true) {
    // The first choice, one after bones were restarted, and the last are made among all bones.
    anew = anew || out.rounds + 1 >= rounds;
    if (auto ok = turn.fit_weights(anew); !ok) return pass_on(std::move(ok));
    advance();
    const double now = turn.squared_error();
    const bool restarted = out.rounds + 1 < rounds && turn.restart_idle();
    const bool settled = !restarted && before - now <= worth_a_round * before && std::isfinite(before);
    if (++out.rounds >= rounds || (settled && anew)) break;
    anew = restarted || settled;
    before = restarted ? INFINITY : now;
    turn.fit_transforms();
  }
  for (const Support& support : turn.supports) out.influences.add_vertex(weight_run(support));
  out.bones = std::move(turn.bones);
  return out;
}

}  // namespace sinew
