#pragma once
/// Weights that spread over a surface like heat.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/core/interrupt.h"
#include "engine/core/task_watch.h"
#include "engine/model/model.h"

namespace sinew {

/// Heat flows from the bone nearest to each vertex and spreads along the surface, the farther the deeper the bone lies:
/// `(L + M / d^2) w = (M / d^2) p`, L the cotangent Laplacian, M the vertices' areas, p 1 where a bone is nearest.
/// Baran and Popovic, *Automatic Rigging and Animation of 3D Characters*, 2007, section 4. Vertices at the very same
/// place are one; negative cotangents count 0, so that no weight leaves 0..1.
struct HeatJob {
  std::span<const Vec3> positions;           ///< [vertices]
  std::span<const std::uint32_t> triangles;  ///< three vertex indices a triangle
  std::span<const std::uint32_t> bone;       ///< [vertices] the nearest
  std::span<const double> distance;          ///< [vertices] to it, > 0
  std::uint32_t bones = 0;
  std::function<void()> advance = [] {};  ///< called `bones` times
  StopCheck check = check_interrupt;      ///< asked now and then

  /// The weights, [vertices], all that are not lost in rounding, in no order. Fails as interrupted.
  Result<std::vector<std::vector<Influence>>> run() const;
};

}  // namespace sinew
