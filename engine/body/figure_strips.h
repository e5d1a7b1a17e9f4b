#pragma once
/// Refinement of a quad mesh strip by strip: a strip of quads, each beside the next, is cut lengthwise into equal parts
/// from end to end, so that quads stay quads and loops stay loops.

#include <array>
#include <span>
#include <vector>

#include "engine/body/figure_cage.h"

namespace sinew {

using Quads = std::vector<std::array<Index, 4>>;

/// A new vertex: a weighted mean of the four corners of an old quad.
struct Stencil {
  std::array<Index, 4> corner{};
  std::array<double, 4> weight{};

  template <class T>
  T of(std::span<const T> values) const {
    T sum = weight[0] * values[corner[0]];
    for (std::size_t i = 1; i < 4; ++i) sum += weight[i] * values[corner[i]];
    return sum;
  }
};

struct RefinedQuads {
  std::vector<Stencil> vertices;  ///< the old vertices first, in their order
  Quads quads;                    ///< quad by quad of the old mesh
};

/// Which strip crosses each edge.
class Strips {
 public:
  explicit Strips(const Quads& quads);

  std::size_t count() const { return count_; }
  std::size_t of(Index a, Index b) const;
  /// [strips] mean length of the edges that the strip crosses, times their vertices' detail.
  std::vector<double> weighted_lengths(const HalfCage& cage) const;

 private:
  std::vector<std::pair<CageEdge, std::size_t>> strip_;  ///< by edge, rising
  std::size_t count_ = 0;
};

/// `parts`: [strips] into how many parts each is cut. `vertices`: of the old mesh. The old mesh's strips may have been
/// found on another one with the same quads in the same order whose vertices are fewer, `welded`: [vertices] of those.
RefinedQuads refine_strips(const Quads& quads, std::span<const Index> welded, const Strips& strips,
                           std::span<const int> parts);

/// How many quads a mesh of `quads` has after refinement.
std::size_t refined_quad_count(const Quads& quads, const Strips& strips, std::span<const int> parts);

/// Cuts for about `wanted` quads, long strips first; never more than `wanted` unless the mesh itself has.
std::vector<int> parts_for(const Quads& quads, const Strips& strips, std::span<const double> lengths,
                           std::size_t wanted);

}  // namespace sinew
