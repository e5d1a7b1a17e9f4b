#include "engine/body/volume_meter.h"

#include <gtest/gtest.h>

#include "tests/body/measured_tube.h"

namespace sinew::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-12;

SegmentVolume volume(const MeasuredTube& tube, double from = 0.0, double to = 1.0, int joint = tube_upper,
                     int child = tube_lower) {
  const auto found = segment_volume(tube.surface(), joint, child, from, to);
  EXPECT_TRUE(found) << found.error().message;
  return found.value_or(SegmentVolume{});
}

/// Area of a regular polygon in a circle.
double polygon_area(std::size_t columns, double radius) {
  const double n = static_cast<double>(columns);
  return 0.5 * n * radius * radius * std::sin(2 * pi / n);
}

TEST(VolumeMeter, OfATubeIsThatOfItsPrism) {
  const MeasuredTube tube({.radius = 0.2, .rows = 33, .columns = 24});
  for (const auto& [from, to] : {std::pair(0.1, 0.9), {0.123, 0.477}, {0.25, 0.75}}) {
    const SegmentVolume found = volume(tube, from, to);
    EXPECT_NEAR(found.volume, polygon_area(24, 0.2) * (to - from), rounding);
    EXPECT_EQ(found.from, from);
    EXPECT_EQ(found.to, to);
    EXPECT_EQ(found.open_edges, 0u);
  }
}

TEST(VolumeMeter, OfAConeIsThatOfItsFrustum) {
  // The radius goes from 0.2 at y = 0 to 0.1 at y = 2.
  const auto tapered = [](const Vec3& p) { return Vec3(p.x * (1 - p.y / 4), p.y, p.z * (1 - p.y / 4)); };
  const MeasuredTube cone({.radius = 0.2, .rows = 17, .columns = 24}, tapered);
  const auto frustum = [](double area_of_unit, double from, double to) {
    const double a = 0.2 * (1 - from / 4), b = 0.2 * (1 - to / 4);
    return area_of_unit * (to - from) * (a * a + a * b + b * b) / 3;
  };
  // Planes through rings cut the faceted cone along its facets: a frustum on a polygon, exactly. Diagonals of a tapered
  // quadrilateral lie in its plane.
  EXPECT_NEAR(volume(cone, 0.25, 0.75).volume, frustum(polygon_area(24, 1.0), 0.25, 0.75), rounding);
  EXPECT_NEAR(volume(cone, 0.3, 0.7).volume, frustum(polygon_area(24, 1.0), 0.3, 0.7), rounding);
  double before = 0.0;
  for (const std::size_t columns : {16u, 32u, 64u}) {
    const double error = frustum(pi, 0.2, 0.8) -
                         volume(MeasuredTube({.radius = 0.2, .rows = 9, .columns = columns}, tapered), 0.2, 0.8).volume;
    if (before > 0.0) {
      EXPECT_NEAR(before / error, 4.0, 0.06) << "at the square of the columns";
    }
    before = error;
  }
}

TEST(VolumeMeter, DoesNotDependOnWhereTheModelStands) {
  const auto moved = [](const Vec3& p) { return p + Vec3(30.0, -12.0, 7.0); };
  MeasuredTube tube({.radius = 0.2, .rows = 33, .columns = 24}, moved);
  for (Mat4& global : tube.character.rest.global) global = glm::translate(Mat4(1.0), {30, -12, 7}) * global;
  // Thirty units from the origin a double has 4e-15 left, which the division by nothing smaller than 0.05 amplifies.
  EXPECT_NEAR(volume(tube, 0.2, 0.8).volume, polygon_area(24, 0.2) * 0.6, 1e-10);
}

TEST(VolumeMeter, AnEndWithoutASectionMovesInwards) {
  // The tube is open where the joint stands: a plane there cuts nothing.
  const SegmentVolume found = volume(MeasuredTube(TubeShape{}), 0.0, 0.5);
  EXPECT_EQ(found.from, 0.01);
  EXPECT_EQ(found.to, 0.5);
  EXPECT_NEAR(found.volume, polygon_area(24, 0.2) * 0.49, rounding);
}

TEST(VolumeMeter, LeavesOutWhatIsBesideTheLimb) {
  const Model model = with_second_tube(tube({.radius = 0.2}), {.radius = 0.7}, {1.0, 0, 0}, tube_root);
  EXPECT_NEAR(volume(MeasuredTube(model), 0.2, 0.8).volume, polygon_area(24, 0.2) * 0.6, rounding);
}

TEST(VolumeMeter, TellsAHoleAndCountsItsEdges) {
  Model holed = tube({.radius = 0.2, .rows = 33, .columns = 24});
  std::vector<std::uint32_t>& indices = holed.meshes[0].primitives[0].indices;
  // One triangle in the row from y = 0.625 on, away from the section in the middle.
  const std::size_t triangle = 2 * 24 * 10 + 6;
  indices.erase(indices.begin() + 3 * triangle, indices.begin() + 3 * triangle + 3);
  EXPECT_EQ(volume(MeasuredTube(holed), 0.2, 0.8).open_edges, 3u);
}

TEST(VolumeMeter, RefusesAnEmptyRange) {
  const MeasuredTube tube(TubeShape{});
  EXPECT_FALSE(segment_volume(tube.surface(), tube_upper, tube_lower, 0.5, 0.5));
  EXPECT_FALSE(segment_volume(tube.surface(), tube_root, tube_upper));
}

}  // namespace
}  // namespace sinew::test
