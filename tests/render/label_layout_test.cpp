#include "engine/render/label_layout.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(LabelLayout, LabelsKeepClearOfEachOtherAndOfTheEdge) {
  LabelLayout layout(400, 300);
  layout.avoid(Rect{{180, 140}, {220, 160}});
  std::vector<PlacedLabel> placed;
  for (int i = 0; i < 60; ++i)
    if (const auto label = layout.place({.anchor = {200.0 + 0.5 * i, 150.0 - 0.3 * i}, .size = {60.0, 14.0}}))
      placed.push_back(*label);
  EXPECT_GT(placed.size(), 5u);
  EXPECT_LT(placed.size(), 60u) << "what has no room is left out";
  for (std::size_t i = 0; i < placed.size(); ++i) {
    EXPECT_TRUE((Rect{Vec2(0.0), {400.0, 300.0}}).contains(placed[i].box));
    EXPECT_FALSE(placed[i].box.overlaps({{180, 140}, {220, 160}}));
    for (std::size_t k = 0; k < placed.size(); ++k) {
      if (k == i) continue;
      EXPECT_FALSE(placed[i].box.overlaps(placed[k].box)) << i << " " << k;
      EXPECT_FALSE(placed[i].leader && meets(placed[i].leader_from, placed[i].leader_to, placed[k].box));
    }
  }
}

TEST(LabelLayout, FarLabelsHaveLeadersThatBeginOutsideTheDot) {
  LabelLayout layout(400, 300);
  const LabelRequest request{.anchor = {200, 150}, .size = {60, 14}, .clearance = 8.0, .dot = 4.0};
  const auto near_label = layout.place(request);
  ASSERT_TRUE(near_label);
  EXPECT_FALSE(near_label->leader);
  EXPECT_GT(near_label->box.low.x, 200.0) << "on the side that was asked for";
  layout.avoid(Rect{{160, 120}, {240, 180}});
  const auto far_label = layout.place(request);
  ASSERT_TRUE(far_label);
  EXPECT_TRUE(far_label->leader);
  EXPECT_NEAR(glm::distance(far_label->leader_from, request.anchor), 4.0, 1e-9);
}

}  // namespace
}  // namespace sinew
