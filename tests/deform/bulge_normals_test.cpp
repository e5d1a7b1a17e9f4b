/// Normals of swollen skin: against the surface that the swollen vertices make.

#include <gtest/gtest.h>

#include "engine/deform/bulge.h"
#include "tests/deform/patch.h"

namespace sinew::test {
namespace {

constexpr BulgeMode modes[] = {BulgeMode::on, BulgeMode::paper};

/// Largest distance between the engine's unit normals and the stencils', over samples that the muscles swell.
/// `side`: -1 where rest pose or placement turn the surface inside out, and with it the stencils' sense.
double largest_normal_error(const TestCharacter& character, const DeformedVertices& out, double side = 1.0) {
  double largest = 0.0;
  std::size_t swollen = 0;
  for (std::size_t i = 0; 5 * i < character.mesh.vertices(); ++i) {
    bool inside = true;
    for (std::size_t k = 0; k < 5; ++k) inside = inside && out.heights[5 * i + k] != 0.0;
    if (!inside) continue;
    ++swollen;
    largest = std::max(largest, glm::length(out.normals[5 * i] - side * stencil_normal(out.positions, i)));
  }
  EXPECT_GT(swollen, 100u);
  return largest;
}

/// Central differences over 1e-5 of a surface with third derivatives of some hundreds: 1e-8; a hundred times that.
constexpr double difference_error = 1e-6;

TEST(BulgeNormals, OfAFlatPatchAreThoseOfTheSwollenSurface) {
  const TestCharacter plate(patch({.surface = flat}));
  const Muscle muscle = patch_muscle();
  const MuscleRegion region = plate.region(muscle);
  const ActiveMuscle active[] = {{muscle, region, 0.8}};
  for (const BulgeMode mode : modes) {
    const DeformedVertices out = deformed(plate, rest_pose(plate.model), {.muscles = active, .bulge = mode});
    EXPECT_LT(largest_normal_error(plate, out), difference_error);
    EXPECT_GT(largest_distance(out.normals, plate.rest.normals), 0.1) << "the swelling must be seen at all";
  }
}

TEST(BulgeNormals, HoldWherePoseAndRestScaleShearAndMirror) {
  Random random(2);
  struct Case {
    Transform bone_rest;
    Mat4 placement;
    double side;
  };
  const Case cases[] = {
      {{}, random.rigid_motion(), 1},
      {{random.vector(), random.rotation(), Vec3(1.5, 0.8, 1.2)}, Mat4(1.0), 1},
      {{random.vector(), random.rotation(), Vec3(0.7, 1.3, 0.9)}, random.rigid_motion(), 1},
      {{{}, random.rotation(), Vec3(-1, 1, 1)}, random.rigid_motion(), -1},
      {{{}, Quat(1, 0, 0, 0), Vec3(1)}, glm::scale(Mat4(1.0), {2, 0.5, -1}), -1},
  };
  for (const auto& [bone_rest, placement, side] : cases) {
    const TestCharacter plate(patch({.surface = flat, .bone_rest = bone_rest}));
    Muscle muscle = patch_muscle();
    // Tilted against the patch: the plane's axes are not the patch's, and the spread's fade is constant but not 1.
    muscle.facing = plate.rest.normals[0] + 2.0 * glm::cross(plate.rest.normals[0], random.vector());
    const MuscleRegion region = plate.region(muscle);
    const ActiveMuscle active[] = {{muscle, region, 1.3}};
    const Pose pose = plate.turned(patch_child, {25, 15, 40});  // blends two turns: the blend is no rotation
    for (const BulgeMode mode : modes) {
      const DeformedVertices out = deformed(plate, pose, {.muscles = active, .bulge = mode, .placement = placement});
      EXPECT_LT(largest_normal_error(plate, out, side), difference_error);
    }
  }
}

TEST(BulgeNormals, SeveralMusclesAddTheirSlopes) {
  const TestCharacter plate(patch({.surface = flat}));
  Muscle one = patch_muscle(), other = patch_muscle();
  other.facing = {0.5, 0.2, 1.0};
  other.sigma = {0.1, 0.3};
  other.peak = -0.03;
  const MuscleRegion one_region = plate.region(one), other_region = plate.region(other);
  const ActiveMuscle active[] = {{one, one_region, 1.0}, {other, other_region, 0.5}};
  for (const BulgeMode mode : modes)
    EXPECT_LT(largest_normal_error(
                  plate, deformed(plate, plate.turned(patch_child, {30, 0, 0}), {.muscles = active, .bulge = mode})),
              difference_error);
}

TEST(BulgeNormals, OfARoundLimbAreRightToFirstOrder) {
  // What is left out is the slope times the height times the curvature: second order in the peak. Within the spread
  // less its fade of 20 degrees, which normals do not follow: |u| <= 0.25 * 60 degrees.
  const TestCharacter limb(patch({.surface = round_limb, .low = {-0.26, 0.0}, .high = {0.26, 1.0}}));
  for (const BulgeMode mode : modes) {
    double errors[2];
    for (const int i : {0, 1}) {
      Muscle muscle = patch_muscle();
      muscle.peak = i == 0 ? 0.02 : 0.002;
      const MuscleRegion region = limb.region(muscle);
      const ActiveMuscle active[] = {{muscle, region, 1.0}};
      errors[i] = largest_normal_error(limb, deformed(limb, rest_pose(limb.model), {.muscles = active, .bulge = mode}));
    }
    EXPECT_LT(errors[0], 0.05);
    EXPECT_LT(errors[1], errors[0] / 80.0) << "a tenth of the peak is a hundredth of the error";
  }
}

TEST(BulgeNormals, FollowTheGradientOfTheHeight) {
  // Over a flat patch at rest the swollen surface is z = h(u, v) and its normal (-dh/du, -dh/dv, 1).
  const TestCharacter plate(patch({.surface = flat}));
  const Muscle muscle = patch_muscle();
  const MuscleRegion region = plate.region(muscle);
  const ActiveMuscle active[] = {{muscle, region, 1.0}};
  for (const BulgeMode mode : modes) {
    const DeformedVertices out = deformed(plate, rest_pose(plate.model), {.muscles = active, .bulge = mode});
    for (const RegionVertex& r : region.vertices) {
      if (r.vertex % 5 != 0 || out.heights[r.vertex + 3] * out.heights[r.vertex + 4] == 0.0) continue;
      const Vec2 slope = stencil_slope(out.heights, r.vertex / 5);
      const Vec3 n = out.normals[r.vertex];
      EXPECT_NEAR(-n.x / n.z, slope.x, difference_error);
      EXPECT_NEAR(-n.y / n.z, slope.y, difference_error);
    }
  }
}

TEST(BulgeNormals, HoldTheFadesOfSpreadAndShare) {
  // Only x, y and t have slopes (engine/definitions.md 6). On a limb so wide that all of it lies in the spread's fade,
  // the height also changes with the angle; the normal is that of a height that does not.
  const TestCharacter limb(patch({.surface = round_limb, .low = {0.01, 0.3}, .high = {0.05, 0.7}}));
  Muscle muscle = patch_muscle();
  muscle.spread = 15;
  muscle.peak = 1e-4;  // so small that the curvature's part is far below the slope's
  const MuscleRegion region = limb.region(muscle);
  const ActiveMuscle active[] = {{muscle, region, 1.0}};
  const DeformedVertices out = deformed(limb, rest_pose(limb.model), {.muscles = active});
  double largest_slope_left_out = 0.0;
  for (std::size_t i = 0; 5 * i < limb.mesh.vertices(); ++i) {
    const RegionVertex& r = region.vertices[5 * i];
    ASSERT_EQ(r.vertex, 5 * i);
    const double facing = std::cos(r.angle * degrees_to_radians);  // of the side's direction along the surface
    const double across = -r.y / (0.15 * 0.15) * out.heights[r.vertex] * facing;
    const Vec3 around = glm::normalize(limb.rest.positions[r.vertex + 2] - limb.rest.positions[r.vertex + 1]);
    const double side = glm::dot(around, region.plane.side) < 0 ? -1.0 : 1.0;
    EXPECT_NEAR(-glm::dot(out.normals[r.vertex], around), side * across, 1e-7);  // second order: (1e-4)^2 x curvature
    largest_slope_left_out =
        std::max(largest_slope_left_out, std::abs(stencil_slope(out.heights, i).x - side * across));
  }
  EXPECT_GT(largest_slope_left_out, 1e-4) << "there must be something to hold";
}

}  // namespace
}  // namespace sinew::test
