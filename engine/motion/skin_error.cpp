#include "engine/motion/skin_error.h"

#include <algorithm>

#include "engine/core/parallel.h"
#include "engine/deform/ssd.h"
#include "engine/model/character_mesh.h"
#include "engine/motion/curve_clip.h"
#include "engine/rig/clip_sampling.h"
#include "engine/rig/motion_rig.h"
#include "engine/rig/retarget.h"

namespace sinew {
namespace {

struct Skinned {
  std::vector<Vec3> positions, normals;
};

Skinned skinned(const Model& figure, const CharacterMesh& mesh, std::span<const int> order, const Clip& clip,
                double seconds) {
  Pose pose = rest_pose(figure);
  sample_clip(clip, seconds, pose);
  const std::vector<Mat34> palette = palette_transforms(mesh, global_transforms(figure, order, pose));
  Skinned skin{std::vector<Vec3>(mesh.vertices()), std::vector<Vec3>(mesh.vertices())};
  SsdJob{{mesh.positions, mesh.normals, palette, mesh.influences}, {skin.positions, skin.normals, {}}}.run();
  return skin;
}

}  // namespace

Result<double> skin_error_mm(const Model& figure, const Motion& a, const Motion& b) {
  const std::vector<int> order = hierarchy_order(figure);
  const Humanoid humanoid = find_humanoid(figure, global_transforms(figure, order, rest_pose(figure)));
  RetargetOptions options;
  options.lift_feet = false;
  const auto first = retarget(a, figure, humanoid, options);
  if (!first) return tl::unexpected<Error>(first.error());
  const auto second = retarget(b, figure, humanoid, options);
  if (!second) return tl::unexpected<Error>(second.error());
  const CharacterMesh mesh = character_mesh(figure);
  const std::size_t frames = std::min(a.frames.size(), b.frames.size());
  std::vector<double> largest(frames, 0.0);
  parallel_for(
      frames,
      [&](std::size_t i) {
        const double t = static_cast<double>(i) * a.frame_time;
        const Skinned left = skinned(figure, mesh, order, first->clip, t);
        const Skinned right = skinned(figure, mesh, order, second->clip, t);
        for (std::size_t v = 0; v < left.positions.size(); ++v)
          largest[i] = std::max(largest[i], glm::length(left.positions[v] - right.positions[v]));
      },
      1);
  return 1000.0 * *std::max_element(largest.begin(), largest.end());
}

double joint_error_mm(const Motion& a, const Motion& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.frames.size(), b.frames.size()); ++i)
    largest = std::max(largest, largest_joint_distance(a.skeleton, a.frames[i], b.frames[i]));
  return 1000.0 * motion_rig(a).metres_per_unit * largest;
}

}  // namespace sinew
