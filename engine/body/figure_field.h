#pragma once
/// The surface of a measured body as the zero set of a field: the smooth union of its parts (engine/definitions.md 11).

#include "engine/body/figure_measures.h"
#include "engine/core/math.h"

namespace sinew {

class BodyField {
 public:
  /// `body` outlives the field.
  explicit BodyField(const MeasuredBody& body);

  /// Signed distance, true to first order near the surface, and gradient. Both halves of the body: x is mirrored.
  FieldSample at(const Vec3& p) const;

  /// Moves p by one step towards the surface, at most 0.012 far, and returns the outward direction there.
  Vec3 step_to_surface(Vec3& p) const;

 private:
  FieldSample node_at(int node, const Vec3& p) const;

  const MeasuredBody& body_;
  std::vector<Bounds> reach_;  ///< [parts] outside it a part is too far away to matter
};

}  // namespace sinew
