#pragma once
/// Where a model's feet meet the floor.

#include <span>
#include <vector>

#include "engine/core/math.h"
#include "engine/model/model.h"
#include "engine/rig/humanoid.h"

namespace sinew {

/// The points that a model stands on: vertices under the feet, near the lowest of the rest pose, with their skin; of a
/// model without a mesh the feet's joints, taken to stand on the floor in the rest pose.
class FootContact {
 public:
  /// `rest_global`: [nodes] global rest transforms.
  FootContact(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global);

  bool empty() const { return points_.empty(); }
  /// The height of the floor under the rest pose: its lowest vertex.
  double floor() const { return floor_; }
  /// How high the lowest of the points stands over the floor; negative: it has sunk. `global`: [nodes].
  double height(std::span<const Mat4> global) const;

 private:
  struct Follow {
    int node = -1;
    Vec4 row{0.0};  ///< weight times the bind-pose place in the node's frame: the node's matrix takes it to the world
  };
  using Point = std::vector<Follow>;

  std::vector<Point> points_;
  double floor_ = 0.0;
};

/// How far each frame has to be lifted so that nothing sinks, without jerks: 0 where `heights` stays far from the
/// floor. [frames] of heights over the floor, negative where sunk. The lift begins and ends `reach` frames around the
/// sunk ones and is at least what they need.
std::vector<double> smooth_lift(std::span<const double> heights, std::size_t reach);

}  // namespace sinew
