#pragma once
/// What the places of a mesh take from the template's face: shares of the jaw and moves by signal.

#include <functional>
#include <vector>

#include "engine/face/face_mesh.h"
#include "engine/face/template_fit.h"
#include "engine/model/face.h"

namespace sinew {

class SkinValues {
 public:
  /// `scale`: of each signal, which its moves are divided by.
  SkinValues(const FaceRig& from, const TemplateFit& fit, const FaceMesh& mesh,
             const std::function<double(std::size_t signal)>& scale);

  /// Places that answer to none of the template's, in mouth and nostrils, take the mean of their neighbours; places
  /// that lie beside the place that they answer to are smoothed by how far. What is far from the template stays.
  void fill();
  /// Brows and lashes take what the skin under them has, what is inside the mouth stays or goes with the jaw.
  void carry_small_parts();

  double jaw(std::size_t place) const { return values_[place * width]; }
  double jaw_sealed(std::size_t place) const { return values_[place * width + 1]; }
  std::vector<FaceDelta> deltas(std::size_t place) const;
  /// Where a place of a small part stands on the skin; other places are their own.
  const Vec3& root(std::size_t place) const { return roots_[place]; }

 private:
  static constexpr std::size_t width = 2 + 3 * face_signals;
  void relax(const std::vector<std::uint32_t>& places, const std::vector<double>& shares, int rounds);

  const FaceMesh& mesh_;
  const TemplateFit& fit_;
  std::vector<double> values_;  ///< [places * width]
  std::vector<Vec3> roots_;
};

}  // namespace sinew
