#include "engine/face/head_loft.h"

#include <algorithm>

namespace sinew {
namespace {

/// Halvings of an interval of at most 180: below 1e-9.
constexpr int bisections = 40;

double catmull_rom(double a, double b, double c, double d, double t) {
  return 0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t * t * t);
}

double hermite(double from, double to, double from_slope, double to_slope, double length, double t) {
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * from + (t3 - 2 * t2 + t) * length * from_slope + (3 * t2 - 2 * t3) * to +
         (t3 - t2) * length * to_slope;
}

/// The place where `below` turns from true to false.
template <class Below>
double bisect(double low, double high, const Below& below) {
  for (int i = 0; i < bisections; ++i) {
    const double middle = 0.5 * (low + high);
    (below(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

HeadLoft::HeadLoft(const HeadMeasures& m) : sections_(skull_sections(m)) {
  sections_.heights.push_back(head_units);
  sections_.radii.emplace_back(sections_.radii.front().size(), 0.0);
  const double factors[] = {m.width_jaw, m.width_mouth, m.width_eyes, m.width_temples, m.width_crown};
  width_heights_ = {-1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.5};
  for (std::size_t i = 0; i < 5; ++i) width_heights_[i + 1] = skull_width_heights[i];
  widths_ = {factors[0], factors[0], factors[1], factors[2], factors[3], factors[4], factors[4]};
  // Fritsch and Butland's harmonic mean of neighbouring slopes keeps a cubic from overshooting.
  slopes_.fill(0.0);
  for (std::size_t i = 1; i + 1 < widths_.size(); ++i) {
    const double before = width_heights_[i] - width_heights_[i - 1], after = width_heights_[i + 1] - width_heights_[i];
    const double one = (widths_[i] - widths_[i - 1]) / before, other = (widths_[i + 1] - widths_[i]) / after;
    if (one * other <= 0.0) continue;
    const double w1 = 2 * after + before, w2 = after + 2 * before;
    slopes_[i] = (w1 + w2) / (w1 / one + w2 / other);
  }
}

double HeadLoft::width_factor(double y) const {
  y = std::clamp(y, width_heights_.front(), width_heights_.back());
  std::size_t i = 0;
  while (i + 2 < widths_.size() && y > width_heights_[i + 1]) ++i;
  const double length = width_heights_[i + 1] - width_heights_[i];
  return hermite(widths_[i], widths_[i + 1], slopes_[i], slopes_[i + 1], length, (y - width_heights_[i]) / length);
}

double HeadLoft::row_radius(std::size_t row, double theta) const {
  const std::vector<double>& radii = sections_.radii[row];
  const int last = static_cast<int>(radii.size()) - 1;
  const double place = std::clamp(theta / 180.0 * last, 0.0, last - 1e-9);
  const int at = static_cast<int>(place);
  // The mirrored half stands beyond both ends.
  const auto value = [&](int i) { return radii[static_cast<std::size_t>(i < 0 ? -i : (i > last ? 2 * last - i : i))]; };
  return catmull_rom(value(at - 1), value(at), value(at + 1), value(at + 2), place - at);
}

double HeadLoft::radius(double theta, double y) const {
  const std::vector<double>& heights = sections_.heights;
  y = std::clamp(y, heights.front(), heights.back());
  const std::size_t above =
      static_cast<std::size_t>(std::upper_bound(heights.begin(), heights.end(), y) - heights.begin());
  const std::size_t i = std::min(above - 1, heights.size() - 2);
  const double length = heights[i + 1] - heights[i], t = (y - heights[i]) / length;
  const double from = row_radius(i, theta), to = row_radius(i + 1, theta);
  constexpr std::size_t crown_rows = 4;
  if (i + crown_rows >= heights.size()) return std::sqrt(std::max(0.0, (1 - t) * from * from + t * to * to));
  const double chord = (to - from) / length;
  const double slope_from = i == 0 ? chord : (to - row_radius(i - 1, theta)) / (heights[i + 1] - heights[i - 1]);
  const double slope_to = (row_radius(i + 2, theta) - from) / (heights[i + 2] - heights[i]);
  return hermite(from, to, slope_from, slope_to, length, t);
}

Vec3 HeadLoft::at(double theta, double y) const {
  const double r = radius(theta, y), angle = theta * degrees_to_radians;
  return {r * std::sin(angle) * width_factor(y), y, r * std::cos(angle)};
}

double HeadLoft::depth(double x, double y) const {
  return at(bisect(0.0, 100.0, [&](double theta) { return at(theta, y).x < x; }), y).z;
}

double HeadLoft::theta_of_depth(double z, double y) const {
  return bisect(20.0, 170.0, [&](double theta) { return at(theta, y).z > z; });
}

double HeadLoft::height_of(double theta, double distance, double lowest) const {
  return bisect(lowest, head_units, [&](double y) {
    const Vec3 p = at(theta, y);
    return std::hypot(p.x, p.z) > distance;
  });
}

}  // namespace sinew
