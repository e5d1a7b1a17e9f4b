#include "engine/render/sheet.h"

#include <memory>
#include <random>

#include <gtest/gtest.h>

namespace sinew {
namespace {

Picture random_picture(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Picture picture{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height)};
  for (std::uint8_t& byte : picture.rgba) byte = static_cast<std::uint8_t>(random());
  return picture;
}

std::vector<std::uint8_t> crop(const Picture& picture, int left, int top, int width, int height) {
  std::vector<std::uint8_t> rgba;
  for (int y = top; y < top + height; ++y) {
    const auto row = picture.rgba.begin() + (std::ptrdiff_t(y) * picture.width + left) * 4;
    rgba.insert(rgba.end(), row, row + std::ptrdiff_t(width) * 4);
  }
  return rgba;
}

class Sheet : public testing::Test {
 protected:
  void SetUp() override {
    auto found = Font::find();
    ASSERT_TRUE(found) << found.error().message;
    font = std::make_unique<Font>(std::move(*found));
    for (unsigned i = 0; i < 5; ++i) pictures.push_back(random_picture(160, 90, i));
  }

  std::vector<Panel> panels(const std::string& label = "") const {
    std::vector<Panel> result;
    for (const Picture& picture : pictures) result.push_back({&picture, label});
    return result;
  }

  std::unique_ptr<Font> font;
  std::vector<Picture> pictures;
};

TEST_F(Sheet, PanelsAreCopiedBitByBit) {
  const auto result = sheet(panels(), {.columns = 2, .gutter = 6, .background = {1, 2, 3, 4}}, nullptr);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->width, 2 * 160 + 3 * 6);
  EXPECT_EQ(result->height, 3 * 90 + 4 * 6);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(crop(*result, 6 + i % 2 * 166, 6 + i / 2 * 96, 160, 90), pictures[i].rgba) << i;
  EXPECT_EQ(crop(*result, 3, 100, 1, 1), (std::vector<std::uint8_t>{1, 2, 3, 4})) << "gutter";
  EXPECT_EQ(crop(*result, 250, 250, 1, 1), (std::vector<std::uint8_t>{1, 2, 3, 4})) << "a place without a panel";
}

TEST_F(Sheet, LabelsUnderPanelsLeaveThemAlone) {
  const auto result = sheet(panels("with bulge"), {.columns = 3, .gutter = 4, .labels = LabelPlace::under}, font.get());
  ASSERT_TRUE(result) << result.error().message;
  const int strip = (result->height - 2 * 90 - 3 * 4) / 2;
  EXPECT_GT(strip, 12);
  for (int i = 0; i < 5; ++i) {
    const int left = 4 + i % 3 * 164, top = 4 + i / 3 * (90 + strip + 4);
    EXPECT_EQ(crop(*result, left, top, 160, 90), pictures[i].rgba) << i;
    const auto label = crop(*result, left, top + 90, 160, strip);
    EXPECT_NE(label, std::vector<std::uint8_t>(label.size(), 255)) << i;
    const auto right_end = crop(*result, left + 120, top + 90, 40, strip);
    EXPECT_EQ(right_end, std::vector<std::uint8_t>(right_end.size(), 255)) << "labels begin at the left";
  }
}

TEST_F(Sheet, LabelsInsideTouchTheLowerLeftOnly) {
  const auto result = sheet(panels("without"), {}, font.get());
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->width, 5 * 168 + 8) << "one row";
  EXPECT_EQ(result->height, 90 + 16);
  for (int i = 0; i < 5; ++i) {
    const int left = 8 + i * 168;
    EXPECT_EQ(crop(*result, left, 8, 160, 45), crop(pictures[i], 0, 0, 160, 45));
    EXPECT_EQ(crop(*result, left + 120, 8, 40, 90), crop(pictures[i], 120, 0, 40, 90));
    EXPECT_NE(crop(*result, left, 8, 160, 90), pictures[i].rgba);
  }
}

TEST_F(Sheet, LongLabelsStayInTheirPanels) {
  const std::string label(300, 'W');
  const auto plain = sheet(panels(), {.gutter = 10}, nullptr);
  const auto inside = sheet(panels(label), {.gutter = 10}, font.get());
  ASSERT_TRUE(plain && inside);
  for (int i = 0; i <= 5; ++i) EXPECT_EQ(crop(*inside, i * 170, 0, 10, 110), crop(*plain, i * 170, 0, 10, 110)) << i;
}

TEST_F(Sheet, RowsAndColumnsFollowFromEachOther) {
  EXPECT_EQ(sheet(panels(), {.rows = 2, .gutter = 0}, nullptr)->width, 3 * 160);
  EXPECT_EQ(sheet(panels(), {.columns = 4, .rows = 3, .gutter = 0}, nullptr)->height, 3 * 90);
}

TEST_F(Sheet, RefusesWhatCannotBeLaidOut) {
  const auto reason = [&](std::span<const Panel> what, const SheetOptions& options, const Font* with) {
    const auto result = sheet(what, options, with);
    return result ? std::string() : result.error().message;
  };
  EXPECT_NE(reason({}, {}, nullptr).find("no pictures"), std::string::npos);
  EXPECT_NE(reason(panels(), {.columns = 2, .rows = 2}, nullptr).find("5 pictures"), std::string::npos);
  EXPECT_NE(reason(panels(), {.columns = -1}, nullptr).find("negative"), std::string::npos);
  EXPECT_NE(reason(panels("label"), {}, nullptr).find("font"), std::string::npos);
  EXPECT_NE(reason(panels(), {.columns = 2000000000}, nullptr).find("16384"), std::string::npos);
  const Picture other = random_picture(10, 10, 9);
  std::vector<Panel> mixed = panels();
  mixed.push_back({&other, ""});
  EXPECT_NE(reason(mixed, {}, nullptr).find("picture 6 is 10x10"), std::string::npos);
}

TEST_F(Sheet, InsetsAreCopiedBitByBitIntoTheirCorner) {
  const Picture inset = random_picture(40, 30, 20);
  for (const Corner corner : {Corner::upper_right, Corner::lower_right}) {
    Picture picture = pictures[0];
    ASSERT_TRUE(add_inset(picture, inset, {.corner = corner, .margin = 5, .border = {9, 8, 7, 255}}, nullptr));
    const int top = corner == Corner::upper_right ? 5 : 90 - 5 - 30;
    EXPECT_EQ(crop(picture, 115, top, 40, 30), inset.rgba);
    EXPECT_EQ(crop(picture, 114, top, 1, 1), (std::vector<std::uint8_t>{9, 8, 7, 255})) << "border";
    EXPECT_EQ(crop(picture, 0, 0, 114, 90), crop(pictures[0], 0, 0, 114, 90)) << "the rest";
    EXPECT_EQ(crop(picture, 156, 0, 4, 90), crop(pictures[0], 156, 0, 4, 90)) << "the margin";
  }
  Picture picture = pictures[0];
  const Picture large = random_picture(160, 20, 21);
  const auto refused = add_inset(picture, large, {}, nullptr);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("160x20"), std::string::npos);
  EXPECT_EQ(picture.rgba, pictures[0].rgba);
}

TEST_F(Sheet, AnInsetsLabelStaysInside) {
  const Picture inset = random_picture(80, 60, 20);
  Picture picture = pictures[0];
  ASSERT_TRUE(add_inset(picture, inset, {.margin = 5, .label = "biceps"}, font.get()));
  EXPECT_EQ(crop(picture, 0, 0, 70, 90), crop(pictures[0], 0, 0, 70, 90));
  EXPECT_NE(crop(picture, 75, 5, 80, 60), inset.rgba);
  EXPECT_EQ(crop(picture, 75, 5, 80, 30), crop(inset, 0, 0, 80, 30));
}

}  // namespace
}  // namespace sinew
