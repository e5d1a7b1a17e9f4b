#pragma once
/// Cutting a figure's skin open at the neck, where another head is to be put on.

#include <span>
#include <vector>

#include "engine/model/model.h"

namespace sinew {

/// A plane across a neck that falls towards the front.
struct NeckPlane {
  Vec3 point{0.0};
  double fall = 0.0;  ///< metres down a metre forward

  /// Vertical distance of p above the plane.
  double above(const Vec3& p) const { return p.y - point.y + fall * (p.z - point.z); }
};

/// One edge of the skin's new border, as vertices of it; seen from above it runs counter-clockwise: from the front to
/// the figure's left.
struct BorderEdge {
  std::uint32_t from, to;
};

/// Takes away what of the skin lies above the plane; triangles that it crosses are cut, their vertices' attributes
/// linear along the edges. Returns the border. Positions, normals, texture coordinates and influences are kept.
std::vector<BorderEdge> cut_above(const NeckPlane& plane, Primitive& skin);

/// Influences between two vertices', `share` of the way; the four largest, as a vertex keeps them.
std::vector<Influence> mixed_influences(std::span<const Influence> one, std::span<const Influence> other, double share);

}  // namespace sinew
