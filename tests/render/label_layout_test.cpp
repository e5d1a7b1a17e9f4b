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

TEST(LabelLayout, SpreadsNeighboursApart) {
  const std::vector<double> apart{0.0, 10.0, 30.0}, close{0.0, 1.0, 2.0, 50.0};
  EXPECT_EQ(spread_apart(apart, 10.0), apart);
  // Three that crowd stand about their mean; the fourth has room.
  const std::vector<double> spread = spread_apart(close, 10.0);
  const double expected[] = {-9.0, 1.0, 11.0, 50.0};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(spread[i], expected[i], 1e-12);
  // Where pools meet they move together: least squares leaves no pull on the whole.
  const std::vector<double> chained{0.0, 1.0, 12.0};
  const std::vector<double> moved = spread_apart(chained, 10.0);
  double pull = 0.0;
  for (std::size_t i = 0; i < 3; ++i) pull += moved[i] - chained[i];
  EXPECT_NEAR(pull, 0.0, 1e-12);
  for (std::size_t i = 1; i < 3; ++i) EXPECT_GE(moved[i] - moved[i - 1], 10.0 - 1e-12);
  EXPECT_TRUE(spread_apart({}, 10.0).empty());
}

}  // namespace
}  // namespace sinew
