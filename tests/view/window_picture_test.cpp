#include "engine/view/window_picture.h"

#include <gtest/gtest.h>

#include "tests/view/opened_document.h"

namespace sinew::test {
namespace {

Picture plain(std::uint8_t level) { return {4, 2, std::vector<std::uint8_t>(32, level)}; }

TEST(WindowPicture, SidesAreJoinedAtTheDivider) {
  Picture left = plain(1);
  join_sides(left, plain(9), 0.25);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x) EXPECT_EQ(left.rgba[static_cast<std::size_t>(4 * (4 * y + x))], x < 1 ? 1 : 9);
  join_sides(left, plain(5), 7.0);
  EXPECT_EQ(left.rgba[0], 1) << "nothing is right of the edge";
}

TEST(WindowPicture, WhatNeedsOtherSurfacesTouchesAll) {
  Document document = opened();
  Scene scene = document.scene();
  scene.look.overlay = {Overlay::skeleton};
  EXPECT_EQ(*document.edit(scene, "skeleton"), Touched::look);
  scene.look.overlay.push_back(Overlay::wire);
  EXPECT_EQ(*document.edit(scene, "wire"), Touched::all);
  scene.look.compare = CompareWith::deformer;
  EXPECT_EQ(*document.edit(scene, "compare"), Touched::all);
  EXPECT_EQ(*document.undo(), Touched::all);
}

TEST(WindowPicture, NumbersOfMusclesTouchNothingElse) {
  Document document = opened("builtin:woman");
  const Scene first = document.scene();
  Scene scene = first;
  scene.characters[0].muscles[1].peak = 0.03;
  EXPECT_EQ(*document.edit(scene, "peak"), Touched::muscles);
  EXPECT_EQ(document.stage().characters[0].muscles[1].muscle.peak, 0.03);
  scene.characters[0].muscles[0].on = false;
  EXPECT_EQ(*document.edit(scene, "off"), Touched::muscles);
  const auto opened_anew = [](const Scene& shown) {
    SceneOptions options;
    options.scene = "builtin:woman";
    Result<Stage> stage = open_stage(options);
    EXPECT_TRUE(stage && restage(*stage, shown, options));
    return std::move(*stage);
  };
  EXPECT_EQ(document.stage().scene_hash, opened_anew(scene).scene_hash);
  EXPECT_EQ(document.stage().problems, opened_anew(scene).problems);
  scene.characters[0].muscles[2].reference_angle = scene.characters[0].muscles[2].rest_angle;
  EXPECT_FALSE(document.edit(scene, "no range"));
  EXPECT_FALSE(document.scene().characters[0].muscles[0].on) << "as it was";
  scene = document.scene();
  set_joint_degrees(scene.characters[0], "leftLowerArm", 0, {0, -50, 0});
  scene.characters[0].muscles[0].peak = 0.01;
  EXPECT_EQ(*document.edit(scene, "both"), Touched::all);
  scene.characters[0].muscles.pop_back();
  EXPECT_EQ(*document.edit(scene, "fewer"), Touched::all);
  while (document.can_undo()) ASSERT_TRUE(document.undo());
  EXPECT_EQ(document.scene().characters[0].muscles, first.characters[0].muscles);
}

}  // namespace
}  // namespace sinew::test
