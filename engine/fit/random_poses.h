#pragma once
/// Poses at random angles, for examples of how a character moves.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/rig/pose.h"

namespace sinew {

/// Numbers that are the same for a seed on every machine.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}
  double uniform();  ///< 0 <= x < 1
  double normal();   ///< mean 0, variance 1

 private:
  std::uint64_t state_;  ///< SplitMix64: Steele, Lea and Flood 2014
};

/// The rest pose with every one of `joints` (nodes) turned at random within its limits about the body's left, up and
/// front: those of its humanoid bone (engine/definitions.md 16), 25 degrees to either side for others.
std::vector<Pose> random_poses(const Model& model, std::span<const int> joints, std::size_t count,
                               RandomNumbers& random);

}  // namespace sinew
