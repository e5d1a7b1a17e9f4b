#pragma once
/// The opening between the lids of any eye, found by looking out of it.

#include <array>
#include <vector>

#include "engine/face/face_mesh.h"

namespace sinew {

/// Along the eye, inner to outer corner, the angles about the line through the eyeball's centre along x at which its
/// lids begin; radians, 0 straight ahead, up positive.
class LidOpening {
 public:
  /// Looks out between the skin's triangles; where landmarks name the lids' edges, what lies far from them is no lid.
  LidOpening(const FaceMesh& mesh, const TriangleTree& skin, int side);

  bool open() const { return open_; }  ///< false: closed or painted, nothing can shut
  /// How a place turns when the lids shut: radians about x, upper and lower.
  std::array<double, 2> closing(const Vec3& place) const;

 private:
  double upper(double along) const { return at(upper_, along); }
  double lower(double along) const { return at(lower_, along); }
  static double at(const std::vector<double>& values, double along);

  Vec3 centre_, inner_, outer_;
  double radius_, fold_;  ///< fold_: angle above the upper lid at which nothing moves any more
  bool open_ = false;
  std::vector<double> upper_, lower_;
};

}  // namespace sinew
