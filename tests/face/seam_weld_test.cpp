#include "engine/face/seam_weld.h"

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

/// Strips of two triangles along z, each from one line to another; lines are given by x and y.
struct Strips {
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> triangles;

  std::uint32_t line(double x, double y) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.push_back({x, y, 0.0});
    positions.push_back({x, y, 1.0});
    return first;
  }
  void strip(std::uint32_t a, std::uint32_t b) { triangles.insert(triangles.end(), {a, b, b + 1, a, b + 1, a + 1}); }
};

TEST(SeamWeld, ASeamIsOnePlaceAndWhatOnlyLiesNearIsNot) {
  Strips s;
  const auto a = s.line(0, 0), b = s.line(1, 0), again = s.line(1, 0), c = s.line(2, 0.5), off = s.line(1, 1e-9);
  s.strip(a, b);
  s.strip(again, c);
  std::size_t places = 0;
  const auto place = weld_seams(s.positions, s.triangles, places);
  EXPECT_EQ(place[b], place[again]);
  EXPECT_EQ(place[b + 1], place[again + 1]);
  EXPECT_NE(place[b], place[off]);
  EXPECT_EQ(places, s.positions.size() - 2);
}

TEST(SeamWeld, BordersThatLieOnEachOtherAndFaceApartStayTwo) {
  // The edges of two lips: the skin turns inward at both.
  Strips s;
  const auto upper = s.line(0, 0.3), upper_edge = s.line(1, 0), lower_edge = s.line(1, 0), lower = s.line(0, -0.3);
  s.strip(upper, upper_edge);
  s.strip(lower_edge, lower);
  std::size_t places = 0;
  const auto place = weld_seams(s.positions, s.triangles, places);
  EXPECT_NE(place[upper_edge], place[lower_edge]);
  EXPECT_EQ(places, s.positions.size());
}

TEST(SeamWeld, WhereFourBordersMeetThoseBelongTogetherThatHangTogetherAtAnEnd) {
  // Two lips that touch along one line, their outsides and the pockets behind them cut apart there. The pockets face
  // alike, and only the line's end tells that each goes on into its lip.
  Strips s;
  const auto upper = s.line(-1, 0.2), lower = s.line(-1, -0.2), up = s.line(0.2, 1), down = s.line(0.2, -1);
  const std::uint32_t at[4] = {s.line(0, 0), s.line(0, 0), s.line(0, 0), s.line(0, 0)};
  // Upper and lower lip share their end at z = 1 with their pockets.
  const auto strip = [&](std::uint32_t a, std::uint32_t b, std::uint32_t b_end) {
    s.triangles.insert(s.triangles.end(), {a, b, b_end, a, b_end, a + 1});
  };
  const auto back = [&](std::uint32_t a, std::uint32_t a_end, std::uint32_t b) {
    s.triangles.insert(s.triangles.end(), {a, b, b + 1, a, b + 1, a_end});
  };
  strip(upper, at[0], at[0] + 1);
  back(at[1], at[0] + 1, up);
  back(at[2], at[2] + 1, lower);
  strip(down, at[3], at[2] + 1);
  std::size_t places = 0;
  const auto place = weld_seams(s.positions, s.triangles, places);
  EXPECT_EQ(place[at[0]], place[at[1]]);
  EXPECT_EQ(place[at[2]], place[at[3]]);
  EXPECT_NE(place[at[0]], place[at[2]]);
  EXPECT_NE(place[at[0] + 1], place[at[2] + 1]);
}

TEST(SeamWeld, TrianglesThatShareNothingBecomeOneSurface) {
  // A fan of a dozen, each with corners of its own, numbered so that roots change hands.
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> triangles;
  constexpr std::uint32_t n = 12;
  for (const std::uint32_t i : {7u, 2u, 9u, 0u, 5u, 11u, 3u, 8u, 1u, 10u, 4u, 6u}) {
    const auto rim = [](std::uint32_t k) {
      const double angle = (k % n) * 6.283185307179586 / n;
      return Vec3(std::cos(angle), std::sin(angle), 0.0);
    };
    for (const Vec3& p : {Vec3(0.0), rim(i), rim(i + 1)}) {
      triangles.push_back(static_cast<std::uint32_t>(positions.size()));
      positions.push_back(p);
    }
  }
  std::size_t places = 0;
  const auto place = weld_seams(positions, triangles, places);
  EXPECT_EQ(places, n + 1);
  for (std::size_t v = 0; v < positions.size(); ++v)
    for (std::size_t w = 0; w < positions.size(); ++w)
      EXPECT_EQ(place[v] == place[w], positions[v] == positions[w]) << v << " " << w;
}

}  // namespace
}  // namespace sinew::test
