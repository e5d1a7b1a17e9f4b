#include "engine/fit/automatic_weights.h"

#include <algorithm>
#include <chrono>
#include <set>

#include "engine/core/interrupt.h"
#include "engine/fit/heat_weights.h"
#include "engine/fit/nearest_bones.h"
#include "engine/fit/weight_run.h"
#include "engine/rig/humanoid.h"
#include "engine/rig/pose.h"

namespace sinew {
namespace {

/// A vertex farther from its bone than this share of the height is reported.
constexpr double far_share = 0.2;

struct Nearest {
  std::vector<std::uint32_t> joint;  ///< [vertices]
  std::vector<double> distance;      ///< [vertices] straight, at least half a voxel
};

/// Which joints of the skin hang from which.
class Kinship {
 public:
  Kinship(const Model& model, const Skin& skin) : model_(model), skin_(skin) {}

  /// One of the two is the other or hangs from it.
  bool in_line(std::uint32_t a, std::uint32_t b) const {
    return below(skin_.joints[a], skin_.joints[b]) || below(skin_.joints[b], skin_.joints[a]);
  }
  /// The node is the other one or hangs from it.
  bool below(int node, int top) const {
    for (; node >= 0; node = model_.nodes[node].parent)
      if (node == top) return true;
    return false;
  }

 private:
  const Model& model_;
  const Skin& skin_;
};

/// Leaves the `most` largest, each less what the largest of the others has, or `least` where that is more: as two
/// joints change places in the order both are at 0, so that the weights of neighbours differ no more than they did.
void keep_largest(std::vector<Influence>& weights, std::size_t most, double least) {
  std::sort(weights.begin(), weights.end(), [](const Influence& a, const Influence& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
  });
  double sum = 0.0;
  for (const Influence& influence : weights) sum += influence.weight;
  double cut = least * sum;
  if (weights.size() > most) {
    cut = std::max(cut, weights[most].weight);
    weights.resize(most);
  }
  // Nothing would be left of equal weights; they are too many for any choice among them to be smooth.
  if (!weights.empty() && cut > 0.999 * weights.front().weight) return;
  for (Influence& influence : weights) influence.weight = std::max(influence.weight - cut, 0.0);
}

/// Joints that shall move nothing: those that were named and, in a humanoid, those that do not hang from the hips,
/// which are handles of the rig.
Result<std::set<std::uint32_t>> left_out_joints(const Model& model, const std::vector<std::string>& names) {
  std::set<std::uint32_t> out;
  const Humanoid humanoid = find_humanoid(model, global_transforms(model, hierarchy_order(model), rest_pose(model)));
  const std::vector<int>& joints = model.skins[0].joints;
  if (humanoid.complete()) {
    const Kinship kinship(model, model.skins[0]);
    for (std::uint32_t j = 0; j < joints.size(); ++j)
      if (!kinship.below(joints[j], humanoid.find(HumanoidBone::hips))) out.insert(j);
  }
  for (const std::string& name : names) {
    const auto node = find_joint(model, humanoid, name);
    if (!node) return tl::unexpected<Error>(node.error());
    const auto found = std::find(joints.begin(), joints.end(), *node);
    if (found == joints.end()) return bad_input("{}: \"{}\" is no joint of the skin", model.file, name);
    out.insert(static_cast<std::uint32_t>(found - joints.begin()));
  }
  return out;
}

Result<Nearest> find_nearest(const std::string& file, const SkinnedShape& shape, const VoxelSolid& solid,
                             const std::vector<BoneSegment>& segments, const StopCheck& check) {
  const auto reached = nearest_bones(solid, segments, check);
  if (!reached) return tl::unexpected<Error>(reached.error());
  Nearest nearest;
  for (const Vec3& p : shape.positions) {
    const auto number = static_cast<std::size_t>((*reached)[solid.cell(p)]);
    if (number >= segments.size())
      return bad_input(
          "{}: no bone reaches the vertex at {:.4g}, {:.4g}, {:.4g}; mesh and skeleton should have one place "
          "and size",
          file, p.x, p.y, p.z);
    const BoneSegment& segment = segments[number];
    nearest.joint.push_back(segment.joint);
    nearest.distance.push_back(std::max(glm::length(p - segment.nearest(p)), 0.5 * solid.size));
  }
  return nearest;
}

/// Takes from a vertex what spread into it from another limb: a joint out of line with the vertex's main joint keeps
/// its weight where it is half as large as the main one and more, and loses it all at a quarter and less.
void part_limbs(const Kinship& kinship, std::vector<Influence>& weights) {
  if (weights.empty()) return;
  const Influence main = *std::max_element(weights.begin(), weights.end(), [](const Influence& a, const Influence& b) {
    return a.weight != b.weight ? a.weight < b.weight : a.joint > b.joint;
  });
  for (Influence& influence : weights)
    if (!kinship.in_line(influence.joint, main.joint))
      influence.weight *= smoothstep01(4.0 * influence.weight / main.weight - 1.0);
}

void report_joints(const Model& model, const Influences& influences, const VoxelSolid& solid,
                   const std::vector<BoneSegment>& segments, const std::set<std::uint32_t>& left_out,
                   AutomaticWeightReport& report) {
  const std::vector<int>& joints = model.skins[0].joints;
  std::vector<char> inside(joints.size()), used(joints.size());
  for (const BoneSegment& segment : segments)
    if (solid.solid(segment.from) || solid.solid(segment.to)) inside[segment.joint] = 1;
  for (const Influence& influence : influences.entries) used[influence.joint] = 1;
  for (std::uint32_t j = 0; j < joints.size(); ++j) {
    if (left_out.contains(j)) continue;
    if (!inside[j]) report.outside.push_back(model.nodes[joints[j]].name);
    if (inside[j] && !used[j]) report.idle.push_back(model.nodes[joints[j]].name);
  }
}

void report_far(const Model& model, const SkinnedShape& shape, const Nearest& nearest, AutomaticWeightReport& report) {
  Bounds bounds;
  for (const Vec3& p : shape.positions) bounds.add(p);
  const Vec3 size = bounds.high - bounds.low;
  report.height = std::max({size.x, size.y, size.z});
  for (std::size_t v = 0; v < nearest.distance.size(); ++v) {
    report.far += nearest.distance[v] > far_share * report.height ? 1 : 0;
    if (nearest.distance[v] <= report.farthest_distance) continue;
    report.farthest_distance = nearest.distance[v];
    report.farthest = v;
  }
  report.farthest_mesh = model.meshes[shape.part_of(report.farthest).mesh].name;
}

/// Whether any bone begins or ends in the mesh's box.
bool any_lies_near(const std::vector<BoneSegment>& segments, const SkinnedShape& shape) {
  Bounds box;
  for (const Vec3& p : shape.positions) box.add(p);
  const auto inside = [&](const Vec3& p) {
    return glm::all(glm::greaterThanEqual(p, box.low)) && glm::all(glm::lessThanEqual(p, box.high));
  };
  return std::ranges::any_of(segments, [&](const BoneSegment& s) { return inside(s.from) || inside(s.to); });
}

}  // namespace

Result<AutomaticWeightReport> set_automatic_weights(const AutomaticWeightOptions& options, Model& model) {
  const auto start = std::chrono::steady_clock::now();
  const SkinnedShape shape = skinned_shapes(model).front();
  if (shape.triangles.empty())
    return bad_input("{}: has vertices and no triangles; weights spread over a surface", model.file);
  const Skin& skin = model.skins[0];
  const auto left_out = left_out_joints(model, options.left_out);
  if (!left_out) return tl::unexpected<Error>(left_out.error());
  TaskWatch unwatched;
  TaskWatch& watch = options.watch != nullptr ? *options.watch : unwatched;
  const StopCheck check = [&watch]() -> Result<void> {
    if (auto ok = watch.check(); !ok) return ok;
    return check_interrupt();
  };
  constexpr std::size_t steps_before = 2;
  watch.begin(steps_before + skin.joints.size());
  const VoxelSolid solid = voxel_solid(shape.positions, shape.triangles, options.resolution);
  std::vector<BoneSegment> segments = bone_segments(model, skin, solid);
  std::erase_if(segments, [&](const BoneSegment& segment) { return left_out->contains(segment.joint); });
  if (segments.empty() || !any_lies_near(segments, shape))
    return bad_input("{}: no joint of the skeleton lies in it; expected both in the same place and size", model.file);
  watch.advance();
  const auto nearest = find_nearest(model.file, shape, solid, segments, check);
  if (!nearest) return tl::unexpected<Error>(nearest.error());

  HeatJob heat{shape.positions, shape.triangles, nearest->joint, nearest->distance,
               static_cast<std::uint32_t>(skin.joints.size())};
  Progress progress("spreading weights", skin.joints.size(), options.progress);
  watch.advance();
  heat.check = check;
  heat.advance = [&] {
    progress.advance();
    watch.advance();
  };
  auto spread = heat.run();
  if (!spread) return failure(spread.error().kind, "{}: {}", model.file, spread.error().message);
  const Kinship kinship(model, skin);
  Influences influences;
  for (std::vector<Influence>& weights : *spread) {
    part_limbs(kinship, weights);
    keep_largest(weights, options.influences, options.prune);
    influences.add_vertex(weight_run(std::move(weights), options.influences, options.prune));
  }

  AutomaticWeightReport report;
  report.vertices = shape.positions.size();
  report.joints = skin.joints.size();
  report.max_influences = most_influences(influences);
  report_joints(model, influences, solid, segments, *left_out, report);
  report_far(model, shape, *nearest, report);
  set_influences(shape, influences, model);
  report.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace sinew
