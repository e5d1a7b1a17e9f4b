#include "engine/deform/bulge.h"

#include <cstring>

#include <gtest/gtest.h>

#include "engine/rig/joint_angle.h"
#include "tests/deform/patch.h"
#include "tests/support/test_character.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

/// Roundings of a dozen sums and products of numbers of size one.
constexpr double rounding = 1e-13;

constexpr BulgeMode modes[] = {BulgeMode::on, BulgeMode::paper};

Muscle tube_muscle() {
  Muscle muscle;
  muscle.name = "belly";
  muscle.bone = tube_upper;
  muscle.child = muscle.driver = tube_lower;
  muscle.tip = tube_hand;
  muscle.facing = {0, 0, 1};
  muscle.from = 0.25;
  muscle.to = 1.0;
  muscle.spread = 75;
  muscle.peak = 0.06;
  muscle.sigma = {0.2, 0.14};
  muscle.rest_angle = 170;
  muscle.reference_angle = 50;
  return muscle;
}

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// engine/definitions.md 6, written down once more and without a step of the engine's: the fades as polynomials of
/// clamped numbers.
double expected_height(const Muscle& m, const RegionVertex& v, double delta, BulgeMode mode) {
  const auto ease = [](double x) { return x <= 0 ? 0.0 : x >= 1 ? 1.0 : x * x * x + 3.0 * x * x * (1.0 - x); };
  const double gauss =
      std::exp(-v.x * v.x / (2 * m.sigma.x * m.sigma.x)) * std::exp(-v.y * v.y / (2 * m.sigma.y * m.sigma.y));
  if (mode == BulgeMode::paper) return delta * m.peak * gauss;
  const double quarter = 0.25 * (m.to - m.from);
  return delta * m.peak * gauss * ease((v.t - m.from) / quarter) * ease((m.to - v.t) / quarter) *
         ease(0.05 * (m.spread - v.angle)) * ease(4.0 * v.share - 2.0);
}

class Bulge : public testing::Test {
 protected:
  DeformedVertices bulged(const Pose& pose, double activation, BulgeMode mode) const {
    const ActiveMuscle active[] = {{muscle, region, activation}};
    return deformed(limb, pose, {.muscles = active, .bulge = mode});
  }
  DeformedVertices plain(const Pose& pose) const { return deformed(limb, pose, {.bulge = BulgeMode::off}); }
  std::vector<bool> inside() const {
    std::vector<bool> is(limb.mesh.vertices());
    for (const RegionVertex& v : region.vertices) is[v.vertex] = true;
    return is;
  }

  TestCharacter limb{tube({.rest_bend = 10})};
  Muscle muscle = tube_muscle();
  MuscleRegion region = limb.region(muscle);
  Pose pose = limb.turned(tube_lower, {80, 0, 0});
};

TEST_F(Bulge, LiftsTheRegionAlongTheSkinnedNormalByTheDefinitionsHeight) {
  const DeformedVertices before = plain(pose);
  for (const BulgeMode mode : modes) {
    const DeformedVertices after = bulged(pose, 0.7, mode);
    for (const RegionVertex& v : region.vertices) {
      const double height = expected_height(muscle, v, 0.7, mode);
      EXPECT_NEAR(after.heights[v.vertex], height, rounding);
      EXPECT_LT(glm::length(after.positions[v.vertex] - before.positions[v.vertex] - height * before.normals[v.vertex]),
                rounding);
      EXPECT_NEAR(glm::length(after.normals[v.vertex]), 1.0, rounding);
    }
  }
}

TEST_F(Bulge, OutsideTheRegionNoBitChanges) {
  const DeformedVertices before = plain(pose);
  const std::vector<bool> is_inside = inside();
  for (const BulgeMode mode : modes) {
    const DeformedVertices after = bulged(pose, 1.0, mode);
    std::size_t moved = 0;
    for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
      if (is_inside[v]) {
        moved += after.positions[v] != before.positions[v];
        continue;
      }
      EXPECT_TRUE(same_bits(after.positions[v], before.positions[v]));
      EXPECT_TRUE(same_bits(after.normals[v], before.normals[v]));
      EXPECT_TRUE(same_bits(after.heights[v], 0.0));
    }
    EXPECT_GT(moved, 30u);
  }
}

TEST_F(Bulge, AtTheRestAngleAndSwitchedOffNoBitChanges) {
  const DeformedVertices before = plain(pose);
  for (const DeformedVertices& after :
       {bulged(pose, 0.0, BulgeMode::on), bulged(pose, 0.0, BulgeMode::paper), bulged(pose, 1.0, BulgeMode::off)})
    for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
      EXPECT_TRUE(same_bits(after.positions[v], before.positions[v]));
      EXPECT_TRUE(same_bits(after.normals[v], before.normals[v]));
      EXPECT_EQ(after.heights[v], 0.0);
    }
}

TEST_F(Bulge, IsLinearInTheAngle) {
  // Nothing but delta changes with the angle: from the rest angle on, every 20 degrees add the same height.
  const JointAngle driver{tube_upper, tube_lower, tube_hand};
  const auto heights_at = [&](double bend) {
    const Pose bent = limb.turned(tube_lower, {bend - 10.0, 0, 0});
    const double angle = driver.degrees(global_transforms(limb.model, limb.order, bent));
    EXPECT_NEAR(angle, 180.0 - bend, 1e-10);
    return bulged(bent, muscle_activation(angle, muscle.rest_angle, muscle.reference_angle), BulgeMode::on).heights;
  };
  const std::vector<double> first = heights_at(30), whole = heights_at(130), none = heights_at(10),
                            beyond = heights_at(0);
  for (const int steps : {2, 3, 5, 6}) {
    const std::vector<double> heights = heights_at(10 + 20 * steps);
    for (const RegionVertex& v : region.vertices)
      EXPECT_NEAR(heights[v.vertex], steps * first[v.vertex], rounding) << 10 + 20 * steps;
  }
  for (const RegionVertex& v : region.vertices) {
    EXPECT_NEAR(whole[v.vertex], expected_height(muscle, v, 1.0, BulgeMode::on), rounding);
    EXPECT_NEAR(none[v.vertex], 0.0, rounding);
    EXPECT_EQ(beyond[v.vertex], 0.0) << "bent the other way nothing sinks in";
  }
}

TEST_F(Bulge, SeveralMusclesAddTheirHeights) {
  Muscle other = muscle;
  other.facing = {1, 0, 1};
  other.from = 0.0;
  other.peak = -0.02;
  const MuscleRegion other_region = limb.region(other);
  const ActiveMuscle both[] = {{muscle, region, 0.5}, {other, other_region, 1.0}},
                     second[] = {{other, other_region, 1.0}};
  for (const BulgeMode mode : modes) {
    const DeformedVertices before = plain(pose), a = bulged(pose, 0.5, mode),
                           b = deformed(limb, pose, {.muscles = second, .bulge = mode}),
                           sum = deformed(limb, pose, {.muscles = both, .bulge = mode});
    std::size_t shared = 0;
    for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
      shared += a.heights[v] * b.heights[v] != 0.0;
      EXPECT_NEAR(sum.heights[v], a.heights[v] + b.heights[v], rounding);
      EXPECT_LT(glm::length(sum.positions[v] - (a.positions[v] + b.positions[v] - before.positions[v])), rounding);
    }
    EXPECT_GT(shared, 10u);
  }
}

TEST_F(Bulge, MirroredInputGivesMirroredOutput) {
  muscle.facing = {0.4, 0, 1};
  region = limb.region(muscle);
  const TestCharacter image(mirrored(limb.model));
  Muscle image_muscle = muscle;
  image_muscle.facing = mirrored(muscle.facing);
  const MuscleRegion image_region = image.region(image_muscle);
  const ActiveMuscle active[] = {{image_muscle, image_region, 0.9}};
  for (const BulgeMode mode : modes) {
    const DeformedVertices a = bulged(limb.turned(tube_lower, {70, 20, 10}), 0.9, mode);
    const DeformedVertices b =
        deformed(image, image.turned(tube_lower, {70, -20, -10}), {.muscles = active, .bulge = mode});
    for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
      EXPECT_LT(glm::length(mirrored(a.positions[v]) - b.positions[v]), rounding);
      EXPECT_LT(glm::length(mirrored(a.normals[v]) - b.normals[v]), rounding);
      EXPECT_NEAR(a.heights[v], b.heights[v], rounding);
    }
  }
}

TEST_F(Bulge, ARigidMotionTakesTheBulgeAlong) {
  Random random(3);
  const Mat4 motion = random.rigid_motion();
  const ActiveMuscle active[] = {{muscle, region, 1.0}};
  for (const BulgeMode mode : modes) {
    const DeformedVertices here = bulged(pose, 1.0, mode);
    const DeformedVertices there = deformed(limb, pose, {.muscles = active, .bulge = mode, .placement = motion});
    for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
      EXPECT_LT(glm::length(there.positions[v] - Vec3(motion * Vec4(here.positions[v], 1))), rounding);
      EXPECT_LT(glm::length(there.normals[v] - Mat3(motion) * here.normals[v]), rounding);
      EXPECT_NEAR(there.heights[v], here.heights[v], rounding);
    }
  }
}

TEST_F(Bulge, RidesOnTheRigidSkinAsWell) {
  const ActiveMuscle active[] = {{muscle, region, 1.0}};
  const DeformedVertices before = deformed(limb, pose, {.bulge = BulgeMode::off, .deformer = Deformer::rigid});
  const DeformedVertices after = deformed(limb, pose, {.muscles = active, .deformer = Deformer::rigid});
  for (const RegionVertex& v : region.vertices)
    EXPECT_LT(glm::length(after.positions[v.vertex] - before.positions[v.vertex] -
                          expected_height(muscle, v, 1.0, BulgeMode::on) * before.normals[v.vertex]),
              rounding);
}

TEST_F(Bulge, SingularBlendsGiveNumbers) {
  // The elbow turned back on itself: weights of a half make blends of rank one, and others near it.
  for (const Vec3& turn : {Vec3(170, 0, 0), Vec3(0, 180, 0), Vec3(0, 0, 180)})
    for (const BulgeMode mode : modes) {
      const DeformedVertices out = bulged(limb.turned(tube_lower, turn), 2.0, mode);
      for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
        EXPECT_TRUE(std::isfinite(glm::length(out.positions[v])));
        EXPECT_NEAR(glm::length(out.normals[v]), 1.0, rounding);
      }
    }
}

/// Heights a hair to either side of a region's edge.
struct Step {
  double inside = 0.0, outside = 0.0;
};

/// The step at u = v = 0 of a surface that leaves the region there, growing u or v.
Step step_at(const Surface& surface, const Muscle& muscle, BulgeMode mode, bool along_v) {
  const TestCharacter pair(patch({.surface = surface, .low = {0, 0}, .high = {0, 0}, .samples = 1}));
  const MuscleRegion region = pair.region(muscle);
  const ActiveMuscle active[] = {{muscle, region, 1.0}};
  const std::vector<double> heights = deformed(pair, rest_pose(pair.model), {.muscles = active, .bulge = mode}).heights;
  return {heights[along_v ? 3 : 1], heights[along_v ? 4 : 2]};
}

TEST(BulgeEdge, ThePaperLeavesAStepAndTheDefaultNone) {
  Muscle muscle = patch_muscle();
  muscle.peak = 1.0;
  const auto end = [](double u, double v) { return Vec3(u, 0.9 + v, 0.25); };
  const double turn = 80 * degrees_to_radians;
  const auto side = [turn](double u, double v) {
    return Vec3(0.25 * std::sin(turn + u), 0.5 + v, 0.25 * std::cos(turn + u));
  };
  for (const auto& [surface, along_v] : {std::pair<Surface, bool>{end, true}, {side, false}}) {
    const Step paper = step_at(surface, muscle, BulgeMode::paper, along_v);
    EXPECT_NEAR(paper.inside, 1.0, 1e-6) << "all samples stand at the centre";
    EXPECT_EQ(paper.outside, 0.0);
    const Step faded = step_at(surface, muscle, BulgeMode::on, along_v);
    EXPECT_GT(faded.inside, 0.0);
    EXPECT_LT(faded.inside, 1e-7) << "a smoothstep rises by the square of a hair, 1e-5";
    EXPECT_EQ(faded.outside, 0.0);
  }
}

TEST(BulgeEdge, TheDefaultFadesWithTheShareOfTheSegment) {
  Muscle muscle = patch_muscle();
  muscle.peak = 1.0;
  const auto middle = [](double u, double v) { return Vec3(u, 0.5 + v, 0.25); };
  const std::pair<double, double> shares[] = {{0.5001, 0.0}, {0.625, 0.5}, {0.75, 1.0}, {1.0, 1.0}};
  for (const auto& [share, height] : shares) {
    std::vector<Influence> weights = sorted_run({{0, share}, {1, 1.0 - share}});
    const TestCharacter plate(
        patch({.surface = middle, .low = {0, 0}, .high = {0, 0}, .weights = weights, .samples = 1}));
    const MuscleRegion region = plate.region(muscle);
    const ActiveMuscle active[] = {{muscle, region, 1.0}};
    const Pose pose = rest_pose(plate.model);
    // The stencil is 1e-5 wide, and 0.5001 is not quite the edge: a smoothstep is then 5e-7 high.
    EXPECT_NEAR(deformed(plate, pose, {.muscles = active}).heights[0], height, 1e-6) << share;
    EXPECT_NEAR(deformed(plate, pose, {.muscles = active, .bulge = BulgeMode::paper}).heights[0], 1.0, 1e-6) << share;
  }
}

TEST(BulgeEdge, NoStepIsLeftOnAWholeLimb) {
  // The largest difference between neighbours, in peaks: where the swelling is continuous, neighbours twice as near to
  // each other differ half as much; a step stays what it is.
  const auto largest_jump = [&](std::size_t fineness, BulgeMode mode) {
    const TestCharacter limb(tube({.rows = 128 * fineness + 1, .columns = 48 * fineness}));
    const Muscle muscle = tube_muscle();
    const MuscleRegion region = limb.region(muscle);
    const ActiveMuscle active[] = {{muscle, region, 1.0}};
    const std::vector<double> heights =
        deformed(limb, rest_pose(limb.model), {.muscles = active, .bulge = mode}).heights;
    const std::vector<std::uint32_t>& corners = limb.mesh.triangles;
    double largest = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i)
      largest = std::max(largest, std::abs(heights[corners[i]] - heights[corners[i - i % 3 + (i + 1) % 3]]));
    return largest / muscle.peak;
  };
  EXPECT_LT(largest_jump(4, BulgeMode::on), 0.6 * largest_jump(2, BulgeMode::on));
  EXPECT_GT(largest_jump(4, BulgeMode::paper), 0.9 * largest_jump(2, BulgeMode::paper));
  EXPECT_GT(largest_jump(4, BulgeMode::paper), 0.1);
}

TEST(BulgeJob, HeightsOfAnEarlierPoseAreForgotten) {
  const std::vector<Vec3> bind_normals(2, Vec3(0, 0, 1));
  const std::vector<Mat3> blend(2, Mat3(1));
  for (const BulgeMode mode : {BulgeMode::off, BulgeMode::on, BulgeMode::paper}) {
    std::vector<Vec3> positions(2), normals = bind_normals;
    std::vector<double> heights = {0.5, -1.0};
    BulgeJob{{}, mode, bind_normals, blend, blend, positions, normals, heights}.run();
    EXPECT_EQ(heights, (std::vector<double>{0.0, 0.0}));
  }
}

TEST(BulgeJob, EveryInvalidSpanIsNamed) {
  struct Spans {
    std::vector<Vec3> bind_normals{4}, positions{4}, normals{4};
    std::vector<Mat3> rest_blend{4}, blend{4};
    std::vector<double> heights = std::vector<double>(4);
    MuscleRegion region;
  };
  const Muscle muscle = tube_muscle();
  const auto expect = [&](const char* what, auto spoil) {
    Spans s;
    s.bind_normals.resize(4);
    for (auto* list : {&s.bind_normals, &s.positions, &s.normals}) list->assign(4, Vec3(0, 0, 1));
    for (auto* list : {&s.rest_blend, &s.blend}) list->assign(4, Mat3(1));
    s.region.vertices.resize(2);
    s.region.vertices[1].vertex = 3;
    spoil(s);
    const ActiveMuscle active[] = {{muscle, s.region, 1.0}};
    const Result<void> result =
        BulgeJob{active, BulgeMode::on, s.bind_normals, s.rest_blend, s.blend, s.positions, s.normals, s.heights}
            .validate();
    if (*what == '\0') {
      EXPECT_TRUE(result);
      return;
    }
    ASSERT_FALSE(result) << what;
    EXPECT_EQ(result.error().kind, ErrorKind::bad_input);
    EXPECT_NE(result.error().message.find(what), std::string::npos) << result.error().message;
  };
  expect("", [](Spans&) {});
  expect("bind normals has 3 entries, expected 4", [](Spans& s) { s.bind_normals.pop_back(); });
  expect("rest blend has 3", [](Spans& s) { s.rest_blend.pop_back(); });
  expect("bulge: blend has 5", [](Spans& s) { s.blend.push_back({}); });
  expect("bulge: normals has 3", [](Spans& s) { s.normals.pop_back(); });
  expect("heights has 5", [](Spans& s) { s.heights.push_back(0); });
  expect("bind normals has 4 entries, expected 3", [](Spans& s) { s.positions.pop_back(); });
  expect("muscle \"belly\" names vertex 4, there are 4", [](Spans& s) { s.region.vertices[1].vertex = 4; });
}

}  // namespace
}  // namespace sinew::test
