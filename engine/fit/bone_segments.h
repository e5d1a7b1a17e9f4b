#pragma once
/// The lines in a body that its joints move.

#include <span>
#include <vector>

#include "engine/fit/voxel_solid.h"
#include "engine/model/model.h"

namespace sinew {

struct BoneSegment {
  std::uint32_t joint = 0;  ///< index into the skin's joints
  Vec3 from{0.0}, to{0.0};  ///< rest pose

  Vec3 nearest(const Vec3& p) const;
};

/// A segment from each joint of the skin to each of its child joints; a joint without children goes on in its parent's
/// direction, at most as far as the parent's segment is long and the solid reaches. A first joint outside of the
/// solid, such as a root between the feet, has none.
std::vector<BoneSegment> bone_segments(const Model& model, const Skin& skin, const VoxelSolid& solid);

}  // namespace sinew
