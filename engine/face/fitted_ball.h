#pragma once
/// A sphere through points.

#include <vector>

#include "engine/core/math.h"

namespace sinew {

struct FittedBall {
  Vec3 centre{0.0};
  double radius = 0.0, error = INFINITY;  ///< root mean square of the distances from the sphere, over the radius
};

/// |p - c|^2 = r^2 in least squares. At least four points.
FittedBall fitted_ball(const std::vector<Vec3>& points);

}  // namespace sinew
