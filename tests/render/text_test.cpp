#include "engine/render/text.h"

#include <cstdlib>
#include <memory>

#include <gtest/gtest.h>

namespace sinew {
namespace {

Picture transparent(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height)};
}

/// The box of all pixels that are not wholly transparent; empty (low > high) where there are none.
Rect ink_box(const Picture& picture) {
  Rect box{Vec2(INFINITY), Vec2(-INFINITY)};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if (picture.rgba[(std::size_t(y) * picture.width + x) * 4 + 3] > 0)
        box = {glm::min(box.low, Vec2(x, y)), glm::max(box.high, Vec2(x + 1, y + 1))};
  return box;
}

class Text : public testing::Test {
 protected:
  void SetUp() override {
    auto found = Font::find();
    ASSERT_TRUE(found) << found.error().message;
    font = std::make_unique<Font>(std::move(*found));
  }

  Picture drawn(std::string_view text, const Vec2& at, const TextStyle& style) const {
    Picture picture = transparent(400, 120);
    Canvas canvas(picture);
    draw_text(canvas, *font, text, at, style);
    return picture;
  }

  std::unique_ptr<Font> font;
};

TEST_F(Text, TheBoxContainsAllInkAndIsTight) {
  for (const char* text : {"leftUpperArm", "jgqy|", "\u00c4\u0178\u00c5 \u20ac\u2026", "W", "biceps 84 %"}) {
    for (const double size : {9.0, 13.5, 24.0}) {
      for (const AlignX x : {AlignX::left, AlignX::centre, AlignX::right}) {
        for (const AlignY y : {AlignY::top, AlignY::middle, AlignY::baseline, AlignY::bottom}) {
          const TextStyle style{.size = size, .align_x = x, .align_y = y};
          const Vec2 at(200.4, 60.7);
          const Rect box = text_box(*font, text, at, style), ink = ink_box(drawn(text, at, style));
          ASSERT_TRUE(box.contains(ink)) << text << " at " << size;
          // The pen's start is part of the box; ink on other sides comes up to it.
          EXPECT_LE(box.high.x - ink.high.x, 1.0) << text;
          EXPECT_LE(ink.low.y - box.low.y, 1.0) << text;
        }
      }
    }
  }
}

TEST_F(Text, TheBoxContainsHaloAndBacking) {
  TextStyle style{.halo = Colour{255, 255, 255, 255}, .halo_width = 2.6};
  const Vec2 at(100.0, 60.0);
  EXPECT_TRUE(text_box(*font, "gjA", at, style).contains(ink_box(drawn("gjA", at, style))));
  style.backing = TextBacking{.border = Colour{0, 0, 0, 255}, .padding = 5.5};
  const Rect box = text_box(*font, "gjA", at, style), ink = ink_box(drawn("gjA", at, style));
  EXPECT_TRUE(box.contains(ink));
  EXPECT_LE(glm::length(box.size() - ink.size()), 4.0);
}

TEST_F(Text, AlignmentGoesByAdvanceAndLineHeight) {
  const FontMetrics m = font->metrics(20.0);
  const Vec2 at(200.0, 60.0), size = measure_text(*font, "hand", 20.0);
  EXPECT_NEAR(size.y, m.ascent + m.descent, 1e-9);
  TextStyle style{.size = 20.0, .align_x = AlignX::right};
  const Rect right = text_box(*font, "hand", at, style);
  EXPECT_NEAR(right.low.x, 200.0 - size.x, 1.5);
  EXPECT_LE(right.high.x, 201.0);
  style.align_y = AlignY::middle;
  const Rect middle = ink_box(drawn("HHH", at, style));
  EXPECT_NEAR(middle.centre().y, 60.0, 1.0) << "capitals stand in the middle";
  style.align_y = AlignY::baseline;
  EXPECT_NEAR(ink_box(drawn("HHH", at, style)).high.y, 60.0, 0.5) << "light hinting puts feet on the pixel grid";
}

TEST_F(Text, AdvancesAddUpButForKerning) {
  const auto width = [&](std::string_view text) { return measure_text(*font, text, 32.0).x; };
  EXPECT_NEAR(width("HH"), 2.0 * width("H"), 1e-6);
  EXPECT_LT(width("AV"), width("A") + width("V") - 0.5);
  EXPECT_NEAR(measure_text(*font, "hand", 64.0).x, 2.0 * width("hand"), 1.0);
  EXPECT_EQ(width(""), 0.0);
}

TEST_F(Text, Utf8IsReadAndWhatIsNotUtf8IsReplaced) {
  const auto width = [&](std::string_view text) { return measure_text(*font, text, 20.0).x; };
  const auto outline = [&](std::string_view text) { return font->outline(text, 20.0).contours; };
  const double sign = width("\uFFFD");
  EXPECT_GT(sign, 0.0);
  EXPECT_EQ(outline("\u00e9").size(), 3u) << "e, its counter and the accent";
  EXPECT_NEAR(width("\xff"), sign, 1e-9);
  EXPECT_NEAR(width("\xc3"), sign, 1e-9) << "cut short";
  EXPECT_NEAR(width("\xc0\xaf"), 2.0 * sign, 1e-9) << "overlong";
  EXPECT_NEAR(width("\xe0\x80\xaf"), 3.0 * sign, 1e-9) << "overlong";
  EXPECT_NEAR(width("\xed\xa0\x80"), 3.0 * sign, 1e-9) << "a surrogate";
  EXPECT_NEAR(width("\xf4\x90\x80\x80"), 4.0 * sign, 1e-9) << "beyond Unicode";
  EXPECT_NEAR(width("a\nb\tc"), width("a b c"), 1.0) << "control characters are blanks";
}

TEST_F(Text, AMissingGlyphIsShown) {
  const Font::Outline outline = font->outline("\U0010FFFD", 20.0);
  EXPECT_FALSE(outline.contours.empty());
  EXPECT_GT(outline.advance, 0.0);
}

TEST_F(Text, AHaloSurroundsTheLetters) {
  TextStyle style{.size = 24.0, .colour = {0, 0, 0}, .halo = Colour{255, 255, 255}, .halo_width = 2.0};
  const Picture with = drawn("l", {50.0, 60.0}, style);
  style.halo.reset();
  const Rect letter = ink_box(drawn("l", {50.0, 60.0}, style)), halo = ink_box(with);
  EXPECT_NEAR(letter.low.x - halo.low.x, 2.0, 1.0);
  EXPECT_NEAR(halo.high.y - letter.high.y, 2.0, 1.0);
  const std::size_t beside = (std::size_t(letter.centre().y) * 400 + std::size_t(letter.low.x) - 1) * 4;
  EXPECT_GT(with.rgba[beside], 180);
  EXPECT_GT(with.rgba[beside + 3], 150);
}

TEST_F(Text, TheSameTextGivesTheSameBytes) {
  const TextStyle style{.size = 13.5, .halo = Colour{255, 255, 255, 200}, .backing = TextBacking{}};
  auto again = Font::find();
  ASSERT_TRUE(again);
  const Picture first = drawn("rightLowerLeg", {30.2, 50.9}, style);
  (void)font->outline("another size between", 40.0);
  EXPECT_EQ(first.rgba, drawn("rightLowerLeg", {30.2, 50.9}, style).rgba);
  Picture other = transparent(400, 120);
  Canvas canvas(other);
  draw_text(canvas, *again, "rightLowerLeg", {30.2, 50.9}, style);
  EXPECT_EQ(first.rgba, other.rgba);
}

TEST_F(Text, MayLieOutside) {
  const TextStyle style{.halo = Colour{}, .backing = TextBacking{}};
  for (const double x : {-20.0, 395.0, 1e6, -1e12, 1e300, double(NAN), double(INFINITY)})
    for (const double y : {-3.0, 118.0, 1e300, double(NAN)}) (void)drawn("text", {x, y}, style);
  for (const double size : {-1.0, 0.0, 1e9, double(NAN)})
    EXPECT_LT(measure_text(*font, "W", size).x, 1000.0) << "sizes are limited";
}

TEST(FontFiles, SayWhatIsWrong) {
  const auto missing = Font::open("/no/such/font.ttf");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::bad_input);
  EXPECT_NE(missing.error().message.find("/no/such/font.ttf"), std::string::npos);
  const auto text = Font::open(std::string(SINEW_SOURCE_DIR) + "/README.md");
  ASSERT_FALSE(text);
  EXPECT_NE(text.error().message.find("no font"), std::string::npos);

  const char* before = std::getenv("SINEW_FONT");
  const std::string kept = before != nullptr ? before : "";
  setenv("SINEW_FONT", "/no/such/font.ttf", 1);
  const auto chosen = Font::find();
  setenv("SINEW_FONT", kept.c_str(), 1);
  ASSERT_FALSE(chosen);
  EXPECT_NE(chosen.error().message.find("SINEW_FONT"), std::string::npos);
}

}  // namespace
}  // namespace sinew
