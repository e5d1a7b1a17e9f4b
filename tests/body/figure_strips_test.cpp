#include "engine/body/figure_strips.h"

#include <numeric>

#include <gtest/gtest.h>

namespace sinew {
namespace {

/// Two quads side by side: three strips, one of which crosses both.
///   3 - 4 - 5
///   |   |   |
///   0 - 1 - 2
const Quads two_quads{{0, 1, 4, 3}, {1, 2, 5, 4}};

std::vector<Index> all(std::size_t count) {
  std::vector<Index> out(count);
  std::iota(out.begin(), out.end(), Index{0});
  return out;
}

TEST(FigureStrips, OppositeEdgesBelongTogether) {
  const Strips strips(two_quads);
  EXPECT_EQ(strips.count(), 3u);
  EXPECT_EQ(strips.of(0, 1), strips.of(3, 4));
  EXPECT_EQ(strips.of(0, 3), strips.of(5, 2));
  EXPECT_NE(strips.of(0, 1), strips.of(1, 2));
}

TEST(FigureStrips, RefinementShareEdgesAndKeepsTheSide) {
  const Strips strips(two_quads);
  std::vector<int> parts(3, 1);
  parts[strips.of(0, 1)] = 3;
  parts[strips.of(0, 3)] = 2;
  const RefinedQuads refined = refine_strips(two_quads, all(6), strips, parts);
  EXPECT_EQ(refined.quads.size(), 3u * 2u + 1u * 2u);
  EXPECT_EQ(refined.vertices.size(), 5u * 3u);
  const std::vector<Vec3> corners{{0, 0, 0}, {3, 0, 0}, {4, 0, 0}, {0, 2, 0}, {3, 2, 0}, {4, 2, 0}};
  for (const auto& quad : refined.quads) {
    std::array<Vec3, 4> p;
    for (std::size_t c = 0; c < 4; ++c) p[c] = refined.vertices[quad[c]].of(std::span<const Vec3>(corners));
    // All are unit squares, counter-clockwise.
    EXPECT_NEAR(glm::cross(p[1] - p[0], p[3] - p[0]).z, 1.0, 1e-12);
    EXPECT_NEAR(glm::distance(p[0], p[2]), std::sqrt(2.0), 1e-12);
  }
}

TEST(FigureStrips, PartsComeCloseAndLongStripsAreCutMore) {
  const Strips strips(two_quads);
  std::vector<double> lengths(3);
  lengths[strips.of(0, 1)] = 3.0;
  lengths[strips.of(1, 2)] = 1.0;
  lengths[strips.of(0, 3)] = 2.0;
  const std::vector<int> parts = parts_for(two_quads, strips, lengths, 1000);
  EXPECT_LE(refined_quad_count(two_quads, strips, parts), 1000u);
  EXPECT_GE(refined_quad_count(two_quads, strips, parts), 950u);
  EXPECT_GT(parts[strips.of(0, 1)], parts[strips.of(1, 2)]);
  EXPECT_EQ(parts_for(two_quads, strips, lengths, 0), std::vector<int>(3, 1));
}

}  // namespace
}  // namespace sinew
