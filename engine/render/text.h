#pragma once
/// One line of text on a picture, by FreeType: UTF-8, kerning, any size. Letters are placed one after another from left
/// to right; scripts that join or reorder letters are not shaped.

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "engine/core/result.h"
#include "engine/render/canvas.h"

namespace sinew {

/// Heights above the baseline in pixels at one size.
struct FontMetrics {
  double ascent = 0.0;
  double descent = 0.0;     ///< below the baseline, positive
  double cap_height = 0.0;  ///< of an H
};

/// A scalable font. Not thread-safe: a font a thread.
class Font {
 public:
  /// The file that SINEW_FONT names, else DejaVu Sans or Liberation Sans where distributions keep them. Fails as
  /// bad_input where SINEW_FONT names no font, as cannot_write where there is none: the message says what to install.
  static Result<Font> find();
  /// Its name alone. Fails as find() does.
  static Result<std::filesystem::path> find_file();

  /// A TrueType, OpenType or Type 1 file. Fails as bad_input.
  static Result<Font> open(const std::filesystem::path& file);

  Font(Font&&) noexcept;
  Font& operator=(Font&&) noexcept;
  ~Font();

  /// `size` is the height of the em in pixels.
  FontMetrics metrics(double size) const;

  /// A text's outlines with the pen's start at (0, 0) and the baseline along y = 0.
  struct Outline {
    std::vector<Contour> contours;
    double advance = 0.0;  ///< where the pen ends
  };

  /// Bytes that are no UTF-8 are shown as U+FFFD, control characters as blanks, and a character that the font lacks as
  /// the font's sign for that. Sizes are limited to 4..512.
  Outline outline(std::string_view utf8, double size) const;

 private:
  struct Impl;
  explicit Font(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

enum class AlignX { left, centre, right };
enum class AlignY { top, middle, baseline, bottom };

/// A panel behind a text.
struct TextBacking {
  Colour colour{255, 255, 255, 215};
  std::optional<Colour> border{};
  double padding = 4.0;
  double radius = 4.0;
};

struct TextStyle {
  double size = 14.0;  ///< height of the em in pixels
  Colour colour{26, 34, 43};
  AlignX align_x = AlignX::left;
  AlignY align_y = AlignY::baseline;  ///< top and bottom by the font's ascent and descent, middle by its capitals
  std::optional<Colour> halo{};
  double halo_width = 1.5;
  std::optional<TextBacking> backing{};
};

/// Where a text's ink goes, in whole pixels: letters, halo and backing. Aligned by advance and line height, so that
/// texts of one style stand on one line. The pen starts at a whole pixel.
Rect text_box(const Font& font, std::string_view utf8, const Vec2& at, const TextStyle& style);

/// The advance and the height from ascent to descent: what alignment goes by.
Vec2 measure_text(const Font& font, std::string_view utf8, double size);

void draw_text(Canvas& canvas, const Font& font, std::string_view utf8, const Vec2& at, const TextStyle& style);

}  // namespace sinew
