#pragma once
/// What a skinning job writes, and the check of its spans that all skinning jobs share.

#include <span>

#include "engine/core/math.h"
#include "engine/core/result.h"
#include "engine/model/model.h"

namespace sinew {

/// Where the skinned vertices go.
struct SkinOutput {
  std::span<Vec3> positions;  ///< [vertices]
  std::span<Vec3> normals;    ///< [vertices] unit length
  std::span<Mat3> blend;      ///< [vertices] the 3x3 that carried each vertex, or empty where nobody asks
};

/// What a skinning job reads.
struct SkinInput {
  std::span<const Vec3> positions;  ///< [vertices] bind pose, morphs added
  std::span<const Vec3> normals;    ///< [vertices] bind pose, morphs added, any length but 0
  std::span<const Mat34> palette;   ///< [joints] final transforms F_i = C_i B_i
  const Influences& influences;     ///< [vertices] indices into `palette`
};

/// Says which span is short, or which vertex names a joint that the palette does not have.
Result<void> validate_skinning(const SkinInput& input, const SkinOutput& output);

/// Carries a normal by the inverse transpose of `blend`, unit length: n' = unit(A^-T n), engine/definitions.md 6.
/// Where `blend` is singular the direction that its cofactors give is kept.
Vec3 carry_normal(const Mat3& blend, const Vec3& normal);

/// Carries a tangent, w the side of its bitangent, by `blend` itself, as whatever lies in the surface: t' = A t. The
/// length is kept; a mirroring `blend` changes the side.
Vec4 carry_tangent(const Mat3& blend, const Vec4& tangent);

/// The part of a tangent in the plane of the unit vector `normal`, unit length; zero where there is none.
Vec4 tangent_in_plane(const Vec4& tangent, const Vec3& normal);

}  // namespace sinew
