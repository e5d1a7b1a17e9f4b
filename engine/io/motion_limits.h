#pragma once
/// What a motion file may ask for: more than any body has, less than hurts.

#include <cstddef>

namespace sinew {

constexpr std::size_t largest_motion_file = std::size_t{512} << 20;  ///< bytes
constexpr std::size_t most_motion_joints = 4096;
constexpr std::size_t deepest_motion_joint = 256;                        ///< joints above one another
constexpr std::size_t most_joint_frames = std::size_t{1} << 24;          ///< joints times frames: 512 MiB of rotations
constexpr double shortest_frame_time = 1e-5, longest_frame_time = 60.0;  ///< seconds

}  // namespace sinew
