#include "engine/render/overlay_painter.h"

namespace sinew {
namespace {

constexpr double text_size = 13.5;

/// Under this the eye cannot read DejaVu Sans, nor see a line.
constexpr double smallest_letter_scale = 0.7, smallest_line_scale = 0.6;

}  // namespace

OverlayPainter::OverlayPainter(Picture& picture, const Font* font, const Viewpoint& view)
    : canvas(picture),
      screen(view, picture.width, picture.height),
      viewpoint(view),
      layout(picture.width, picture.height),
      font_(font),
      line_scale_(std::max(picture.height / 720.0, smallest_line_scale)),
      letter_scale_(std::max(picture.height / 720.0, smallest_letter_scale)) {}

void OverlayPainter::add_label(Label label) {
  if (font_ == nullptr || label.text.empty()) return;
  const Vec2 text = measure_text(*font_, label.text, letters(text_size));
  label.request.size = glm::ceil(text + (label.boxed ? Vec2(letters(8.0)) : Vec2(letters(4.0), 0.0)));
  labels_.push_back(std::move(label));
}

void OverlayPainter::draw_labels() {
  std::stable_sort(labels_.begin(), labels_.end(),
                   [](const Label& a, const Label& b) { return a.importance > b.importance; });
  std::vector<std::pair<const Label*, PlacedLabel>> placed;
  for (const Label& label : labels_)
    if (const auto place = layout.place(label.request)) placed.emplace_back(&label, *place);
  for (const auto& [label, place] : placed) {
    if (!place.leader) continue;
    const bool dark = dark_under(place.box);
    canvas.line(place.leader_from, place.leader_to,
                {.colour = faded(dark ? palette::ink : palette::paper, 0.6), .width = line(2.6)});
    canvas.line(place.leader_from, place.leader_to,
                {.colour = faded(dark ? palette::paper : palette::ink, 0.75), .width = line(1.0)});
    canvas.disc(place.leader_from, line(1.8), label->tick);
  }
  for (const auto& [label, place] : placed) draw_label(*label, place);
}

void OverlayPainter::draw_label(const Label& label, const PlacedLabel& place) {
  const bool dark = dark_under(place.box);
  TextStyle style;
  style.colour = dark ? palette::paper : palette::ink;
  style.halo = faded(dark ? palette::ink : palette::paper, 0.82);
  style.size = letters(text_size);
  style.align_x = AlignX::centre;
  style.align_y = AlignY::middle;
  style.halo_width = letters(1.6);
  if (label.boxed) {
    style.colour = palette::ink;
    style.halo.reset();
    canvas.rounded_box(place.box, letters(4.0), faded(palette::paper, 0.86),
                       Stroke{.colour = faded(label.tick, 0.9), .width = line(1.2)});
  }
  draw_text(canvas, *font_, label.text, place.box.centre(), style);
}

void OverlayPainter::line_3d(const Vec3& a, const Vec3& b, const Stroke& stroke) {
  if (const auto seen = screen.segment(a, b)) canvas.line(seen->first.at, seen->second.at, stroke);
}

void OverlayPainter::polyline_3d(std::span<const Vec3> points, const Stroke& stroke, bool closed) {
  std::vector<Vec2> run;
  for (const Vec3& p : points)
    if (const auto seen = screen.point(p)) run.push_back(seen->at);
  if (run.size() == points.size()) {
    canvas.polyline(run, stroke, closed);
    return;
  }
  for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i)
    line_3d(points[i], points[(i + 1) % points.size()], stroke);
}

}  // namespace sinew
