#include "engine/body/figure_field.h"

#include <random>

#include <gtest/gtest.h>

namespace sinew {
namespace {

/// Points on the surface, found by walking to it from where the trunk, arms and legs are.
std::vector<Vec3> on_surface(const BodyField& field) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0.0, 0.35), y(0.05, 1.0), z(-0.08, 0.10);
  std::vector<Vec3> out;
  while (out.size() < 2000) {
    Vec3 p{x(random), y(random), z(random)};
    if (std::abs(field.at(p).distance) > 0.01) continue;
    for (int step = 0; step < 6; ++step) field.step_to_surface(p);
    if (std::abs(field.at(p).distance) < 1e-6) out.push_back(p);
  }
  return out;
}

TEST(FigureField, GradientIsTheSlopeOnTheSurface) {
  const MeasuredBody body = measured_body(0.0, 0.0, 0.5);
  const BodyField field(body);
  constexpr double h = 1e-6;
  std::size_t off = 0;
  const std::vector<Vec3> points = on_surface(field);
  for (const Vec3& p : points) {
    Vec3 slope;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 step(0.0);
      step[axis] = h;
      slope[axis] = (field.at(p + step).distance - field.at(p - step).distance) / (2.0 * h);
    }
    off += glm::length(slope - field.at(p).gradient) > 0.02 * glm::length(slope);
  }
  // In fillets neither part's own distance is 0, and there the cosine that turns radial into normal distance is taken
  // as constant; elsewhere the two are the same.
  EXPECT_LT(off, points.size() / 4);
}

TEST(FigureField, IsADistanceNearTheSurface) {
  const MeasuredBody body = measured_body(1.0, 0.0, 0.5);
  const BodyField field(body);
  double sum = 0.0;
  const std::vector<Vec3> points = on_surface(field);
  for (const Vec3& p : points) sum += glm::length(field.at(p).gradient);
  EXPECT_NEAR(sum / static_cast<double>(points.size()), 1.0, 0.1);
}

TEST(FigureField, IsMirrored) {
  const MeasuredBody body = measured_body(0.3, 0.5, 1.0);
  const BodyField field(body);
  for (const Vec3& p : {Vec3(0.1, 0.8, 0.05), Vec3(0.3, 0.6, 0.0), Vec3(0.08, 0.3, 0.03)}) {
    const FieldSample left = field.at(p), right = field.at({-p.x, p.y, p.z});
    EXPECT_EQ(left.distance, right.distance);
    EXPECT_EQ(left.gradient, Vec3(-right.gradient.x, right.gradient.y, right.gradient.z));
  }
}

}  // namespace
}  // namespace sinew
