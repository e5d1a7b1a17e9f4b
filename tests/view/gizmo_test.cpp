#include "engine/view/gizmo.h"

#include <gtest/gtest.h>

#include "tests/view/opened_document.h"

namespace sinew::test {
namespace {

constexpr Vec2 size{800, 600};

/// A document with a camera before it.
struct Seen {
  Document document;
  Viewpoint viewpoint;
  Screen screen;
  std::vector<CharacterState> states;

  explicit Seen(Document opened, ViewDirection direction = {}, Rays rays = Rays::from_eye)
      : document(std::move(opened)),
        viewpoint(frame_box(rest_bounds(document.stage()), direction, size.x / size.y, rays)),
        screen(viewpoint, int(size.x), int(size.y)),
        states{character_state(document.stage(), 0, 0)} {}

  const StagedCharacter& character() const { return document.stage().characters[0]; }
  int node(const char* name) const { return *find_joint(*character().model, character().humanoid, name); }
  Vec3 place(int node) const { return Vec3(states[0].global[static_cast<std::size_t>(node)][3]); }
  Vec2 at(const char* name) const { return screen.point(place(node(name)))->at; }
  JointStand stand(const char* name) const {
    return joint_stand(document.stage(), 0, states[0], node(name), name, 0.0);
  }
  void turn(const char* name, const Vec3& degrees) {
    Scene scene = document.scene();
    set_joint_degrees(scene.characters[0], name, 0.0, degrees);
    ASSERT_TRUE(document.edit(scene, "turn"));
    states = {character_state(document.stage(), 0, 0)};
  }
};

TEST(Picking, ARayGoesThroughWhatIsSeenThere) {
  for (const Rays rays : {Rays::from_eye, Rays::parallel}) {
    const Seen seen(opened("builtin:woman"), {30.0, 10.0}, rays);
    for (const char* joint : {"leftHand", "head", "rightFoot"}) {
      const PointerRay ray = pointer_ray(seen.viewpoint, seen.at(joint), size);
      const Vec3 from = seen.place(seen.node(joint)) - ray.eye;
      EXPECT_LT(glm::length(from - glm::dot(from, ray.way) * ray.way), 1e-9) << joint;
      EXPECT_GT(glm::dot(from, ray.way), 0.0) << joint;
    }
  }
}

TEST(Picking, TheNearestJointWithinReach) {
  const Seen seen(opened("builtin:woman"));
  const Vec2 elbow = seen.at("leftLowerArm");
  const auto near = joint_near(seen.document.stage(), seen.states, 0, seen.screen, elbow + Vec2(4, -3), 10.0);
  ASSERT_TRUE(near);
  EXPECT_EQ(near->node, seen.node("leftLowerArm"));
  EXPECT_FALSE(joint_near(seen.document.stage(), seen.states, 0, seen.screen, {5, 5}, 10.0));
}

TEST(Picking, OfJointsOverEachOtherTheForemost) {
  // From the character's left its right side lies behind.
  const Seen seen(opened("builtin:woman"), {90.0, 0.0});
  const auto near = joint_near(seen.document.stage(), seen.states, 0, seen.screen, seen.at("leftLowerLeg"), 10.0);
  ASSERT_TRUE(near);
  EXPECT_EQ(near->node, seen.node("leftLowerLeg"));
}

TEST(Picking, TheSkinNamesItsBone) {
  const Seen seen(opened("builtin:woman"));
  const Vec3 thigh = glm::mix(seen.place(seen.node("rightUpperLeg")), seen.place(seen.node("rightLowerLeg")), 0.5);
  const PointerRay ray = pointer_ray(seen.viewpoint, seen.screen.point(thigh)->at, size);
  const auto picked = joint_of_skin(seen.document.stage(), seen.states, seen.document.options(), ray);
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->node, seen.node("rightUpperLeg"));
  EXPECT_FALSE(joint_of_skin(seen.document.stage(), seen.states, seen.document.options(),
                             pointer_ray(seen.viewpoint, {2, 2}, size)));
}

TEST(JointStand, SaysWhatAKeyWouldHaveToSay) {
  Seen seen(opened("builtin:woman"));
  seen.turn("leftUpperArm", {10, -20, 35});
  const JointStand keyed = seen.stand("leftUpperArm");
  EXPECT_LT(glm::distance(keyed.degrees, Vec3(10, -20, 35)), 1e-9);
  // The same read off the pose, as for a joint that a clip turns: no key has this name.
  const JointStand read =
      joint_stand(seen.document.stage(), 0, seen.states[0], seen.node("leftUpperArm"), "other", 0.0);
  EXPECT_LT(glm::distance(read.degrees, keyed.degrees), 1e-6);
  EXPECT_LT(glm::length(seen.stand("leftLowerArm").degrees), 1e-9);
}

TEST(Gizmo, EachRingTurnsItsNumber) {
  Seen seen(opened("builtin:woman"));
  seen.turn("leftUpperArm", {15, 20, -40});
  const Vec3 start(10, -35, 5);
  seen.turn("leftLowerArm", start);
  for (int ring = 0; ring < 3; ++ring) {
    const Gizmo gizmo = make_gizmo(seen.stand("leftLowerArm"), seen.viewpoint, size.y, 80.0);
    const Vec3 before = seen.place(seen.node("leftHand")) - gizmo.centre;
    Vec3 degrees = start;
    degrees[ring] += 25.0;
    seen.turn("leftLowerArm", degrees);
    const Vec3 after = seen.place(seen.node("leftHand")) - gizmo.centre;
    const Quat about = glm::angleAxis(25.0 * degrees_to_radians, gizmo.axes[static_cast<std::size_t>(ring)]);
    EXPECT_LT(glm::distance(about * before, after), 1e-9) << ring;
    seen.turn("leftLowerArm", start);
  }
}

TEST(Gizmo, IsAsLargeAsItIsAskedToBe) {
  for (const Rays rays : {Rays::from_eye, Rays::parallel}) {
    const Seen seen(opened("builtin:woman"), {}, rays);
    const Gizmo gizmo = make_gizmo(seen.stand("leftHand"), seen.viewpoint, size.y, 80.0);
    const auto centre = seen.screen.point(gizmo.centre),
               edge = seen.screen.point(gizmo.centre + gizmo.radius * seen.viewpoint.up);
    EXPECT_NEAR(glm::distance(centre->at, edge->at), 80.0, 1e-6);
  }
}

TEST(Gizmo, ARingFollowsThePointerRoundIt) {
  const Seen seen(opened("builtin:woman"));
  const Gizmo gizmo = make_gizmo(seen.stand("leftHand"), seen.viewpoint, size.y, 80.0);
  // The z ring faces the front camera.
  const Vec2 centre = seen.screen.point(gizmo.centre)->at;
  const auto round = [&](double degrees) {
    return centre + 80.0 * Vec2(std::cos(degrees * degrees_to_radians), -std::sin(degrees * degrees_to_radians));
  };
  EXPECT_EQ(ring_near(gizmo, seen.screen, round(190.0), 7.0), 2);
  RingDrag drag(gizmo, 2, seen.viewpoint, size, round(10.0));
  for (double a = 10.0; a <= 400.0; a += 5.0) drag.follow(round(a));
  // The eye is not on the ring's axis, so that the ring is seen a little askew.
  EXPECT_NEAR(drag.follow(round(400.0)), 390.0, 4.0) << "past a whole turn";
}

TEST(Gizmo, ARingSeenFromTheSideGoesWithThePointer) {
  const Seen seen(opened("builtin:woman"));
  const Gizmo gizmo = make_gizmo(seen.stand("leftHand"), seen.viewpoint, size.y, 80.0);
  const Vec2 centre = seen.screen.point(gizmo.centre)->at;
  // About y, whose front half is a nearly straight line across the picture: to the right is counter-clockwise from
  // above.
  RingDrag drag(gizmo, 1, seen.viewpoint, size, centre);
  EXPECT_NEAR(drag.follow(centre + Vec2(8.0, 0.0)), 8.0 / 80.0 * radians_to_degrees, 0.3);
  EXPECT_NEAR(drag.follow(centre), 0.0, 1e-9);
}

TEST(Gizmo, NumbersStayInTheirRange) {
  const DegreeRange range{-12.0, 148.0};
  EXPECT_EQ(turned_number(10.0, 999.0, range, false), 148.0);
  EXPECT_EQ(turned_number(10.0, 999.0, range, true), 145.0);
  EXPECT_EQ(turned_number(10.0, -999.0, range, true), -10.0);
  EXPECT_EQ(turned_number(10.0, 11.0, range, true), 20.0);
}

TEST(Reach, WritesKeysThatBringTheHandThere) {
  Seen seen(opened("builtin:woman"));
  const auto limb = find_limb(*seen.character().model, seen.character().humanoid, seen.character().rest.global,
                              HumanoidBone::left_hand);
  ASSERT_TRUE(limb);
  const Vec3 shoulder = seen.place(limb->upper);
  const Vec3 target = shoulder + 0.7 * (seen.place(limb->end) - shoulder) + Vec3(0.0, 0.0, 0.1);
  Scene scene = seen.document.scene();
  ASSERT_TRUE(reach_with(seen.document.stage(), 0, seen.states[0], *limb, target, 0.0, scene.characters[0]));
  EXPECT_EQ(*seen.document.edit(scene, "reach"), Touched::poses);
  EXPECT_EQ(seen.document.scene().characters[0].keys.size(), 2u);
  seen.states = {character_state(seen.document.stage(), 0, 0)};
  // Keys are rounded to a hundredth of a degree: half of that on half a metre, twice.
  EXPECT_LT(glm::distance(seen.place(limb->end), target), 1e-4);
}

}  // namespace
}  // namespace sinew::test
