#pragma once
#include <cstddef>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

/// Where the bones of a skin stand in the example poses.
struct BonePoses {
  std::size_t bones = 0, poses = 0;
  std::vector<Mat34> transforms;  ///< [bones * poses] final transforms F_{b,k} = C_{b,k} B_b, bone after bone

  BonePoses() = default;
  BonePoses(std::size_t bone_count, std::size_t pose_count)
      : bones(bone_count), poses(pose_count), transforms(bone_count * pose_count) {}

  Mat34& at(std::size_t bone, std::size_t pose) { return transforms[bone * poses + pose]; }
  const Mat34& at(std::size_t bone, std::size_t pose) const { return transforms[bone * poses + pose]; }
};

}  // namespace sinew
