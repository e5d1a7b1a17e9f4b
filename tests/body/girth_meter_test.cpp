#include "engine/body/girth_meter.h"

#include <gtest/gtest.h>

#include "tests/body/measured_tube.h"

namespace sinew::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-12;

Girth girth(const MeasuredTube& tube, double at, int joint = tube_upper, int child = tube_lower) {
  const auto found = limb_girth(tube.surface(), joint, child, at);
  EXPECT_TRUE(found) << found.error().message;
  return found.value_or(Girth{});
}

/// Circumference of an ellipse by the series in the third flattening, to double precision for these axes.
double ellipse(double a, double b) {
  const double h = (a - b) * (a - b) / ((a + b) * (a + b));
  double sum = 1.0, binomial = 1.0;
  for (int n = 1; n < 40; ++n) {
    binomial *= (0.5 - (n - 1)) / n;
    sum += binomial * binomial * std::pow(h, n);
  }
  return pi * (a + b) * sum;
}

TEST(GirthMeter, OfATubeIsThatOfItsPolygon) {
  const MeasuredTube tube({.radius = 0.2, .rows = 33, .columns = 24});
  for (const double at : {0.013, 0.3, 0.5, 0.77, 0.999}) {
    // A section between two rings cuts the triangles' diagonals too, which lie in the polygon's sides.
    const double polygon = 24 * 2 * 0.2 * std::sin(pi / 24);
    EXPECT_NEAR(girth(tube, at).length, polygon, rounding) << at;
    EXPECT_NEAR(girth(tube, at).tape, polygon, rounding) << at;
  }
}

TEST(GirthMeter, TendsToTheCirclesAtTheSquareOfTheColumns) {
  double before = 0.0;
  for (const std::size_t columns : {16u, 32u, 64u, 128u}) {
    const double error = 2 * pi * 0.2 - girth(MeasuredTube({.radius = 0.2, .rows = 9, .columns = columns}), 0.4).length;
    EXPECT_GT(error, 0.0);
    if (before > 0.0) {
      EXPECT_NEAR(before / error, 4.0, 0.05) << columns;
    }
    before = error;
  }
  EXPECT_LT(before, 2 * pi * 0.2 * 2e-4);
}

TEST(GirthMeter, OfAnEllipticTubeIsTheEllipses) {
  const auto flat = [](const Vec3& p) { return Vec3(1.5 * p.x, p.y, 0.5 * p.z); };
  const MeasuredTube tube({.radius = 0.2, .rows = 9, .columns = 720}, flat);
  // The polygon of 720 corners is shorter by about (2 pi / 720)^2 / 24 of it.
  EXPECT_NEAR(girth(tube, 0.4).length, ellipse(0.3, 0.1), 1e-5 * ellipse(0.3, 0.1));
}

TEST(GirthMeter, ATapeSpansHollows) {
  // r = 0.2 (1 + 0.3 cos 4u): four lobes, whose hull is shorter than the outline.
  const auto lobed = [](const Vec3& p) {
    const double swell = 1.0 + 0.3 * std::cos(4.0 * std::atan2(p.x, p.z));
    return Vec3(p.x * swell, p.y, p.z * swell);
  };
  const Girth found = girth(MeasuredTube({.radius = 0.2, .rows = 9, .columns = 1024}, lobed), 0.5);
  double outline = 0.0;
  constexpr int steps = 200'000;
  for (int i = 0; i < steps; ++i) {
    const double u = 2 * pi * (i + 0.5) / steps, r = 0.2 * (1 + 0.3 * std::cos(4 * u)), dr = -0.24 * std::sin(4 * u);
    outline += std::sqrt(r * r + dr * dr) * 2 * pi / steps;
  }
  EXPECT_NEAR(found.length, outline, 1e-4 * outline);
  EXPECT_LT(found.tape, 0.95 * found.length);
  // Each lobe touches the hull near its tip: the square through the four tips is inside the hull, the circle round
  // them outside.
  EXPECT_GT(found.tape, 4 * std::sqrt(2.0) * 0.26);
  EXPECT_LT(found.tape, 2 * pi * 0.26);
}

TEST(GirthMeter, IsTakenAcrossThePosedLimb) {
  // The plane follows the limb: a bent rest pose changes nothing at the middle of the straight part beyond it.
  const MeasuredTube bent(TubeShape{.blend = 0.1, .rest_bend = 80.0});
  const double polygon = 24 * 2 * 0.2 * std::sin(pi / 24);
  EXPECT_NEAR(girth(bent, 0.3).length, polygon, rounding);
  EXPECT_NEAR(girth(bent, 0.7, tube_lower, tube_hand).length, polygon, 1e-9) << "turned by a quaternion";
}

TEST(GirthMeter, KeepsToTheLimbAmongOthers) {
  // A thicker trunk beside the limb, on the root; it lies nearer to nothing but is cut by the same plane.
  const Model model = with_second_tube(tube({.radius = 0.2}), {.radius = 0.7}, {1.0, 0, 0}, tube_root);
  EXPECT_NEAR(girth(MeasuredTube(model), 0.4).length, 24 * 2 * 0.2 * std::sin(pi / 24), rounding);
  // Even where the trunk goes round the limb.
  const Model inside = with_second_tube(tube({.radius = 0.2}), {.radius = 0.7}, {}, tube_root);
  EXPECT_NEAR(girth(MeasuredTube(inside), 0.4).length, 24 * 2 * 0.2 * std::sin(pi / 24), rounding);
}

TEST(GirthMeter, MeasuresOverWhatIsWorn) {
  const Model sleeved = with_second_tube(tube({.radius = 0.2}), {.radius = 0.25}, {}, tube_upper);
  EXPECT_NEAR(girth(MeasuredTube(sleeved), 0.4).length, 24 * 2 * 0.25 * std::sin(pi / 24), rounding);
}

TEST(GirthMeter, ASeamInTheTextureIsNoGap) {
  // Every triangle with corners of its own.
  Model split = tube({});
  Primitive& skin = split.meshes[0].primitives[0];
  Primitive apart;
  for (const std::uint32_t v : skin.indices) {
    apart.indices.push_back(static_cast<std::uint32_t>(apart.positions.size()));
    apart.positions.push_back(skin.positions[v]);
    apart.normals.push_back(skin.normals[v]);
    const auto* run = skin.influences.entries.data();
    apart.influences.add_vertex({run + skin.influences.first[v], run + skin.influences.first[v + 1]});
  }
  skin = apart;
  EXPECT_NEAR(girth(MeasuredTube(split), 0.41).length, girth(MeasuredTube(TubeShape{}), 0.41).length, rounding);
}

TEST(GirthMeter, SaysWhyThereIsNone) {
  const MeasuredTube tube(TubeShape{});
  const auto beyond = limb_girth(tube.surface(), tube_upper, tube_lower, -0.5);
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().kind, ErrorKind::bad_input);
  EXPECT_NE(beyond.error().message.find("\"upper\": at -0.5"), std::string::npos) << beyond.error().message;
  const auto nowhere = limb_girth(tube.surface(), tube_root, tube_upper, 0.5);
  ASSERT_FALSE(nowhere);
  EXPECT_NE(nowhere.error().message.find("no limb to cut"), std::string::npos) << nowhere.error().message;
}

}  // namespace
}  // namespace sinew::test
