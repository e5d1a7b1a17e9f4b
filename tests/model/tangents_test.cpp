#include "engine/model/tangents.h"

#include <algorithm>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/test_character.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

/// Roundings of a dozen sums and products of numbers of size one.
constexpr double rounding = 1e-12;

using Place = std::function<Vec3(double x, double y)>;
using Chart = std::function<Vec2(double x, double y)>;

/// A grid of quads over 0..1 x 0..1, seen from the side where x runs right and y up. Normals by central differences.
Primitive grid(const Place& place, const Chart& chart, std::uint32_t side = 5) {
  Primitive out;
  for (std::uint32_t row = 0; row < side; ++row)
    for (std::uint32_t column = 0; column < side; ++column) {
      const double x = column / (side - 1.0), y = row / (side - 1.0), h = 1e-6;
      out.positions.push_back(place(x, y));
      out.normals.push_back(
          glm::normalize(glm::cross(place(x + h, y) - place(x - h, y), place(x, y + h) - place(x, y - h))));
      out.texture_coordinates.push_back(chart(x, y));
      if (row + 1 == side || column + 1 == side) continue;
      const std::uint32_t a = row * side + column, b = a + 1, c = a + side, d = c + 1;
      out.indices.insert(out.indices.end(), {a, b, d, a, d, c});
    }
  return out;
}

Vec3 plain(double x, double y) { return {x, y, 0}; }
Vec3 bumpy(double x, double y) { return {x, y + 0.1 * x * x, 0.3 * std::sin(3 * x) * std::cos(4 * y)}; }
/// As a picture lies on a wall: u to the right, v down.
Vec2 upright(double x, double y) { return {x, 1 - y}; }
Vec2 warped(double x, double y) { return {x + 0.2 * y * y, 1 - y + 0.3 * x * y}; }

std::vector<Vec4> tangents_of(const Primitive& primitive) { return generate_tangents(primitive, Texture{}); }

double largest_difference(const std::vector<Vec4>& a, const std::vector<Vec4>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = a.size() == b.size() ? 0.0 : INFINITY;
  // Written so that a number that is none counts as far.
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    if (!(glm::length(a[i] - b[i]) <= largest)) largest = std::isnan(a[i].x) ? INFINITY : glm::length(a[i] - b[i]);
  return largest;
}

/// What every tangent holds to, whatever it comes from.
void expect_sound(const Primitive& primitive, const std::vector<Vec4>& tangents) {
  ASSERT_EQ(tangents.size(), primitive.positions.size());
  for (std::size_t v = 0; v < tangents.size(); ++v) {
    EXPECT_NEAR(glm::length(Vec3(tangents[v])), 1.0, rounding) << "vertex " << v;
    EXPECT_NEAR(glm::dot(Vec3(tangents[v]), primitive.normals[v]), 0.0, rounding) << "vertex " << v;
    EXPECT_EQ(std::abs(tangents[v].w), 1.0) << "vertex " << v;
  }
}

TEST(Tangents, OfAnUprightPictureGoRightAndItsBitangentsUp) {
  for (const Vec4& tangent : tangents_of(grid(plain, upright))) EXPECT_EQ(tangent, Vec4(1, 0, 0, 1));
}

TEST(Tangents, OfAMirroredPictureHaveTheOtherSide) {
  // Bitangent = w (normal x tangent) goes where the picture goes up, here +y: normal x tangent goes to -y.
  for (const Vec4& tangent : tangents_of(grid(plain, [](double x, double y) { return Vec2(1 - x, 1 - y); })))
    EXPECT_EQ(tangent, Vec4(-1, 0, 0, -1));
}

TEST(Tangents, OfAPlaneAreTheInverseOfItsChart) {
  Random random(3);
  int mirrored_charts = 0;
  for (int i = 0; i < 50; ++i) {
    const glm::dmat2 chart(Vec2(random.vector()), Vec2(random.vector()));
    if (std::abs(glm::determinant(chart)) < 0.1) continue;
    const Vec2 shift(random.vector());
    const Mat3 frame = glm::mat3_cast(random.rotation());
    const Primitive plane = grid([&](double x, double y) { return frame * Vec3(x, y, 0); },
                                 [&](double x, double y) { return chart * Vec2(x, y) + shift; });
    const glm::dmat2 inverse = glm::inverse(chart);
    const Vec3 along_u = frame * Vec3(inverse[0], 0.0), along_v = frame * Vec3(inverse[1], 0.0);
    const double side = glm::dot(glm::cross(frame[2], along_u), -along_v) > 0.0 ? 1.0 : -1.0;
    const std::vector<Vec4> expected(plane.positions.size(), Vec4(glm::normalize(along_u), side));
    // Over a determinant of 0.1 and normals by differences: 1e-16 / 1e-6.
    EXPECT_LT(largest_difference(tangents_of(plane), expected), 1e-8);
    mirrored_charts += side < 0 ? 1 : 0;
  }
  EXPECT_GT(mirrored_charts, 5);
}

TEST(Tangents, GoRoundATube) {
  const auto round = [](double x, double y) {
    const double angle = 2 * std::numbers::pi * x;
    return Vec3(std::sin(angle), y, std::cos(angle));
  };
  const Primitive tube = grid(round, upright, 9);
  const std::vector<Vec4> tangents = tangents_of(tube);
  for (std::size_t v = 0; v < tangents.size(); ++v) {
    const Vec3& p = tube.positions[v];
    EXPECT_LT(glm::length(Vec3(tangents[v]) - Vec3(p.z, 0, -p.x)), 1e-9) << v;  // normals by differences
    EXPECT_EQ(tangents[v].w, 1.0);
  }
}

TEST(Tangents, ApproachTheSurfacesDerivativeAlongU) {
  double before = INFINITY;
  for (const std::uint32_t side : {9u, 17u, 33u}) {
    const Primitive surface = grid(bumpy, warped, side);
    const std::vector<Vec4> tangents = tangents_of(surface);
    double largest = 0.0;
    for (std::uint32_t row = 1; row + 1 < side; ++row)
      for (std::uint32_t column = 1; column + 1 < side; ++column) {
        const double x = column / (side - 1.0), y = row / (side - 1.0), h = 1e-6;
        const glm::dmat2 chart((warped(x + h, y) - warped(x - h, y)) / (2 * h),
                               (warped(x, y + h) - warped(x, y - h)) / (2 * h));
        const Vec2 along_u = glm::inverse(chart)[0];
        const Vec3 slope =
            along_u.x * (bumpy(x + h, y) - bumpy(x - h, y)) + along_u.y * (bumpy(x, y + h) - bumpy(x, y - h));
        largest = std::max(largest, angle_degrees(Vec3(tangents[row * side + column]), slope));
      }
    EXPECT_LT(largest, 0.6 * before) << "half the distance, about half the error or less";
    before = largest;
  }
  EXPECT_LT(before, 2.0);
}

TEST(Tangents, AreOfUnitLengthInThePlaneOfTheNormal) {
  Random random(5);
  Primitive surface = grid(bumpy, warped, 9);
  expect_sound(surface, tangents_of(surface));
  for (Vec3& normal : surface.normals) normal = glm::normalize(random.vector());
  for (Vec2& uv : surface.texture_coordinates) uv = Vec2(random.vector());
  expect_sound(surface, tangents_of(surface));
}

TEST(Tangents, TurnWithTheSurface) {
  Random random(6);
  const Primitive still = grid(bumpy, warped, 9);
  const std::vector<Vec4> before = tangents_of(still);
  for (int i = 0; i < 10; ++i) {
    const Mat4 motion = random.rigid_motion();
    const double scale = random.between(0.01, 100.0);
    Primitive moved = still;
    std::vector<Vec4> expected;
    for (std::size_t v = 0; v < before.size(); ++v) {
      moved.positions[v] = scale * Vec3(motion * Vec4(still.positions[v], 1.0));
      moved.normals[v] = Mat3(motion) * still.normals[v];
      expected.emplace_back(Mat3(motion) * Vec3(before[v]), before[v].w);
    }
    EXPECT_LT(largest_difference(tangents_of(moved), expected), rounding);
  }
}

TEST(Tangents, OfTheMirroredSurfaceAreMirroredAndChangeSides) {
  Model model;
  model.meshes = {{"", {grid(bumpy, warped, 9)}, {}}};
  std::vector<Vec4> expected;
  for (const Vec4& tangent : tangents_of(model.meshes[0].primitives[0]))
    expected.emplace_back(mirrored(Vec3(tangent)), -tangent.w);
  EXPECT_LT(largest_difference(tangents_of(mirrored(model).meshes[0].primitives[0]), expected), rounding);
}

TEST(Tangents, FollowTheTexturesTransformAndItsSet) {
  Primitive surface = grid(bumpy, warped, 9);
  Texture texture;
  texture.offset = {0.25, -3};
  texture.rotation = 2.0;
  texture.scale = {3, -0.5};
  Primitive moved = surface;
  for (Vec2& uv : moved.texture_coordinates) uv = texture.apply(uv);
  EXPECT_LT(largest_difference(generate_tangents(surface, texture), tangents_of(moved)), rounding);
  EXPECT_GT(largest_difference(tangents_of(surface), tangents_of(moved)), 0.5) << "the transform must be seen at all";
  surface.second_texture_coordinates = moved.texture_coordinates;
  Texture second;
  second.coordinates = 1;
  EXPECT_EQ(generate_tangents(surface, second), tangents_of(moved));
}

/// A fan of triangles round vertex 0, none like another.
Primitive fan() {
  Primitive out;
  out.positions = {{0, 0, 0.3}, {1, 0, 0}, {0.4, 0.9, -0.1}, {-1, 0.2, 0.1}, {-0.3, -0.8, 0}};
  out.normals.assign(5, Vec3(0, 0, 1));
  out.texture_coordinates = {{0, 0}, {1, 0.2}, {0.3, -1}, {-0.9, -0.3}, {-0.2, 0.7}};
  out.indices = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
  return out;
}

TEST(Tangents, DoNotDependOnHowATriangleIsCut) {
  const Primitive whole = fan();
  Primitive cut = whole;
  cut.positions.push_back(glm::mix(whole.positions[1], whole.positions[2], 0.3));
  cut.texture_coordinates.push_back(glm::mix(whole.texture_coordinates[1], whole.texture_coordinates[2], 0.3));
  cut.normals.push_back({0, 0, 1});
  cut.indices = {0, 1, 5, 0, 5, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
  EXPECT_LT(glm::length(tangents_of(cut)[0] - tangents_of(whole)[0]), rounding);
}

TEST(Tangents, DoNotDependOnTheOrderOfTriangles) {
  const Primitive whole = fan();
  Primitive other = whole;
  other.indices = {4, 1, 0, 2, 3, 0, 0, 1, 2, 3, 4, 0};
  EXPECT_LT(largest_difference(tangents_of(other), tangents_of(whole)), rounding);
  EXPECT_EQ(tangents_of(whole), tangents_of(whole)) << "to the bit";
}

TEST(Tangents, TheGreaterAngleGivesTheSideWhereBothMeet) {
  // Three quarters of what lies round the vertex show the picture upright, one quarter mirrored: its u falls.
  Primitive corner;
  corner.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  corner.normals.assign(5, Vec3(0, 0, 1));
  corner.texture_coordinates = {{0, 0}, {1, 0}, {0, -1}, {-1, 0}, {0, 1}};
  const auto quarter = [](std::uint32_t a, std::uint32_t b) { return std::vector<std::uint32_t>{0, a, b}; };
  for (const auto& triangle : {quarter(1, 2), quarter(2, 3), quarter(3, 4)})
    corner.indices.insert(corner.indices.end(), triangle.begin(), triangle.end());
  corner.positions.push_back({1, 0, 0});
  corner.positions.push_back({0, -1, 0});
  corner.normals.resize(7, Vec3(0, 0, 1));
  corner.texture_coordinates.push_back({-1, 0});
  corner.texture_coordinates.push_back({0, 1});
  corner.indices.insert(corner.indices.end(), {0, 6, 5});
  const std::vector<Vec4> tangents = tangents_of(corner);
  EXPECT_LT(glm::length(tangents[0] - Vec4(1, 0, 0, 1)), rounding) << "of the three alone";
  EXPECT_LT(glm::length(tangents[5] - Vec4(-1, 0, 0, -1)), rounding);
  for (Vec2& uv : corner.texture_coordinates) uv.x = -uv.x;
  EXPECT_LT(glm::length(tangents_of(corner)[0] - Vec4(-1, 0, 0, -1)), rounding);
}

TEST(Tangents, WhereTheCoordinatesSayNothingAnyDirectionInThePlaneStandsIn) {
  const Chart charts[] = {[](double, double) { return Vec2(0.5); },             // all alike
                          [](double x, double) { return Vec2(x, 2 * x); },      // on a line
                          [](double x, double y) { return Vec2(x + y, 0.0); },  // no v
                          [](double x, double y) { return 1e-170 * Vec2(x, -y); },
                          [](double x, double y) { return Vec2(1e-160 * x, -1e-160 * y); },
                          [](double x, double y) { return Vec2(1e-300 * x, -y); },
                          [](double x, double y) { return 1e200 * Vec2(x, -y); }};
  for (const Chart& chart : charts) {
    const Primitive surface = grid(bumpy, chart);
    expect_sound(surface, tangents_of(surface));
  }
  Primitive none = grid(bumpy, upright);
  none.texture_coordinates.clear();
  expect_sound(none, tangents_of(none));
  none.indices.clear();
  expect_sound(none, tangents_of(none));
  Texture flat;
  flat.scale = {0, 0};
  const Primitive surface = grid(bumpy, upright);
  expect_sound(surface, generate_tangents(surface, flat));
  EXPECT_TRUE(tangents_of({}).empty());
}

TEST(Tangents, TrianglesWithoutAreaSayNothing) {
  Primitive surface = grid(bumpy, warped);
  const std::vector<Vec4> before = tangents_of(surface);
  surface.indices.insert(surface.indices.end(), {3, 3, 3, 7, 8, 8, 4, 4, 9});
  EXPECT_EQ(tangents_of(surface), before);
  // Of an area on the picture, but none in space: an edge of length 0.
  surface.positions.push_back(surface.positions[12]);
  surface.normals.push_back(surface.normals[12]);
  surface.texture_coordinates.push_back({7, 3});
  surface.indices.insert(surface.indices.end(), {11, 12, 25});
  expect_sound(surface, tangents_of(surface));
}

}  // namespace
}  // namespace sinew::test
