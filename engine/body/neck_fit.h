#pragma once
/// Fitting a head's neck to the neck of a figure that was cut open.

#include "engine/body/figure_build.h"
#include "engine/body/figure_field.h"
#include "engine/body/neck_cut.h"
#include "engine/face/head.h"

namespace sinew {

/// The border of a figure's skin as a curve round the neck's axis: 0 at the front, rising towards the figure's left.
class NeckBorder {
 public:
  NeckBorder(const Primitive& skin, const std::vector<BorderEdge>& edges);

  /// Radians of p about the axis, in (-pi, pi].
  double angle(const Vec3& p) const;
  struct Place {
    Vec3 position;
    std::uint32_t from, to;  ///< the skin's vertices between which it lies
    double share;            ///< of the way
  };
  Place at(double angle) const;
  /// Edges by rising angle, the first begins at the back.
  const std::vector<BorderEdge>& edges() const { return edges_; }

 private:
  const Primitive& skin_;
  std::vector<BorderEdge> edges_;
  Vec3 centre_{0.0};
};

/// A head on its way onto a figure.
struct NeckFit {
  std::vector<std::uint32_t> ring;  ///< the head's lowest ring, by rising angle, the first at the back
  /// [skin vertices of the head] 0 on the lowest ring to 1 at the jaw and above: how much it is the head's own.
  std::vector<double> share;
};

/// Moves the head's neck onto the figure's surface, whole at its lowest ring and less and less up to the jaw, and drops
/// the head's skin below that ring. `origin`: of the head's drawing units, metres; normals are made anew.
NeckFit fit_neck(const BuiltFigure& figure, const BodyField& field, const NeckBorder& border, const Vec3& origin,
                 int level, Head& head);

}  // namespace sinew
