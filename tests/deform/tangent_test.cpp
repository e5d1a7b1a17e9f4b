/// Tangents of posed skin: against the surface that the posed vertices make.

#include <gtest/gtest.h>

#include "engine/deform/bulge.h"
#include "engine/deform/skin_output.h"
#include "tests/deform/dense_skin.h"
#include "tests/deform/patch.h"
#include "tests/deform/swelling_tube.h"

namespace sinew::test {
namespace {

constexpr BulgeMode modes[] = {BulgeMode::on, BulgeMode::paper};
/// Roundings of a dozen sums and products of numbers of size one.
constexpr double rounding = 1e-13;
/// Central differences over 1e-5 of a surface with third derivatives of some hundreds: 1e-8; a hundred times that.
constexpr double difference_error = 1e-6;

/// A picture that lies upright on a patch, u and v of the patch to the right and up: tangents along u, w = 1.
TestCharacter textured(const PatchShape& shape) {
  TestCharacter character(patch(shape));
  for (std::size_t v = 0; v < character.mesh.vertices(); ++v) {
    const Vec3* p = &character.mesh.positions[v - v % 5];
    character.mesh.tangents.push_back(tangent_in_plane(Vec4(p[2] - p[1], 1.0), character.mesh.normals[v]));
  }
  return character;
}

struct Differences {
  double along = 0.0;       ///< largest distance of a tangent from the unit derivative of the posed surface along u
  std::size_t samples = 0;  ///< that were looked at
};

/// Of the samples that the muscles swell, or of all. Checks on the way what every tangent holds to.
Differences differences(const TestCharacter& character, const DeformedVertices& out, bool swollen) {
  Differences d;
  EXPECT_EQ(out.tangents.size(), character.mesh.vertices());
  for (std::size_t i = 0; 5 * i < out.tangents.size(); ++i) {
    bool inside = true;
    for (std::size_t k = 0; k < 5; ++k) inside = inside && out.heights[5 * i + k] != 0.0;
    if (swollen && !inside) continue;
    const Vec3* p = &out.positions[5 * i];
    const Vec4& tangent = out.tangents[5 * i];
    const Vec3 normal = out.normals[5 * i];
    ++d.samples;
    d.along = std::max(d.along, glm::length(Vec3(tangent) - glm::normalize(p[2] - p[1])));
    EXPECT_NEAR(glm::length(Vec3(tangent)), 1.0, rounding);
    EXPECT_NEAR(glm::dot(Vec3(tangent), normal), 0.0, rounding);
    EXPECT_GT(tangent.w * glm::dot(glm::cross(normal, Vec3(tangent)), p[4] - p[3]), 0.0)
        << "the bitangent goes up in the picture";
  }
  return d;
}

/// Placements and rest poses that turn, scale, shear and mirror.
struct Setting {
  Transform bone_rest;
  Mat4 placement;
};

std::vector<Setting> settings() {
  Random random(2);
  return {{{}, Mat4(1.0)},
          {{}, random.rigid_motion()},
          {{random.vector(), random.rotation(), Vec3(1.5, 0.8, 1.2)}, Mat4(1.0)},
          {{random.vector(), random.rotation(), Vec3(0.7, 1.3, 0.9)}, random.rigid_motion()},
          {{{}, random.rotation(), Vec3(-1, 1, 1)}, random.rigid_motion()},
          {{}, glm::scale(Mat4(1.0), {2, 0.5, -1})}};
}

TEST(CarryTangent, GoesByTheBlendItself) {
  Random random(4);
  int mirroring = 0;
  for (int i = 0; i < 100; ++i) {
    const Mat3 blend(random.vector(), random.vector(), random.vector());
    const Vec4 tangent(random.vector(), i % 2 == 0 ? 1.0 : -1.0), carried = carry_tangent(blend, tangent);
    EXPECT_LT(glm::length(Vec3(carried) - plain(eigen(blend) * eigen(Vec3(tangent)))), rounding);
    const bool mirrors = eigen(blend).determinant() < 0;
    EXPECT_EQ(carried.w, mirrors ? -tangent.w : tangent.w);
    mirroring += mirrors;
    // What lies in the surface stays in it: at right angles to the normal that goes with the inverse transpose.
    const Vec3 normal = glm::normalize(random.vector());
    const Vec4 inside = carry_tangent(blend, tangent_in_plane(tangent, normal));
    EXPECT_NEAR(glm::dot(Vec3(inside), carry_normal(blend, normal)), 0.0, rounding);
  }
  EXPECT_GT(mirroring, 20);
  EXPECT_LT(mirroring, 80);
}

TEST(TangentInPlane, IsTheUnitPartAtRightAnglesToTheNormal) {
  const Vec4 tangent = tangent_in_plane({3, 4, 5, -1}, {0, 0, 1});
  EXPECT_LT(glm::length(tangent - Vec4(0.6, 0.8, 0, -1)), rounding);
  EXPECT_EQ(tangent_in_plane({0, 0, 7, 1}, {0, 0, 1}), Vec4(0, 0, 0, 1)) << "nothing is left of it";
  EXPECT_EQ(tangent_in_plane({0, 0, 0, -1}, {0, 1, 0}), Vec4(0, 0, 0, -1));
  const Vec4 tiny = tangent_in_plane(Vec4(1e-20, 0, 0, 1), {0, 0, 1});
  EXPECT_LT(glm::length(tiny - Vec4(1, 0, 0, 1)), rounding) << "its length does not matter";
}

TEST(Tangents, OfPosedSkinAreTheSurfacesDerivativeAlongU) {
  for (const Deformer deformer : {Deformer::rigid, Deformer::ssd})
    for (const Setting& setting : settings()) {
      const TestCharacter limb = textured({.surface = round_limb, .bone_rest = setting.bone_rest});
      for (const Vec3& turn : {Vec3(0), Vec3(25, 15, 40), Vec3(120, -30, 10)}) {
        const DeformedVertices out =
            deformed(limb, limb.turned(patch_child, turn), {.deformer = deformer, .placement = setting.placement});
        const Differences d = differences(limb, out, false);
        EXPECT_EQ(d.samples, 300u);
        EXPECT_LT(d.along, difference_error);
      }
    }
}

TEST(Tangents, OfSwollenSkinAreTheSwollenSurfacesDerivativeAlongU) {
  for (const Deformer deformer : {Deformer::rigid, Deformer::ssd})
    for (const Setting& setting : settings()) {
      const TestCharacter plate = textured({.surface = flat, .bone_rest = setting.bone_rest});
      Muscle one = patch_muscle(), other = patch_muscle();
      // Tilted against the patch: the plane's axes are not the patch's, and the spread's fade is constant but not 1.
      one.facing = plate.rest.normals[0] + 0.5 * glm::cross(plate.rest.normals[0], Vec3(0.3, 0.8, 0.4));
      other.facing = plate.rest.normals[0];
      other.sigma = {0.1, 0.3};
      other.peak = -0.03;
      const MuscleRegion one_region = plate.region(one), other_region = plate.region(other);
      const ActiveMuscle active[] = {{one, one_region, 1.3}, {other, other_region, 0.5}};
      for (const BulgeMode mode : modes) {
        const Pose pose = plate.turned(patch_child, {25, 15, 40});
        const Deforming how{.muscles = active, .bulge = mode, .deformer = deformer, .placement = setting.placement};
        const DeformedVertices out = deformed(plate, pose, how);
        const Differences d = differences(plate, out, true);
        EXPECT_GT(d.samples, 100u);
        EXPECT_LT(d.along, difference_error);
        Deforming skin_only = how;
        skin_only.bulge = BulgeMode::off;
        const DeformedVertices skin = deformed(plate, pose, skin_only);
        double tilt = 0.0;
        for (std::size_t v = 0; v < out.tangents.size(); ++v)
          tilt = std::max(tilt, glm::length(out.tangents[v] - skin.tangents[v]));
        EXPECT_GT(tilt, 0.1) << "the swelling must be seen at all";
      }
    }
}

TEST(Tangents, OfASwollenRoundLimbAreRightToFirstOrder) {
  // What is left out is the height times the curvature along u: second order in the peak, as slope times height.
  const TestCharacter limb = textured({.surface = round_limb, .low = {-0.26, 0.0}, .high = {0.26, 1.0}});
  for (const BulgeMode mode : modes) {
    double errors[2];
    for (const int i : {0, 1}) {
      Muscle muscle = patch_muscle();
      muscle.peak = i == 0 ? 0.02 : 0.002;
      const MuscleRegion region = limb.region(muscle);
      const ActiveMuscle active[] = {{muscle, region, 1.0}};
      const DeformedVertices out = deformed(limb, rest_pose(limb.model), {.muscles = active, .bulge = mode});
      errors[i] = differences(limb, out, true).along;
    }
    EXPECT_LT(errors[0], 0.05);
    EXPECT_LT(errors[1], errors[0] / 80.0) << "a tenth of the peak is a hundredth of the error";
  }
}

/// Where weights change over the surface the blend counts as held, for tangents as for normals.
TEST(Tangents, GoByTheBlendOfTheirVertexWhereWeightsChange) {
  TestCharacter limb(swelling_tube(0.0));
  Random random(9);
  for (std::size_t v = 0; v < limb.mesh.vertices(); ++v)
    limb.mesh.tangents.push_back(
        tangent_in_plane(Vec4(random.vector(), v % 2 == 0 ? 1.0 : -1.0), limb.mesh.normals[v]));
  Pose pose = limb.turned(tube_lower, {60, 10, 0});
  pose.morph_weights[tube_skin] = {1.5};
  const DeformedVertices out = deformed(limb, pose);
  const std::vector<Mat34> palette = limb.palette(pose);
  const Eigen::MatrixXd weights = dense_weights(limb.mesh.influences, palette.size());
  ASSERT_EQ(out.tangents.size(), limb.mesh.vertices());
  for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
    const Eigen::Matrix3d blend = dense_blend(weights, palette, v).topLeftCorner<3, 3>();
    const Eigen::Vector3d normal = eigen(out.normals[v]);  // of the morphed skin
    const Eigen::Matrix3d into_plane = Eigen::Matrix3d::Identity() - normal * normal.transpose();
    const Eigen::Vector3d expected = (into_plane * blend * eigen(Vec3(limb.mesh.tangents[v]))).normalized();
    EXPECT_LT(glm::length(Vec3(out.tangents[v]) - plain(expected)), 1e-12);  // over a blend that shrinks to a half
    EXPECT_EQ(out.tangents[v].w, limb.mesh.tangents[v].w);
  }
}

TEST(Tangents, AreNoneWhereTheMeshHasNone) {
  const TestCharacter plate(patch({.surface = flat}));
  const Muscle muscle = patch_muscle();
  const MuscleRegion region = plate.region(muscle);
  const ActiveMuscle active[] = {{muscle, region, 1.0}};
  EXPECT_TRUE(deformed(plate, rest_pose(plate.model), {.muscles = active}).tangents.empty());
}

TEST(Tangents, DoNotChangeWhatElseIsDeformed) {
  const TestCharacter with = textured({.surface = flat}), without(patch({.surface = flat}));
  const Muscle muscle = patch_muscle();
  const MuscleRegion region = with.region(muscle);
  const ActiveMuscle active[] = {{muscle, region, 1.0}};
  const Pose pose = with.turned(patch_child, {25, 15, 40});
  const DeformedVertices a = deformed(with, pose, {.muscles = active}),
                         b = deformed(without, pose, {.muscles = active});
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.normals, b.normals);
}

TEST(Tangents, ABulgeSaysWhichSpanIsShort) {
  std::vector<Vec3> some(4, Vec3(0, 0, 1));
  std::vector<Mat3> blends(4, Mat3(1.0));
  std::vector<double> heights(4);
  std::vector<Vec4> four(4, Vec4(1, 0, 0, 1)), three(3, Vec4(1, 0, 0, 1));
  const auto job = [&](std::span<const Vec4> bind, std::span<Vec4> posed) {
    return BulgeJob{{}, BulgeMode::on, some, blends, blends, some, some, heights, bind, posed}.validate();
  };
  EXPECT_TRUE(job({}, {}));
  EXPECT_TRUE(job(four, four));
  for (const auto& refused : {job(three, three), job(four, three), job(four, {}), job(three, four)}) {
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("bulge: tangents have"), std::string::npos) << refused.error().message;
  }
}

}  // namespace
}  // namespace sinew::test
