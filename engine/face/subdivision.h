#pragma once
/// Catmull-Clark subdivision of a mesh of quads as a matrix, by OpenSubdiv: whatever is given at the coarse points
/// (places, weights, colours) is carried to the fine ones by the same rows.
/// Catmull, Clark 1978; limits: Halstead, Kass, DeRose 1993.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sinew {

using Quad = std::array<std::uint32_t, 4>;

/// A sparse matrix, row after row.
struct SparseRows {
  struct Entry {
    std::uint32_t column;
    double weight;
  };
  std::vector<std::uint32_t> first{0};  ///< [rows + 1]
  std::vector<Entry> entries;           ///< columns rise inside a row

  std::size_t rows() const { return first.size() - 1; }
  std::span<const Entry> row(std::size_t i) const {
    return std::span(entries).subspan(first[i], first[i + 1] - first[i]);
  }
  /// Row i times the values.
  template <class Value>
  Value times(std::size_t i, std::span<const Value> values) const {
    Value sum{0.0};
    for (const Entry& e : row(i)) sum += e.weight * values[e.column];
    return sum;
  }
};

struct Subdivision {
  std::vector<Quad> quads;          ///< of the fine mesh
  std::vector<std::uint32_t> from;  ///< [quads] the coarse quad that each is a piece of
  SparseRows limit;                 ///< fine vertices on the limit surface, from coarse ones
};

/// `level` steps of subdivision; open edges become smooth curves. Quads are wound alike, no edge has more than two.
Subdivision subdivide(std::size_t vertices, std::span<const Quad> quads, int level);

}  // namespace sinew
