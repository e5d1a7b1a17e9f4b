#pragma once
/// Turn, scale and move: how one head stands to another.

#include <span>

#include "engine/core/math.h"

namespace sinew {

struct Similarity {
  double scale = 1.0;
  Mat3 rotation{1.0};
  Vec3 translation{0.0};

  Vec3 point(const Vec3& p) const { return scale * (rotation * p) + translation; }
  Vec3 direction(const Vec3& d) const { return rotation * d; }
  Similarity inverse() const;
  Mat4 matrix() const;
};

/// The one that brings `from` nearest to `to` in the sum of squares. Umeyama 1991. At least three places that are on no
/// line.
Similarity best_similarity(std::span<const Vec3> from, std::span<const Vec3> to);

}  // namespace sinew
