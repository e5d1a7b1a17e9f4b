#include "engine/fit/bone_segments.h"

#include "engine/rig/joint_tree.h"
#include "engine/rig/pose.h"

namespace sinew {
namespace {

/// Where the line from `from` along `direction` (unit) leaves the solid, at most `longest` away.
Vec3 end_in_solid(const VoxelSolid& solid, const Vec3& from, const Vec3& direction, double longest) {
  const double step = 0.5 * solid.size;
  double reached = 0.0;
  while (reached + step <= longest && solid.solid(from + (reached + step) * direction)) reached += step;
  return from + reached * direction;
}

}  // namespace

Vec3 BoneSegment::nearest(const Vec3& p) const {
  const Vec3 along = to - from;
  const double squared = glm::dot(along, along);
  return squared > 0.0 ? from + std::clamp(glm::dot(p - from, along) / squared, 0.0, 1.0) * along : from;
}

std::vector<BoneSegment> bone_segments(const Model& model, const Skin& skin, const VoxelSolid& solid) {
  const std::vector<Mat4> global = global_transforms(model, hierarchy_order(model), rest_pose(model));
  const JointTree tree(model, global);
  std::vector<BoneSegment> segments;
  for (std::uint32_t j = 0; j < skin.joints.size(); ++j) {
    const int node = skin.joints[j];
    const Vec3 at = tree.position(node);
    int above = tree.parent(node);
    while (above >= 0 && !tree.is_joint(above)) above = tree.parent(above);
    if (above < 0 && !solid.solid(at)) continue;
    for (const int child : tree.child_joints(node)) segments.push_back({j, at, tree.position(child)});
    if (!tree.child_joints(node).empty()) continue;
    while (above >= 0 && !(tree.is_joint(above) && tree.distance(node, above) > 0.0)) above = tree.parent(above);
    const double length = above < 0 ? 0.0 : tree.distance(node, above);
    const Vec3 direction = above < 0 ? Vec3(0.0) : unit_or(at - tree.position(above), Vec3(0.0));
    segments.push_back({j, at, end_in_solid(solid, at, direction, length)});
  }
  return segments;
}

}  // namespace sinew
