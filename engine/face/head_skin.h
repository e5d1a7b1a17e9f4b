#pragma once
/// The skin of a whole head: the half cage mirrored and subdivided. Which vertices there are, and how they hang
/// together, is the same for all measures.

#include <span>
#include <vector>

#include "engine/face/head_cage.h"
#include "engine/face/subdivision.h"

namespace sinew {

/// Numbers, on the half cage, of everything that the skin needs to know about its points.
using CageValues = std::vector<double>;

class HeadTopology {
 public:
  /// `level` steps of subdivision, 0 to 4.
  explicit HeadTopology(int level);

  std::size_t vertices() const { return mirror_.size(); }
  /// Vertices of the left half and the mid line stand first.
  std::size_t half_vertices() const { return half_.rows(); }
  const std::vector<Quad>& quads() const { return quads_; }
  const std::vector<SkinKind>& kinds() const { return kinds_; }         ///< [quads]
  const std::vector<std::uint32_t>& mirror() const { return mirror_; }  ///< [vertices] the same place on the other side
  bool on_mid_line(std::size_t v) const { return mirror_[v] == v; }
  /// The vertex that stands where this cage point is drawn to.
  std::uint32_t vertex_of(const CagePoint& point) const { return of_cage_[cage_.index(point)]; }
  const HeadCage& cage() const { return cage_; }  ///< the adult's: names and indices hold for every head

  /// [vertices] Places of a half cage's skin, mirrored: exactly symmetric.
  std::vector<Vec3> positions(const std::vector<Vec3>& half_cage) const;
  /// [vertices] Values given on the left half of the cage and 0 on the right; on the mid line they count for both.
  std::vector<double> left_values(const CageValues& half_cage) const;
  /// [vertices] The same, given on both halves alike.
  std::vector<double> even_values(const CageValues& half_cage) const;

  /// The cage points moved so that the skin passes through those of features, and near the others: plain subdivision
  /// would thin lids and lips; exact interpolation everywhere would ripple.
  std::vector<Vec3> fitted(const std::vector<Vec3>& half_cage) const;

 private:
  std::vector<Vec3> whole(const std::vector<Vec3>& half_cage) const;
  std::vector<double> values(const std::vector<double>& whole_cage) const;

  HeadCage cage_;
  std::size_t whole_cage_ = 0;
  std::vector<std::uint32_t> cage_mirror_;  ///< [half cage] index of the mirrored point in the whole cage
  SparseRows coarse_limit_;                 ///< half cage points on the limit, from the whole cage
  SparseRows half_;                         ///< half_vertices() rows over the whole cage
  std::vector<Quad> quads_;
  std::vector<SkinKind> kinds_;
  std::vector<std::uint32_t> mirror_, of_cage_;
};

}  // namespace sinew
