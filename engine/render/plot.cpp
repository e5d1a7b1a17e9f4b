#include "engine/render/plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/render/label_layout.h"

namespace sinew {
namespace {

constexpr Colour paper{255, 255, 255}, ink{26, 34, 43}, grid{226, 229, 233};
constexpr int smallest_side = 64;

/// Where the axes stand in the picture, and what letters fit it.
class PlotPainter {
 public:
  PlotPainter(Picture& picture, const Plot& plot, const Font& font)
      : canvas_(picture),
        plot_(plot),
        font_(font),
        size_(std::clamp(std::min(picture.width, picture.height) / 24.0, 9.0, 24.0)) {
    const double left = 3.4 * size_, right = 1.4 * size_, bottom = 3.8 * size_;
    place_legend(left, picture.width - right);
    const double top = (entries_.empty() ? 4.0 : entries_.back().at.y / size_ + 2.9) * size_;
    area_ = {Vec2(left, top), Vec2(picture.width - right, picture.height - bottom)};
  }

  void draw() {
    axes();
    for (const PlotCurve& curve : plot_.curves) this->curve(curve);
    for (const PlotMark& mark : plot_.marks) dot(mark);
    mark_labels();
    legend();
  }

 private:
  Vec2 place(const Vec2& at) const {
    const double u = (at.x - plot_.x.first) / (plot_.x.last - plot_.x.first);
    const double v = (at.y - plot_.y.first) / (plot_.y.last - plot_.y.first);
    return {area_.low.x + u * area_.size().x, area_.high.y - v * area_.size().y};
  }

  /// Smaller where there is less room.
  void text(std::string_view what, const Vec2& at, AlignX x, AlignY y, double scale, double room = INFINITY) {
    const double wide = measure_text(font_, what, scale * size_).x;
    const double size = scale * size_ * std::min(1.0, room / wide);
    draw_text(canvas_, font_, what, at, {.size = size, .colour = ink, .align_x = x, .align_y = y});
  }

  /// Calls back with every multiple of the step on the axis.
  template <class Line>
  static void lines(const PlotAxis& axis, Line line) {
    const auto [low, high] = std::minmax(axis.first, axis.last);
    constexpr double rounding = 1e-6;
    for (double i = std::ceil(low / axis.step - rounding); i <= high / axis.step + rounding; ++i)
      line(i == 0.0 ? 0.0 : i * axis.step);  // no negative zero
  }

  void axes() {
    const Stroke thin{.colour = grid, .width = std::max(1.0, size_ / 16.0)};
    lines(plot_.x, [&](double x) {
      const double at = place({x, 0.0}).x;
      canvas_.line({at, area_.low.y}, {at, area_.high.y}, thin);
      text(fmt::format("{:.6g}", x), {at, area_.high.y + 0.5 * size_}, AlignX::centre, AlignY::top, 0.85);
    });
    lines(plot_.y, [&](double y) {
      const double at = place({0.0, y}).y;
      canvas_.line({area_.low.x, at}, {area_.high.x, at}, thin);
      text(fmt::format("{:.6g}", y), {area_.low.x - 0.5 * size_, at}, AlignX::right, AlignY::middle, 0.85);
    });
    const Stroke thick{.colour = ink, .width = std::max(1.0, size_ / 10.0), .cap = Cap::round};
    canvas_.line({area_.low.x, area_.low.y}, {area_.low.x, area_.high.y}, thick);
    canvas_.line({area_.low.x, area_.high.y}, {area_.high.x, area_.high.y}, thick);
    text(plot_.title, {0.9 * size_, 0.7 * size_}, AlignX::left, AlignY::top, 1.1, canvas_.width() - 1.8 * size_);
    text(plot_.y.name, {0.9 * size_, area_.low.y - 1.8 * size_}, AlignX::left, AlignY::top, 0.95);
    text(plot_.x.name, {area_.high.x, area_.high.y + 1.9 * size_}, AlignX::right, AlignY::top, 0.95,
         area_.high.x - 0.5 * size_);
  }

  Stroke stroke(const PlotCurve& curve) const {
    return {.colour = curve.colour,
            .width = std::max(1.5, size_ / 6.0),
            .cap = Cap::round,
            .dash = curve.dashed ? 0.6 * size_ : 0.0,
            .gap = curve.dashed ? 0.45 * size_ : 0.0};
  }

  void curve(const PlotCurve& curve) {
    std::vector<Vec2> points;
    const auto [low, high] = std::minmax(plot_.x.first, plot_.x.last);
    for (const Vec2& p : curve.points)
      if (p.x >= low && p.x <= high) points.push_back(place(p));
    // Of curves that lie on one another the lower ones show on either side.
    Stroke line = stroke(curve);
    for (const PlotCurve* later = &curve + 1; later < plot_.curves.data() + plot_.curves.size(); ++later)
      if (later->points == curve.points && later->dashed == curve.dashed) line.width += 0.9 * stroke(curve).width;
    canvas_.polyline(points, line);
  }

  void dot(const PlotMark& mark) {
    const Vec2 at = place(mark.at);
    canvas_.disc(at, 0.42 * size_, paper);
    canvas_.disc(at, 0.32 * size_, mark.colour);
  }

  /// Clear of one another, of the dots and of the axes' numbers.
  void mark_labels() {
    LabelLayout layout(canvas_.width(), canvas_.height());
    layout.avoid(Rect{Vec2(0.0), Vec2(area_.low.x, canvas_.height())});
    layout.avoid(Rect{Vec2(0.0, area_.high.y), Vec2(canvas_.width(), canvas_.height())});
    for (const PlotMark& mark : plot_.marks)
      layout.avoid(Rect{place(mark.at) - 0.42 * size_, place(mark.at) + 0.42 * size_});
    for (auto mark = plot_.marks.begin(); mark != plot_.marks.end(); ++mark) {
      const auto same = [&](const PlotMark& other) { return other.at == mark->at && other.label == mark->label; };
      if (std::any_of(plot_.marks.begin(), mark, same)) continue;
      LabelRequest request;
      request.anchor = place(mark->at);
      request.size = measure_text(font_, mark->label, 0.9 * size_);
      request.away = {mark->leftwards ? -1.0 : 1.0, -1.0};
      request.clearance = 0.6 * size_;
      request.dot = 0.42 * size_;
      request.may_cover = true;
      const auto found = layout.place(request);
      if (!found) continue;
      if (found->leader)
        canvas_.line(found->leader_from, found->leader_to, {.colour = ink, .width = std::max(1.0, size_ / 16.0)});
      draw_text(
          canvas_, font_, mark->label, found->box.centre(),
          {.size = 0.9 * size_, .colour = ink, .align_x = AlignX::centre, .align_y = AlignY::middle, .halo = paper});
    }
  }

  /// Rows between title and axes, from the left; a name too long for a row shrinks.
  void place_legend(double left, double right) {
    double x = left, y = 3.0 * size_;
    for (const PlotCurve& curve : plot_.curves) {
      if (curve.name.empty()) continue;
      const double wide = legend_line_ * size_ + measure_text(font_, curve.name, 0.85 * size_).x;
      if (x > left && x + wide > right) {
        x = left;
        y += 1.4 * size_;
      }
      entries_.push_back({&curve, {x, y}, right - x - legend_line_ * size_});
      x += wide + 1.2 * size_;
    }
  }

  void legend() {
    for (const LegendEntry& entry : entries_) {
      canvas_.line(entry.at, entry.at + Vec2((legend_line_ - 0.5) * size_, 0.0), stroke(*entry.curve));
      text(entry.curve->name, entry.at + Vec2(legend_line_ * size_, 0.0), AlignX::left, AlignY::middle, 0.85,
           entry.room);
    }
  }

  static constexpr double legend_line_ = 2.3;  ///< of a legend's line and the gap behind it, letters' sizes
  struct LegendEntry {
    const PlotCurve* curve;
    Vec2 at{0.0};       ///< the line's left end
    double room = 0.0;  ///< pixels for the name
  };
  std::vector<LegendEntry> entries_;

  Canvas canvas_;
  const Plot& plot_;
  const Font& font_;
  double size_;  ///< of the letters, pixels
  Rect area_;
};

}  // namespace

double round_step(double span, int count) {
  const double rough = span / count, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (rough <= 1.5 * digit * power) return digit * power;
  return 10.0 * power;
}

Colour plot_colour(std::size_t index) {
  constexpr std::array<Colour, 6> colours{
      {{200, 30, 60}, {52, 104, 220}, {56, 150, 60}, {240, 138, 36}, {0, 150, 136}, {120, 80, 160}}};
  return colours[index % colours.size()];
}

Result<Picture> draw_plot(const Plot& plot, int width, int height, const Font& font) {
  for (const PlotAxis* axis : {&plot.x, &plot.y})
    if (!(axis->step > 0.0) || !(std::abs(axis->last - axis->first) > 0.0))
      return bad_input("plot: the axis \"{}\" from {} to {} in steps of {} is empty", axis->name, axis->first,
                       axis->last, axis->step);
  if (width < smallest_side || height < smallest_side)
    return bad_input("plot: {}x{} pixels are too few, expected at least {} a side", width, height, smallest_side);
  Picture picture{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height, 255)};
  PlotPainter(picture, plot, font).draw();
  return picture;
}

}  // namespace sinew
