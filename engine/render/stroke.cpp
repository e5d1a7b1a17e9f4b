#include "engine/render/stroke.h"

#include <optional>

namespace sinew {
namespace {

/// A dash pattern finer than this is drawn as an unbroken line: it could not be seen, and would cost much.
constexpr double shortest_period = 0.5;

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }
Vec2 turned(const Vec2& v) { return {-v.y, v.x}; }

/// Steps round an arc so that chords leave it by less than 1/100 pixel, and by less than 0.3 % of a small radius, which
/// keeps the area of a dot.
int arc_steps(double radius, double angle) {
  const double chord = std::clamp(0.01 / std::max(radius, 1e-6), 1e-9, 0.003);
  return std::clamp(int(std::ceil(std::abs(angle) / (2.0 * std::acos(1.0 - chord)))), 1, 2048);
}

/// The points of an arc round `centre` from `offset`, turned by `angle` radians; both ends are among them.
void add_arc(Contour& contour, const Vec2& centre, const Vec2& offset, double angle) {
  const int steps = arc_steps(glm::length(offset), angle);
  for (int i = 0; i <= steps; ++i) {
    const double a = angle * i / steps;
    contour.push_back(centre + std::cos(a) * offset + std::sin(a) * turned(offset));
  }
}

struct Corner {
  Vec2 at, before, after;  ///< the point, and the unit directions of travel before and after it
};

/// The points that one side of a line passes at a corner. `half` is signed: the side of turned(direction).
void add_corner(Contour& contour, const Corner& corner, double half) {
  const Vec2 from = half * turned(corner.before), to = half * turned(corner.after);
  const double cosine = glm::dot(corner.before, corner.after);
  if (cosine > -1e-9) {
    contour.push_back(corner.at + (from + to) / (1.0 + cosine));
    return;
  }
  const double sine = cross(corner.before, corner.after);
  if (sine * half > 0.0) {
    // On the inner side of a sharp corner the way by the corner itself keeps the sense of rotation.
    contour.insert(contour.end(), {corner.at + from, corner.at, corner.at + to});
  } else {
    add_arc(contour, corner.at, from, std::atan2(sine, cosine));
  }
}

std::vector<Vec2> without_repeats(std::span<const Vec2> points, bool closed) {
  constexpr double same = 1e-6;
  std::vector<Vec2> distinct;
  for (const Vec2& p : points)
    if (distinct.empty() || glm::distance(distinct.back(), p) > same) distinct.push_back(p);
  while (closed && distinct.size() > 1 && glm::distance(distinct.front(), distinct.back()) <= same) distinct.pop_back();
  return distinct;
}

void add_ring(std::vector<Contour>& contours, const std::vector<Vec2>& points, double half) {
  Contour right, left;
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 &before = points[(i + count - 1) % count], &at = points[i], &after = points[(i + 1) % count];
    const Corner corner{at, glm::normalize(at - before), glm::normalize(after - at)};
    add_corner(right, corner, -half);
    add_corner(left, corner, half);
  }
  std::reverse(left.begin(), left.end());
  contours.push_back(std::move(right));
  contours.push_back(std::move(left));
}

void add_run(std::vector<Contour>& contours, const std::vector<Vec2>& points, double half, Cap cap) {
  Contour right, left;
  const std::size_t last = points.size() - 1;
  const Vec2 start = glm::normalize(points[1] - points[0]), end = glm::normalize(points[last] - points[last - 1]);
  right.push_back(points[0] - half * turned(start));
  left.push_back(points[0] + half * turned(start));
  for (std::size_t i = 1; i < last; ++i) {
    const Corner corner{points[i], glm::normalize(points[i] - points[i - 1]),
                        glm::normalize(points[i + 1] - points[i])};
    add_corner(right, corner, -half);
    add_corner(left, corner, half);
  }
  if (cap == Cap::round)
    add_arc(right, points[last], -half * turned(end), std::numbers::pi);
  else
    right.push_back(points[last] - half * turned(end));
  left.push_back(points[last] + half * turned(end));
  right.insert(right.end(), left.rbegin(), left.rend());
  if (cap == Cap::round) add_arc(right, points[0], half * turned(start), std::numbers::pi);
  contours.push_back(std::move(right));
}

/// Where a segment enters and leaves a box, as parts of its length (Liang and Barsky 1984).
std::optional<std::pair<double, double>> part_inside(const Vec2& a, const Vec2& b, const Rect& box) {
  double enter = 0.0, leave = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = b[axis] - a[axis], to_low = box.low[axis] - a[axis], to_high = box.high[axis] - a[axis];
    if (step == 0.0) {
      if (to_low > 0.0 || to_high < 0.0) return {};
      continue;
    }
    enter = std::max(enter, std::min(to_low / step, to_high / step));
    leave = std::min(leave, std::max(to_low / step, to_high / step));
  }
  if (enter >= leave) return {};
  return std::pair(enter, leave);
}

/// Follows a line and hands out the unbroken runs of it that are visible.
class RunWalker {
 public:
  RunWalker(const Stroke& stroke, const Rect& visible) : visible_(visible), period_(stroke.dash + stroke.gap) {
    dashed_ = stroke.dash > 0.0 && stroke.gap > 0.0 && period_ >= shortest_period;
    dash_ = stroke.dash;
  }

  void add_segment(const Vec2& a, const Vec2& b) {
    const double length = glm::length(b - a);
    const auto inside = part_inside(a, b, visible_);
    if (inside) {
      if (inside->first > 0.0) finish_run();
      add_visible(a, (b - a) / length, inside->first * length, inside->second * length);
    }
    if (!inside || inside->second < 1.0) finish_run();
    // Only the phase of the pattern matters, and a remainder keeps it accurate on endless lines.
    travelled_ = dashed_ ? std::fmod(travelled_ + length, period_) : 0.0;
  }

  std::vector<std::vector<Vec2>> runs() {
    finish_run();
    return std::move(runs_);
  }

 private:
  void add_visible(const Vec2& origin, const Vec2& direction, double from, double to) {
    if (!dashed_) {
      add_piece(origin + from * direction, origin + to * direction);
      return;
    }
    for (double dash = std::floor((travelled_ + from) / period_) * period_ - travelled_; dash < to; dash += period_) {
      const double begin = std::max(dash, from), end = std::min(dash + dash_, to);
      if (begin >= end) continue;
      if (dash > from) finish_run();
      add_piece(origin + begin * direction, origin + end * direction);
      if (dash + dash_ < to) finish_run();
    }
  }

  void add_piece(const Vec2& from, const Vec2& to) {
    if (run_.empty()) run_.push_back(from);
    run_.push_back(to);
  }

  void finish_run() {
    if (run_.size() > 1) runs_.push_back(std::move(run_));
    run_.clear();
  }

  Rect visible_;
  double period_, dash_ = 0.0, travelled_ = 0.0;
  bool dashed_ = false;
  std::vector<Vec2> run_;
  std::vector<std::vector<Vec2>> runs_;
};

bool usable(std::span<const Vec2> points, const Stroke& stroke) {
  // Squares of coordinates beyond this would overflow.
  constexpr double largest = 1e150;
  for (const Vec2& p : points)
    if (!(std::abs(p.x) <= largest && std::abs(p.y) <= largest)) return false;
  return std::isfinite(stroke.width) && stroke.width > 0.0 && points.size() > 1;
}

}  // namespace

std::vector<Contour> stroke_contours(std::span<const Vec2> points, const Stroke& stroke, bool closed, int width,
                                     int height) {
  std::vector<Contour> contours;
  if (!usable(points, stroke)) return contours;
  const std::vector<Vec2> line = without_repeats(points, closed);
  if (line.size() < 2) return contours;
  // Room for the stroke's width and its mitres.
  const Rect visible = Rect{Vec2(0.0), Vec2(width, height)}.grown(2.0 * stroke.width + 2.0);
  const double half = 0.5 * stroke.width;

  const auto is_visible = [&](const Vec2& p) { return visible.contains({p, p}); };
  if (closed && line.size() > 2 && stroke.gap <= 0.0 && std::all_of(line.begin(), line.end(), is_visible)) {
    add_ring(contours, line, half);
    return contours;
  }
  RunWalker walker(stroke, visible);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) walker.add_segment(line[i], line[i + 1]);
  if (closed) walker.add_segment(line.back(), line.front());
  for (const std::vector<Vec2>& run : walker.runs())
    if (const auto distinct = without_repeats(run, false); distinct.size() > 1)
      add_run(contours, distinct, half, stroke.cap);
  return contours;
}

Contour ellipse_contour(const Vec2& centre, const Vec2& radii, double turn_degrees) {
  const double turn = turn_degrees * degrees_to_radians;
  const Vec2 first = radii.x * Vec2(std::cos(turn), std::sin(turn));
  const Vec2 second = radii.y * Vec2(-std::sin(turn), std::cos(turn));
  const int steps = std::max(arc_steps(std::max(radii.x, radii.y), 2.0 * std::numbers::pi), 8);
  Contour contour;
  for (int i = 0; i < steps; ++i) {
    const double a = 2.0 * std::numbers::pi * i / steps;
    contour.push_back(centre + std::cos(a) * first + std::sin(a) * second);
  }
  return contour;
}

Contour rounded_contour(const Rect& box, double radius) {
  const double r = std::clamp(radius, 0.0, 0.5 * std::min(box.size().x, box.size().y));
  const Vec2 low = box.low + r, high = box.high - r;
  Contour contour;
  constexpr double quarter = 0.5 * std::numbers::pi;
  add_arc(contour, high, {r, 0.0}, quarter);
  add_arc(contour, {low.x, high.y}, {0.0, r}, quarter);
  add_arc(contour, low, {-r, 0.0}, quarter);
  add_arc(contour, {high.x, low.y}, {0.0, -r}, quarter);
  return contour;
}

}  // namespace sinew
