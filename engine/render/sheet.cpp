#include "engine/render/sheet.h"

#include <algorithm>

#include "engine/io/png.h"

namespace sinew {
namespace {

/// Letters of a panel's label: legible in small panels, not shouting in large ones.
double label_size(int panel_height) { return std::clamp(panel_height / 32.0, 11.0, 28.0); }

void copy_into(Picture& to, const Picture& from, int left, int top) {
  for (int y = 0; y < from.height; ++y)
    std::copy_n(from.rgba.begin() + std::ptrdiff_t(y) * from.width * 4, std::size_t(from.width) * 4,
                to.rgba.begin() + (std::ptrdiff_t(top + y) * to.width + left) * 4);
}

/// The letters' ends are cut off where a label is wider than its panel.
std::string fitted(const Font& font, std::string text, double size, double room) {
  if (measure_text(font, text, size).x <= room) return text;
  while (!text.empty() && measure_text(font, text + "\u2026", size).x > room) {
    do {
      const bool continued = (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80;
      text.pop_back();
      if (!continued) break;
    } while (!text.empty());
  }
  return text + "\u2026";
}

/// A label in a box of its own at the lower left of a panel.
void label_inside(Canvas& canvas, const Font& font, const std::string& label, const Rect& panel, double size) {
  TextStyle style;
  style.size = size;
  style.align_y = AlignY::bottom;
  const double padding = std::round(0.32 * size), off = std::round(0.6 * size);
  style.backing = TextBacking{.colour = {255, 255, 255, 222}, .padding = padding, .radius = 0.35 * size};
  const double room = panel.size().x - 2.0 * (off + padding);
  if (room < size) return;
  draw_text(canvas, font, fitted(font, label, size, room),
            Vec2(panel.low.x + off + padding, panel.high.y - off - padding), style);
}

/// A label on the sheet itself, under its panel.
void label_under(Canvas& canvas, const Font& font, const std::string& label, const Rect& strip, double size,
                 const Colour& background) {
  TextStyle style;
  style.size = size;
  style.align_y = AlignY::middle;
  const int luma = (2126 * background.red + 7152 * background.green + 722 * background.blue) / 10000;
  if (background.alpha < 128)
    style.halo = Colour{255, 255, 255, 210};
  else if (luma < 110)
    style.colour = {240, 243, 246};
  draw_text(canvas, font, fitted(font, label, size, strip.size().x), Vec2(strip.low.x, strip.centre().y), style);
}

Result<void> check_panels(std::span<const Panel> panels, const SheetOptions& options, const Font* font) {
  if (panels.empty()) return bad_input("sheet: no pictures");
  if (options.columns < 0 || options.rows < 0 || options.gutter < 0)
    return bad_input("sheet: {} columns, {} rows, gutter {}: none may be negative", options.columns, options.rows,
                     options.gutter);
  const Picture& first = *panels[0].picture;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Picture& p = *panels[i].picture;
    if (p.width != first.width || p.height != first.height)
      return bad_input("sheet: picture {} is {}x{}, the first one {}x{}; all must be of one size", i + 1, p.width,
                       p.height, first.width, first.height);
    if (!panels[i].label.empty() && font == nullptr) return bad_input("sheet: labels need a font");
  }
  return {};
}

}  // namespace

Result<Picture> sheet(std::span<const Panel> panels, const SheetOptions& options, const Font* font) {
  if (auto ok = check_panels(panels, options, font); !ok) return pass_on(std::move(ok));
  const long long count = static_cast<long long>(panels.size());
  const long long columns = options.columns > 0 ? options.columns
                            : options.rows > 0  ? (count + options.rows - 1) / options.rows
                                                : count;
  const long long rows = options.rows > 0 ? options.rows : (count + columns - 1) / columns;
  if (count > columns * rows) return bad_input("sheet: {} pictures do not fit in {} x {} places", count, columns, rows);

  const Picture& first = *panels[0].picture;
  const double size = options.text_size > 0.0 ? options.text_size : label_size(first.height);
  const bool labelled = std::any_of(panels.begin(), panels.end(), [](const Panel& p) { return !p.label.empty(); });
  const int strip = labelled && options.labels == LabelPlace::under ? int(std::ceil(1.7 * size)) : 0;
  const long long width = columns * (first.width + options.gutter) + options.gutter;
  const long long height = rows * (first.height + strip + options.gutter) + options.gutter;
  if (width > largest_png_side || height > largest_png_side)
    return bad_input("sheet: {} x {} pictures of {}x{} make {}x{} pixels; at most {} a side", columns, rows,
                     first.width, first.height, width, height, largest_png_side);

  Picture result{int(width), int(height), {}};
  result.rgba.reserve(std::size_t(width * height) * 4);
  const Colour& b = options.background;
  for (long long i = 0; i < width * height; ++i)
    result.rgba.insert(result.rgba.end(), {b.red, b.green, b.blue, b.alpha});
  Canvas canvas(result);
  for (long long i = 0; i < count; ++i) {
    const int left = options.gutter + int(i % columns) * (first.width + options.gutter);
    const int top = options.gutter + int(i / columns) * (first.height + strip + options.gutter);
    copy_into(result, *panels[i].picture, left, top);
    if (panels[i].label.empty()) continue;
    const Rect panel{Vec2(left, top), Vec2(left + first.width, top + first.height)};
    if (options.labels == LabelPlace::inside)
      label_inside(canvas, *font, panels[i].label, panel, size);
    else
      label_under(canvas, *font, panels[i].label, {{panel.low.x, panel.high.y}, panel.high + Vec2(0.0, strip)}, size,
                  b);
  }
  return result;
}

Result<void> add_inset(Picture& picture, const Picture& inset, const InsetOptions& options, const Font* font) {
  const int margin = options.margin > 0 ? options.margin : std::max(4, picture.height / 45);
  const int left = picture.width - margin - inset.width;
  const int top = options.corner == Corner::upper_right ? margin : picture.height - margin - inset.height;
  if (left < 0 || top < 0 || top + inset.height > picture.height)
    return bad_input("inset: {}x{} with a margin of {} does not fit into {}x{}", inset.width, inset.height, margin,
                     picture.width, picture.height);
  if (!options.label.empty() && font == nullptr) return bad_input("inset: its label needs a font");

  Canvas canvas(picture);
  const int border = std::max(1, int(std::lround(picture.height / 480.0)));
  const Rect box{Vec2(left, top), Vec2(left + inset.width, top + inset.height)};
  const Rect outside = box.grown(border);
  canvas.polygon({outside.low, {outside.high.x, outside.low.y}, outside.high, {outside.low.x, outside.high.y}},
                 options.border);
  copy_into(picture, inset, left, top);
  if (!options.label.empty()) label_inside(canvas, *font, options.label, box, label_size(inset.height));
  return {};
}

}  // namespace sinew
