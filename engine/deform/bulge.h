#pragma once
#include <span>

#include "engine/core/math.h"
#include "engine/core/result.h"
#include "engine/deform/muscle_region.h"

namespace sinew {

/// A muscle at work in one pose.
struct ActiveMuscle {
  const Muscle& muscle;
  const MuscleRegion& region;
  double activation = 0.0;  ///< delta of engine/definitions.md 6
};

/// The projection-plane Gaussian muscle bulge on top of a skinned mesh: v' += h n', h = delta peak g f, and the normals
/// of the swollen surface to first order. engine/definitions.md 3 and 6; Lin 2009. Vertices outside every region keep
/// their bits.
struct BulgeJob {
  std::span<const ActiveMuscle> muscles;
  BulgeMode mode = BulgeMode::on;
  std::span<const Vec3> bind_normals;        ///< [vertices] n: bind pose, morphs added
  std::span<const Mat3> rest_blend;          ///< [vertices] A0: the blend at rest
  std::span<const Mat3> blend;               ///< [vertices] A: the blend that carried the vertices
  std::span<Vec3> positions;                 ///< [vertices] skinned in, swollen out
  std::span<Vec3> normals;                   ///< [vertices] n' in, the swollen surface's out
  std::span<double> heights;                 ///< [vertices] out: h, 0 outside the regions
  std::span<const Vec4> bind_tangents = {};  ///< [vertices] t: bind pose; or empty
  std::span<Vec4> tangents = {};             ///< [bind_tangents] A t in, A t + (grad h . A0 t) n' out; w stays

  /// Says which span is short.
  Result<void> validate() const;
  void run() const;
};

}  // namespace sinew
