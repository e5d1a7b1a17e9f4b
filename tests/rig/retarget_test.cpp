/// Motions on other bodies: limbs point where the source's do, lengths and floors fit, twist is shared out.

#include <functional>

#include <gtest/gtest.h>

#include "engine/body/figure.h"
#include "engine/core/euler.h"
#include "engine/io/gltf_read.h"
#include "engine/model/character_mesh.h"
#include "engine/rig/clip_motion.h"
#include "engine/rig/clip_sampling.h"
#include "engine/rig/foot_contact.h"
#include "engine/rig/limb_twist.h"
#include "engine/rig/motion_file.h"
#include "engine/rig/motion_rig.h"
#include "engine/rig/pose.h"
#include "engine/rig/retarget.h"
#include "tests/support/assets.h"

namespace sinew::test {
namespace {

using enum HumanoidBone;

struct Body {
  explicit Body(Model read) : model(std::move(read)), order(hierarchy_order(model)) {
    rest = global_transforms(model, order, rest_pose(model));
    humanoid = find_humanoid(model, rest);
  }
  std::vector<Mat4> at(const Clip& clip, double seconds) const {
    Pose pose = rest_pose(model);
    sample_clip(clip, seconds, pose);
    return global_transforms(model, order, pose);
  }
  Model model;
  std::vector<int> order;
  std::vector<Mat4> rest;
  Humanoid humanoid;
};

constexpr std::pair<HumanoidBone, HumanoidBone> limbs[] = {
    {left_upper_arm, left_lower_arm},   {left_lower_arm, left_hand},        {left_upper_leg, left_lower_leg},
    {left_lower_leg, left_foot},        {right_upper_arm, right_lower_arm}, {right_lower_arm, right_hand},
    {right_upper_leg, right_lower_leg}, {right_lower_leg, right_foot},
};

struct LimbError {
  double degrees = 0.0;
  std::string where;
};

/// The worst difference of a limb's direction, in the world and against the pelvis alike: the pelvis' own turn from
/// rest is the same, so that the world's directions say both.
LimbError worst_limb(const Motion& motion, const Body& body, const Clip& clip) {
  const MotionRig rig = motion_rig(motion);
  LimbError worst;
  for (std::size_t f = 0; f < motion.frames.size(); ++f) {
    const MotionPose source = motion_pose(motion, f);
    const std::vector<Mat4> global = body.at(clip, static_cast<double>(f) * motion.frame_time);
    for (const auto& [from, to] : limbs) {
      const Vec3 wanted = source.places[rig.humanoid.find(to)] - source.places[rig.humanoid.find(from)];
      const Vec3 found(global[body.humanoid.find(to)][3] - global[body.humanoid.find(from)][3]);
      const double error = angle_degrees(wanted, found);
      if (error > worst.degrees) worst = {error, fmt::format("{} at frame {}", humanoid_name(from), f)};
    }
  }
  return worst;
}

Motion cmu(const std::filesystem::path& assets, const char* file = "01_01.bvh") {
  auto motion = read_motion(assets / "motions" / file);
  EXPECT_TRUE(motion) << (motion ? "" : motion.error().message);
  return motion ? std::move(*motion) : Motion{};
}

TEST(Retarget, LimbsOfEveryHumanoidPointAsInTheCapture) {
  SINEW_ASSETS_OR_SKIP(folder);
  const Motion motion = cmu(folder);
  ASSERT_EQ(motion.frames.size(), 2752u);
  int bodies = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "characters")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".glb" && extension != ".gltf") continue;
    auto model = read_gltf(entry.path());
    if (!model) continue;
    const Body body(std::move(*model));
    if (!body.humanoid.complete()) continue;
    ++bodies;
    const auto retargeted = retarget(motion, body.model, body.humanoid);
    ASSERT_TRUE(retargeted) << retargeted.error().message;
    const LimbError worst = worst_limb(motion, body, retargeted->clip);
    EXPECT_LE(worst.degrees, 1.0) << entry.path() << ": " << worst.where;
    std::printf("%-32s limbs %.4f degrees, foot %.4f under the floor before lifting, scale %.4f\n",
                entry.path().filename().c_str(), worst.degrees, retargeted->deepest_sinking, retargeted->scale);
  }
  EXPECT_GE(bodies, 10);
}

TEST(Retarget, LimbsOfFiguresPointAsInTheCapture) {
  SINEW_ASSETS_OR_SKIP(folder);
  const Motion motion = cmu(folder, "cmu_12_01_walk.bvh");
  for (const int joints : {23, 37, 68}) {
    BodyOptions options;
    options.joints = joints;
    options.vertices = 2000;
    auto model = build_figure(options);
    ASSERT_TRUE(model);
    const Body body(std::move(*model));
    const auto retargeted = retarget(motion, body.model, body.humanoid);
    ASSERT_TRUE(retargeted) << retargeted.error().message;
    const LimbError worst = worst_limb(motion, body, retargeted->clip);
    EXPECT_LE(worst.degrees, 1.0) << joints << " joints: " << worst.where;
    std::printf("figure of %d joints: limbs %.4f degrees, foot %.4f under the floor before lifting\n", joints,
                worst.degrees, retargeted->deepest_sinking);
  }
}

TEST(Retarget, FeetStayOnTheFloorAndReachIt) {
  SINEW_ASSETS_OR_SKIP(folder);
  const Motion motion = cmu(folder, "cmu_12_01_walk.bvh");
  auto model = read_gltf(folder / "characters/makehuman/mh_male_game.glb");
  ASSERT_TRUE(model);
  const Body body(std::move(*model));
  const auto retargeted = retarget(motion, body.model, body.humanoid);
  ASSERT_TRUE(retargeted);
  const FootContact feet(body.model, body.humanoid, body.rest);
  EXPECT_NEAR(feet.height(body.rest), 0.0, 0.01);  // bare feet stand on their soles
  double lowest = INFINITY, highest = -INFINITY;
  for (std::size_t f = 0; f < motion.frames.size(); ++f) {
    const double height = feet.height(body.at(retargeted->clip, static_cast<double>(f) * motion.frame_time));
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  EXPECT_GE(lowest, -1e-9);
  // A walker always has a foot on the ground: 5 cm is the give of a foot that another skeleton measured.
  EXPECT_LE(highest, 0.05);
  std::printf("feet between %.4f and %.4f m\n", lowest, highest);
}

/// One arm bone's worth of a humanoid motion: the figure's own skeleton, standing, then posed.
Motion own_motion(const Body& body, const std::function<void(Pose&)>& posed) {
  Clip clip{"own", {}, 1.0};
  Pose before = rest_pose(body.model), after = before;
  posed(after);
  for (std::size_t i = 0; i < body.model.nodes.size(); ++i) {
    const Quat a = before.local[i].rotation, b = after.local[i].rotation;
    clip.channels.push_back({static_cast<int>(i),
                             ChannelPath::rotation,
                             Interpolation::linear,
                             4,
                             {0.0, 1.0},
                             {a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w}});
  }
  auto motion = motion_from_clip(body.model, clip);
  EXPECT_TRUE(motion);
  return motion ? std::move(*motion) : Motion{};
}

TEST(Retarget, OntoItselfChangesNothing) {
  BodyOptions options;
  options.joints = 23;
  options.vertices = 2000;
  auto model = build_figure(options);
  ASSERT_TRUE(model);
  const Body body(std::move(*model));
  const std::vector<Quat> rest = rest_rotations(body.model, body.order);
  const Motion motion = own_motion(body, [&](Pose& pose) {
    turn_joint(body.model, rest, body.humanoid.find(left_upper_arm), {20, -30, 40}, pose);
    turn_joint(body.model, rest, body.humanoid.find(spine), {10, 5, -5}, pose);
    turn_joint(body.model, rest, body.humanoid.find(right_lower_leg), {50, 0, 0}, pose);
  });
  const auto retargeted = retarget(motion, body.model, body.humanoid, {.lift_feet = false});
  ASSERT_TRUE(retargeted) << retargeted.error().message;
  EXPECT_NEAR(retargeted->scale, 1.0, 1e-12);
  const MotionPose last = motion_pose(motion, motion.frames.size() - 1);
  const std::vector<Mat4> global = body.at(retargeted->clip, motion.duration());
  const Vec3 hip_shift = Vec3(global[body.humanoid.find(hips)][3]) - last.places[0];
  for (std::size_t j = 0; j < motion.skeleton.joints.size(); ++j) {
    const auto node = find_joint(body.model, body.humanoid, motion.skeleton.joints[j].name);
    ASSERT_TRUE(node);
    EXPECT_LT(glm::length(Vec3(global[*node][3]) - hip_shift - last.places[j]), 1e-6) << motion.skeleton.joints[j].name;
  }
}

TEST(Retarget, AFileWithZUpStandsUp) {
  SINEW_ASSETS_OR_SKIP(folder);
  for (const char* file : {"pybvh/bvh_test1.bvh", "pybvh/bvh_test3.bvh", "01_01.bvh"}) {
    const Motion motion = cmu(folder, file);
    auto model = read_gltf(folder / "characters/makehuman/mh_male_game.glb");
    ASSERT_TRUE(model);
    const Body body(std::move(*model));
    const auto retargeted = retarget(motion, body.model, body.humanoid);
    ASSERT_TRUE(retargeted);
    const std::vector<Mat4> global = body.at(retargeted->clip, motion.duration() / 2);
    EXPECT_GT(global[body.humanoid.find(head)][3].y, 1.2) << file;
  }
}

TEST(Retarget, RefusesBodiesWithoutHips) {
  Motion motion;
  motion.skeleton.joints = {{.name = "thing", .channels = {}, .end = {}}};
  motion.frames = {{Vec3(0), {Quat(1, 0, 0, 0)}, {}}};
  auto model = build_figure({.vertices = 2000});
  ASSERT_TRUE(model);
  const Body body(std::move(*model));
  const auto retargeted = retarget(motion, body.model, body.humanoid);
  ASSERT_FALSE(retargeted);
  EXPECT_EQ(retargeted.error().kind, ErrorKind::bad_input);
  EXPECT_NE(retargeted.error().message.find("thing"), std::string::npos) << retargeted.error().message;
}

TEST(LimbTwist, TurnsAboutTheAxisAreFoundAndFadeWhereTheyJump) {
  const Vec3 axis(0, 1, 0);
  EXPECT_NEAR(twist_degrees(axis_rotation(1, 0.7), axis), 0.7 * radians_to_degrees, 1e-9);
  // A swing before it does not count.
  EXPECT_NEAR(twist_degrees(axis_rotation(2, 1.0) * axis_rotation(1, -0.4), axis), -0.4 * radians_to_degrees, 1e-9);
  EXPECT_NEAR(twist_degrees(axis_rotation(2, 179.999 * degrees_to_radians) * axis_rotation(1, 0.5), axis), 0.0, 1e-3);
  EXPECT_NEAR(twist_degrees(axis_rotation(1, 179.999 * degrees_to_radians), axis), 0.0, 1e-3);
}

TEST(LimbTwist, AForearmsTurnIsSharedInEqualStepsAndKeepsTheHand) {
  auto model = build_figure({.joints = 68, .vertices = 2000});
  ASSERT_TRUE(model);
  const Body body(std::move(*model));
  const std::vector<Quat> rest = rest_rotations(body.model, body.order);
  const int elbow = body.humanoid.find(left_lower_arm), hand = body.humanoid.find(left_hand);
  const int twist = *find_joint(body.model, body.humanoid, "l_forearm_twist");
  const auto segments = twist_segments(body.model, body.humanoid, body.rest);
  const auto segment = std::find_if(segments.begin(), segments.end(), [&](const auto& s) { return s.bone == elbow; });
  ASSERT_NE(segment, segments.end());
  ASSERT_EQ(segment->between, std::vector<int>{twist});
  const Vec3 along = glm::normalize(Vec3(body.rest[hand][3] - body.rest[elbow][3]));
  std::vector<Quat> turned = rest;
  turned[hand] = glm::angleAxis(60 * degrees_to_radians, along) * rest[hand];
  const Quat wanted_hand = turned[hand];
  share_twist(body.model, *segment, rest, body.rest, turned);
  const auto turn = [&](int node) { return twist_degrees(turned[node] * glm::conjugate(rest[node]), along); };
  EXPECT_NEAR(turn(elbow), 20.0, 1e-9);
  EXPECT_NEAR(turn(twist), 40.0, 1e-9);
  EXPECT_NEAR(turn(hand), 60.0, 1e-9);
  EXPECT_NEAR(std::abs(glm::dot(turned[hand], wanted_hand)), 1.0, 1e-12);
}

TEST(SmoothLift, CoversEverySinkingWithoutJerks) {
  std::vector<double> heights(60, 0.05);
  heights[30] = -0.02;
  heights[31] = -0.03;
  const std::vector<double> lift = smooth_lift(heights, 5);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    EXPECT_GE(heights[i] + lift[i], -1e-12);
    if (i > 0) {
      EXPECT_LE(std::abs(lift[i] - lift[i - 1]), 0.03 / 11 + 1e-12) << i;
    }
  }
  EXPECT_EQ(lift[10], 0.0);
  EXPECT_EQ(lift[50], 0.0);
}

}  // namespace
}  // namespace sinew::test
