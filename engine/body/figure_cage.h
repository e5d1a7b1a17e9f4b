#pragma once
/// The coarse cage of quads that gives a figure its topology: loops round limbs, fingers and toes, on the left half of
/// the body (engine/definitions.md 11). Lengths are fractions of body height.

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "engine/body/figure_measures.h"

namespace sinew {

/// What a vertex was made as a part of: its skin follows the joints of that chain.
enum class Chain : std::uint8_t {
  trunk,
  head,
  arm,
  palm,
  finger1,
  finger2,
  finger3,
  finger4,
  finger5,
  leg,
  foot,
  toe1,
  toe2,
  toe3,
  toe4,
  toe5,
};
constexpr std::size_t chain_count = 16;

/// The chain of finger or toe `number`, 1 (thumb, big toe) to 5.
constexpr Chain finger_chain(int number) { return static_cast<Chain>(static_cast<int>(Chain::finger1) + number - 1); }
constexpr Chain toe_chain(int number) { return static_cast<Chain>(static_cast<int>(Chain::toe1) + number - 1); }
constexpr bool is_finger(Chain chain) { return chain >= Chain::finger1 && chain <= Chain::finger5; }
constexpr bool is_toe(Chain chain) { return chain >= Chain::toe1; }

using Index = std::uint32_t;
using Loop = std::vector<Index>;
using CageEdge = std::pair<Index, Index>;  ///< the smaller index first

inline CageEdge cage_edge(Index a, Index b) { return a < b ? CageEdge{a, b} : CageEdge{b, a}; }

struct CageVertex {
  Vec3 position{0.0};
  bool placed = false;    ///< else it lies where its neighbours' mean is
  bool on_plane = false;  ///< on the plane of symmetry
  Chain chain = Chain::trunk;
  double looseness = 0.5;  ///< share of the way to the neighbours' mean that a round of relaxation takes it
  double detail = 1.0;     ///< how many times finer than by its length alone the mesh is to be cut here
  bool anchored = false;   ///< kept at `station` along `axis`, so that its ring stays plane
  Vec3 axis{0.0};
  double station = 0.0;
};

struct HalfCage {
  std::vector<CageVertex> vertices;
  std::vector<std::array<Index, 4>> quads;  ///< counter-clockwise seen from outside
  std::set<CageEdge> seams;                 ///< where texture coordinates break

  Index add(const Vec3& position, Chain chain, double looseness);
  Index add_unplaced(Chain chain, double looseness);
  void anchor(Index vertex, const Vec3& axis, double station);
  /// Closes the band between two loops, or, not `closed`, between two lines.
  void bridge(const Loop& near, const Loop& far, bool closed = true);
  /// Closes the end of a finger or toe: a loop of six by two quads.
  void cap_six(const Loop& loop);
  /// A seam along the line of vertices.
  void cut(std::span<const Index> line);
  const Vec3& at(Index vertex) const { return vertices[vertex].position; }
};

/// The cage, every vertex placed on or near the surface.
HalfCage figure_cage(const MeasuredBody& body);

}  // namespace sinew
