#include "engine/core/math.h"

#include <random>

#include <gtest/gtest.h>

namespace sinew {
namespace {

/// A few roundings of numbers of size one.
constexpr double rounding = 1e-14;

double largest_difference(const Mat3& a, const Mat3& b) {
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
  return largest;
}

Mat3 from_rows(const Vec3& x, const Vec3& y, const Vec3& z) { return glm::transpose(Mat3(x, y, z)); }

class Random {
 public:
  double number() { return distribution_(engine_); }
  Vec3 vector() { return {number(), number(), number()}; }
  Mat3 matrix() { return {vector(), vector(), vector()}; }

 private:
  std::mt19937 engine_{7};
  std::uniform_real_distribution<double> distribution_{-1.0, 1.0};
};

TEST(Math, TurnsAboutXFirstThenYThenZ) {
  Random random;
  for (int i = 0; i < 50; ++i) {
    const Vec3 degrees = 180.0 * random.vector();
    const Vec3 c = glm::cos(degrees * degrees_to_radians), s = glm::sin(degrees * degrees_to_radians);
    const Mat3 x = from_rows({1, 0, 0}, {0, c.x, -s.x}, {0, s.x, c.x});
    const Mat3 y = from_rows({c.y, 0, s.y}, {0, 1, 0}, {-s.y, 0, c.y});
    const Mat3 z = from_rows({c.z, -s.z, 0}, {s.z, c.z, 0}, {0, 0, 1});
    EXPECT_LT(largest_difference(glm::mat3_cast(rotation_xyz_degrees(degrees)), z * y * x), rounding);
  }
}

TEST(Math, AQuarterTurnAboutOneAxisGoesRoundItByTheRightHand) {
  EXPECT_LT(glm::length(rotation_xyz_degrees({90, 0, 0}) * Vec3(0, 1, 0) - Vec3(0, 0, 1)), rounding);
  EXPECT_LT(glm::length(rotation_xyz_degrees({0, 90, 0}) * Vec3(0, 0, 1) - Vec3(1, 0, 0)), rounding);
  EXPECT_LT(glm::length(rotation_xyz_degrees({0, 0, 90}) * Vec3(1, 0, 0) - Vec3(0, 1, 0)), rounding);
  // Up becomes front by x and then the side by y; the other way round it would stay up.
  EXPECT_LT(glm::length(rotation_xyz_degrees({90, 90, 0}) * Vec3(0, 1, 0) - Vec3(1, 0, 0)), rounding);
}

TEST(Math, ATransformScalesThenTurnsThenMoves) {
  Random random;
  for (int i = 0; i < 50; ++i) {
    const Transform t{random.vector(), rotation_xyz_degrees(180.0 * random.vector()), random.vector()};
    const Vec3 p = random.vector();
    const Vec3 expected = t.rotation * (t.scale * p) + t.translation;
    EXPECT_LT(glm::length(Vec3(t.matrix() * Vec4(p, 1.0)) - expected), rounding);
    EXPECT_EQ(t.matrix()[0][3], 0.0);
    EXPECT_EQ(t.matrix()[3][3], 1.0);
  }
}

TEST(Math, ThreeRowsDoWhatTheMatrixDoes) {
  Random random;
  for (int i = 0; i < 50; ++i) {
    Mat4 m(random.matrix());
    m[3] = Vec4(random.vector(), 1.0);
    const Vec3 p = random.vector();
    const Mat34 rows = Mat34::from(m);
    EXPECT_LT(glm::length(rows.transform_point(p) - Vec3(m * Vec4(p, 1.0))), rounding);
    EXPECT_EQ(rows.linear(), Mat3(m));
  }
  EXPECT_EQ(Mat34().transform_point({1, 2, 3}), Vec3(1, 2, 3));
}

TEST(Math, AnglesAreAccurateNearBothEnds) {
  for (const double degrees : {0.0, 1e-9, 1e-4, 30.0, 90.0, 179.9999, 180.0}) {
    const Vec3 turned = rotation_xyz_degrees({0, 0, degrees}) * Vec3(3, 0, 0);
    // An arc cosine would lose half of the digits at 0 and 180: a millionth of a degree.
    EXPECT_NEAR(angle_degrees({0.5, 0, 0}, turned), degrees, 1e-13);
  }
  EXPECT_DOUBLE_EQ(angle_degrees({1, 0, 0}, {0, 0, -7}), 90.0);
  EXPECT_EQ(angle_degrees({0, 0, 0}, {1, 0, 0}), 0.0);
}

TEST(Math, TooShortAVectorHasNoDirection) {
  EXPECT_EQ(unit_or({0, 3, 4}, Vec3(9)), Vec3(0, 0.6, 0.8));
  EXPECT_EQ(unit_or({0, 1e-20, 0}, Vec3(9)), Vec3(0, 1, 0));
  EXPECT_EQ(unit_or({0, 0, 0}, Vec3(9)), Vec3(9));
  EXPECT_EQ(unit_or({NAN, 0, 0}, Vec3(9)), Vec3(9));
}

TEST(Math, TheStepIsTheCubicWithLevelEnds) {
  EXPECT_EQ(smoothstep01(-3), 0.0);
  EXPECT_EQ(smoothstep01(0), 0.0);
  EXPECT_EQ(smoothstep01(0.25), 5.0 / 32.0);
  EXPECT_EQ(smoothstep01(0.5), 0.5);
  EXPECT_EQ(smoothstep01(0.75), 27.0 / 32.0);
  EXPECT_EQ(smoothstep01(1), 1.0);
  EXPECT_EQ(smoothstep01(8), 1.0);
}

TEST(Math, TheStepsSlopeIsItsDerivative) {
  constexpr double h = 1e-5;
  for (double x = -0.5; x < 1.5; x += 0.037)
    // Central differences of a cubic are off by h^2 and, across its ends, by 3h.
    EXPECT_NEAR(smoothstep01_slope(x), (smoothstep01(x + h) - smoothstep01(x - h)) / (2 * h), 1e-9) << x;
  EXPECT_EQ(smoothstep01_slope(-0.01), 0.0);
  EXPECT_EQ(smoothstep01_slope(1.01), 0.0);
}

TEST(Math, CofactorsAreTheDeterminantTimesTheInverseTranspose) {
  Random random;
  for (int i = 0; i < 50; ++i) {
    const Mat3 a = random.matrix();
    EXPECT_LT(largest_difference(cofactor(a) * glm::transpose(a), Mat3(glm::determinant(a))), rounding);
    EXPECT_LT(largest_difference(glm::transpose(a) * cofactor(a), Mat3(glm::determinant(a))), rounding);
  }
}

TEST(Math, CofactorsOfAFlattenedMatrixKeepTheDirectionAcross) {
  const Mat3 flat(Vec3(2, 0, 0), Vec3(0, 3, 0), Vec3(0));
  EXPECT_EQ(cofactor(flat), Mat3(Vec3(0), Vec3(0), Vec3(0, 0, 6)));
}

TEST(Math, BoundsHoldWhatWasAdded) {
  Bounds bounds;
  EXPECT_TRUE(bounds.empty());
  EXPECT_EQ(bounds.diagonal(), 0.0);
  bounds.add(Vec3(1, 5, -2));
  EXPECT_FALSE(bounds.empty());
  EXPECT_EQ(bounds.diagonal(), 0.0);
  Bounds other;
  other.add(Vec3(3, 2, 4));
  bounds.add(other);
  EXPECT_EQ(bounds.low, Vec3(1, 2, -2));
  EXPECT_EQ(bounds.high, Vec3(3, 5, 4));
  EXPECT_EQ(bounds.centre(), Vec3(2, 3.5, 1));
  EXPECT_EQ(bounds.diagonal(), 7.0);
  bounds.add(Bounds());
  EXPECT_EQ(bounds.diagonal(), 7.0);
}

}  // namespace
}  // namespace sinew
