#include "engine/view/interface_changes.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace sinew::test {
namespace {

constexpr PixelBox panel{100, 50, 400, 250};

/// A draw list of triangles over boxes, as ImGui makes them.
class Drawn {
 public:
  void box(float left, float top, float right, float bottom, ImU32 colour = IM_COL32_WHITE,
           ImVec4 clip = {0, 0, 2000, 2000}) {
    ImDrawCmd command;
    command.ClipRect = clip;
    command.IdxOffset = static_cast<unsigned>(list_.IdxBuffer.Size);
    command.ElemCount = 6;
    const auto first = static_cast<ImDrawIdx>(list_.VtxBuffer.Size);
    for (const auto& [x, y] : {std::pair{left, top}, {right, top}, {right, bottom}, {left, bottom}})
      list_.VtxBuffer.push_back({{x, y}, {0, 0}, colour});
    for (const int corner : {0, 1, 2, 0, 2, 3})
      list_.IdxBuffer.push_back(static_cast<ImDrawIdx>(first + static_cast<ImDrawIdx>(corner)));
    list_.CmdBuffer.push_back(command);
  }
  PixelBox taken(InterfaceChanges& changes, const PixelBox& at = panel) const {
    const ImDrawList* list = &list_;
    return changes.take(std::span(&list, 1), at);
  }

 private:
  ImDrawList list_{nullptr};
};

bool holds(const PixelBox& outer, const PixelBox& inner) {
  return outer.left <= inner.left && outer.top <= inner.top && outer.right >= inner.right &&
         outer.bottom >= inner.bottom;
}

Drawn usual() {
  Drawn drawn;
  drawn.box(100, 50, 400, 250, IM_COL32(30, 30, 30, 255));
  drawn.box(120, 60, 180, 70);
  drawn.box(120, 200, 180, 210);
  return drawn;
}

TEST(InterfaceChanges, WhatIsDrawnTheFirstTimeIsDrawnWhole) {
  InterfaceChanges changes;
  EXPECT_EQ(usual().taken(changes), panel);
  EXPECT_TRUE(usual().taken(changes).empty()) << "the same again is nothing new";
  changes.forget();
  EXPECT_EQ(usual().taken(changes), panel);
}

TEST(InterfaceChanges, OnlyWhatChangedIsNamed) {
  InterfaceChanges changes;
  usual().taken(changes);
  Drawn more = usual();
  more.box(300, 100, 320, 110);
  const PixelBox changed = more.taken(changes);
  EXPECT_TRUE(holds(changed, {300, 100, 320, 110}));
  EXPECT_LT(changed.right - changed.left, 100);
  EXPECT_LT(changed.bottom - changed.top, 60);
  const PixelBox gone = usual().taken(changes);
  EXPECT_TRUE(holds(gone, {300, 100, 320, 110})) << "what went away is drawn over";
}

TEST(InterfaceChanges, ColourClipAndOrderCount) {
  InterfaceChanges changes;
  const auto shown = [](ImU32 first, ImU32 second, ImVec4 clip) {
    Drawn drawn;
    drawn.box(150, 100, 200, 140, first, clip);
    drawn.box(150, 100, 200, 140, second, clip);
    return drawn;
  };
  const ImU32 red = IM_COL32(255, 0, 0, 255), blue = IM_COL32(0, 0, 255, 255);
  const ImVec4 wide{0, 0, 2000, 2000}, narrow{150, 100, 160, 140};
  shown(red, blue, wide).taken(changes);
  EXPECT_TRUE(shown(red, blue, wide).taken(changes).empty());
  EXPECT_FALSE(shown(blue, red, wide).taken(changes).empty());
  EXPECT_FALSE(shown(blue, blue, wide).taken(changes).empty());
  EXPECT_FALSE(shown(blue, blue, narrow).taken(changes).empty());
}

TEST(InterfaceChanges, APanelThatMovedIsDrawnWhole) {
  InterfaceChanges changes;
  usual().taken(changes);
  const PixelBox moved{100, 60, 400, 250};
  EXPECT_EQ(usual().taken(changes, moved), moved);
  EXPECT_TRUE(usual().taken(changes, {10, 10, 10, 20}).empty()) << "there is nothing of it";
}

TEST(Uncovered, PanelsAlongTheEdgesCutTheWindowShort) {
  const std::vector<DockedPanel> docked{{"left", {0, 0, 300, 600}},
                                        {"right", {900, 0, 1200, 600}},
                                        {"above the bar", {300, 400, 900, 600}},
                                        {"bar", {0, 600, 1200, 700}}};
  EXPECT_EQ(uncovered(1200, 700, {}), (PixelBox{0, 0, 1200, 700}));
  EXPECT_EQ(uncovered(1200, 700, docked), (PixelBox{300, 0, 900, 400})) << "in whatever order they come";
  const std::vector<DockedPanel> one{{"in the middle", {300, 200, 500, 300}}};
  EXPECT_EQ(uncovered(1200, 700, one), (PixelBox{0, 0, 1200, 700}));
  const std::vector<DockedPanel> all{{"all", {0, 0, 1200, 700}}};
  EXPECT_TRUE(uncovered(1200, 700, all).empty());
}

TEST(InterfaceChanges, WhatLiesOutsideDoesNotCount) {
  InterfaceChanges changes;
  usual().taken(changes);
  Drawn more = usual();
  more.box(300, 100, 320, 110, IM_COL32_WHITE, {0, 0, 50, 50});
  EXPECT_TRUE(more.taken(changes).empty()) << "clipped away";
}

}  // namespace
}  // namespace sinew::test
