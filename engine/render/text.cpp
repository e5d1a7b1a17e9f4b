#include "engine/render/text.h"

#include <cstdlib>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace sinew {
namespace {

constexpr double smallest_size = 4.0, largest_size = 512.0;
constexpr double ft_units = 64.0;
constexpr char32_t replacement = 0xFFFD;

/// Debian, Fedora, Arch, openSUSE and the BSDs keep their fonts in different places.
constexpr const char* known_fonts[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/DejaVuSans.ttf",
    "/usr/local/share/fonts/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf",
    "/usr/share/fonts/liberation-sans/LiberationSans-Regular.ttf",
    "/usr/share/fonts/liberation/LiberationSans-Regular.ttf",
    "/usr/share/fonts/TTF/LiberationSans-Regular.ttf",
};

/// Takes the first character off the text. Overlong forms, surrogates and cut sequences cost one byte each.
char32_t take_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  std::size_t length = first < 0x80                    ? 1
                       : first >= 0xC2 && first < 0xE0 ? 2
                       : first >= 0xE0 && first < 0xF0 ? 3
                       : first >= 0xF0 && first < 0xF5 ? 4
                                                       : 0;
  char32_t character = length == 1 ? first : first & (0x7F >> length);
  bool valid = length > 0 && length <= text.size();
  for (std::size_t i = 1; valid && i < length; ++i) {
    valid = (byte(i) & 0xC0) == 0x80;
    character = character << 6 | (byte(i) & 0x3F);
  }
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  valid = valid && character >= least[length] && character <= 0x10FFFF && !(character >= 0xD800 && character < 0xE000);
  text.remove_prefix(valid ? length : 1);
  return valid ? character : replacement;
}

bool is_control(char32_t character) { return character < 0x20 || (character >= 0x7F && character < 0xA0); }

/// Turns FreeType's curves into polygons. Its y goes up, ours down.
struct Flattener {
  std::vector<Contour>& contours;
  Vec2 pen{0.0};

  Vec2 point(const FT_Vector* v) const { return pen + Vec2(double(v->x), -double(v->y)) / ft_units; }
  Vec2 last() const { return contours.back().back(); }

  /// Steps so that the chords of a curve whose control points bend by `bend` pixels leave it by less than 1/100 pixel.
  static int steps(double bend) { return std::clamp(int(std::ceil(std::sqrt(bend * 12.5))), 1, 64); }

  void conic(const Vec2& b, const Vec2& c) {
    const Vec2 a = last();
    const int count = steps(glm::length(a - 2.0 * b + c));
    for (int i = 1; i <= count; ++i) {
      const double t = double(i) / count, s = 1.0 - t;
      contours.back().push_back(s * s * a + 2.0 * s * t * b + t * t * c);
    }
  }

  void cubic(const Vec2& b, const Vec2& c, const Vec2& d) {
    const Vec2 a = last();
    const int count = steps(3.0 * std::max(glm::length(a - 2.0 * b + c), glm::length(b - 2.0 * c + d)));
    for (int i = 1; i <= count; ++i) {
      const double t = double(i) / count, s = 1.0 - t;
      contours.back().push_back(s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d);
    }
  }

  void add(FT_Outline& outline) {
    FT_Outline_Funcs functions{};
    functions.move_to = [](const FT_Vector* to, void* user) {
      auto& self = *static_cast<Flattener*>(user);
      self.contours.push_back({self.point(to)});
      return 0;
    };
    functions.line_to = [](const FT_Vector* to, void* user) {
      auto& self = *static_cast<Flattener*>(user);
      self.contours.back().push_back(self.point(to));
      return 0;
    };
    functions.conic_to = [](const FT_Vector* control, const FT_Vector* to, void* user) {
      auto& self = *static_cast<Flattener*>(user);
      self.conic(self.point(control), self.point(to));
      return 0;
    };
    functions.cubic_to = [](const FT_Vector* control1, const FT_Vector* control2, const FT_Vector* to, void* user) {
      auto& self = *static_cast<Flattener*>(user);
      self.cubic(self.point(control1), self.point(control2), self.point(to));
      return 0;
    };
    FT_Outline_Decompose(&outline, &functions, this);
  }
};

struct Placement {
  Vec2 pen{0.0};  ///< whole pixels
  Rect line;      ///< advance x (ascent to descent), round the pen
};

Placement place(const Font& font, double advance, const Vec2& at, const TextStyle& style) {
  const FontMetrics m = font.metrics(style.size);
  const double shift_x = style.align_x == AlignX::left ? 0.0 : style.align_x == AlignX::centre ? 0.5 : 1.0;
  double down = 0.0;
  switch (style.align_y) {
    case AlignY::top:
      down = m.ascent;
      break;
    case AlignY::middle:
      down = 0.5 * m.cap_height;
      break;
    case AlignY::baseline:
      break;
    case AlignY::bottom:
      down = -m.descent;
      break;
  }
  const Vec2 pen = glm::floor(Vec2(at.x - shift_x * advance, at.y + down) + 0.5);
  return {pen, {{pen.x, pen.y - m.ascent}, {pen.x + advance, pen.y + m.descent}}};
}

void shift(std::vector<Contour>& contours, const Vec2& by) {
  for (Contour& contour : contours)
    for (Vec2& p : contour) p += by;
}

Rect backing_box(const Placement& placed, const TextBacking& backing) {
  const Rect box = placed.line.grown(backing.padding);
  return {glm::floor(box.low), glm::ceil(box.high)};
}

bool drawable(const Vec2& at) { return std::abs(at.x) < 1e8 && std::abs(at.y) < 1e8; }

}  // namespace

struct Font::Impl {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  ~Impl() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }

  void set_size(double size) const {
    const double em = std::clamp(std::isfinite(size) ? size : smallest_size, smallest_size, largest_size);
    FT_Set_Char_Size(face, 0, FT_F26Dot6(std::lround(em * ft_units)), 72, 72);
  }
};

Font::Font(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;
Font::~Font() = default;

Result<Font> Font::open(const std::filesystem::path& file) {
  auto impl = std::make_unique<Impl>();
  if (const FT_Error error = FT_Init_FreeType(&impl->library); error != 0)
    return failure(ErrorKind::cannot_write, "FreeType cannot start (its error {})", error);
  if (const FT_Error error = FT_New_Face(impl->library, file.c_str(), 0, &impl->face); error != 0)
    return bad_input("font \"{}\": {}", file.string(),
                     std::filesystem::exists(file) ? fmt::format("no font that FreeType can read (its error {})", error)
                                                   : "no such file");
  if (!FT_IS_SCALABLE(impl->face))
    return bad_input("font \"{}\": has letters of fixed sizes only; a TrueType or OpenType font would be right",
                     file.string());
  return Font(std::move(impl));
}

Result<std::filesystem::path> Font::find_file() {
  if (const char* chosen = std::getenv("SINEW_FONT"); chosen != nullptr && *chosen != '\0') {
    auto font = open(chosen);
    if (font) return chosen;
    font.error().message += " (SINEW_FONT names it)";
    return pass_on(std::move(font));
  }
  for (const char* file : known_fonts) {
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored) && open(file)) return file;
  }
  return failure(
      ErrorKind::cannot_write,
      "no font for labels: install DejaVu Sans (Debian: apt-get install fonts-dejavu-core) or Liberation Sans, "
      "or let SINEW_FONT name a TrueType or OpenType file");
}

Result<Font> Font::find() {
  auto file = find_file();
  if (!file) return pass_on(std::move(file));
  return open(*file);
}

FontMetrics Font::metrics(double size) const {
  impl_->set_size(size);
  const FT_Size_Metrics& m = impl_->face->size->metrics;
  FontMetrics result{double(m.ascender) / ft_units, -double(m.descender) / ft_units, 0.0};
  result.cap_height = 0.7 * result.ascent;
  if (FT_Load_Char(impl_->face, 'H', FT_LOAD_NO_BITMAP | FT_LOAD_TARGET_LIGHT) == 0)
    result.cap_height = double(impl_->face->glyph->metrics.horiBearingY) / ft_units;
  return result;
}

Font::Outline Font::outline(std::string_view utf8, double size) const {
  impl_->set_size(size);
  const FT_Face face = impl_->face;
  Outline result;
  Flattener flattener{result.contours};
  FT_UInt before = 0;
  while (!utf8.empty()) {
    const char32_t character = take_character(utf8);
    const FT_UInt glyph = FT_Get_Char_Index(face, is_control(character) ? U' ' : character);
    FT_Vector kerning{};
    if (before != 0 && glyph != 0) FT_Get_Kerning(face, before, glyph, FT_KERNING_UNFITTED, &kerning);
    before = glyph;
    // Light hinting moves heights to whole pixels, which keeps small letters crisp, and leaves widths alone.
    if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_BITMAP | FT_LOAD_TARGET_LIGHT) != 0) continue;
    flattener.pen.x += double(kerning.x) / ft_units;
    if (face->glyph->format == FT_GLYPH_FORMAT_OUTLINE) flattener.add(face->glyph->outline);
    flattener.pen.x += double(face->glyph->linearHoriAdvance) / 65536.0;
  }
  result.advance = flattener.pen.x;
  return result;
}

Vec2 measure_text(const Font& font, std::string_view utf8, double size) {
  const FontMetrics m = font.metrics(size);
  return {font.outline(utf8, size).advance, m.ascent + m.descent};
}

Rect text_box(const Font& font, std::string_view utf8, const Vec2& at, const TextStyle& style) {
  Font::Outline text = font.outline(utf8, style.size);
  const Placement placed = place(font, text.advance, at, style);
  shift(text.contours, placed.pen);
  Rect ink{placed.pen, placed.pen};
  for (const Contour& contour : text.contours)
    for (const Vec2& p : contour) ink = {glm::min(ink.low, p), glm::max(ink.high, p)};
  if (style.halo) ink = ink.grown(std::ceil(style.halo_width));
  if (style.backing) {
    Rect backing = backing_box(placed, *style.backing);
    if (style.backing->border) backing = backing.grown(1.0);
    ink = {glm::min(ink.low, backing.low), glm::max(ink.high, backing.high)};
  }
  return {glm::floor(ink.low), glm::ceil(ink.high)};
}

void draw_text(Canvas& canvas, const Font& font, std::string_view utf8, const Vec2& at, const TextStyle& style) {
  if (!drawable(at)) return;
  Font::Outline text = font.outline(utf8, style.size);
  const Placement placed = place(font, text.advance, at, style);
  shift(text.contours, placed.pen);
  if (style.backing) {
    std::optional<Stroke> border;
    if (style.backing->border) border = Stroke{.colour = *style.backing->border, .width = 1.0};
    canvas.rounded_box(backing_box(placed, *style.backing), style.backing->radius, style.backing->colour, border);
  }
  if (style.halo) canvas.stamp(dilated(mask_of(text.contours), style.halo_width), *style.halo);
  canvas.fill(text.contours, style.colour);
}

}  // namespace sinew
