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

}  // namespace
}  // namespace sinew::test
