#include "engine/face/lid_opening.h"

#include <algorithm>
#include <optional>

#include "engine/face/surface_ways.h"

namespace sinew {
namespace {

constexpr int samples = 40;
constexpr double degree = degrees_to_radians;

double angle_of(const Vec3& from_centre) { return std::atan2(from_centre.y, from_centre.z); }

std::uint32_t nearest_skin(const FaceMesh& mesh, const Vec3& p) {
  double nearest = INFINITY;
  std::uint32_t best = 0;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.kind(v) != ShellKind::skin) continue;
    const double d = glm::distance(mesh.positions[v], p);
    if (d < nearest) nearest = d, best = v;
  }
  return best;
}

/// The mesh's edges between two places, which follow a lid's edge where both lie on it; straight where they do not.
std::vector<Vec3> along_edges(const FaceMesh& mesh, const Vec3& from, const Vec3& to) {
  constexpr double longest = 1.25;
  const std::uint32_t start = nearest_skin(mesh, from), end = nearest_skin(mesh, to);
  std::vector<std::uint32_t> before;
  const std::vector<double> ways =
      surface_ways(mesh.positions, mesh.graph, {{0.0, start}}, longest * glm::distance(from, to), &before);
  std::vector<Vec3> out;
  if (std::isfinite(ways[end]))
    for (std::uint32_t v = before[end]; v != start && v != before[v]; v = before[v]) out.push_back(mesh.positions[v]);
  std::ranges::reverse(out);
  return out;
}

/// The lid's edge by its landmarks, [samples + 1], or nothing where none is named.
std::vector<double> edge_by_marks(const FaceMesh& mesh, const std::string& lid, const std::string& end,
                                  const Vec3& centre) {
  const Vec3 inner = mesh.marks.at("eyeInner" + end), outer = mesh.marks.at("eyeOuter" + end);
  std::vector<Vec3> marks{inner};
  for (const char* part : {"Inner", "", "Outer"})
    if (const auto found = mesh.marks.find(lid + part + end); found != mesh.marks.end()) marks.push_back(found->second);
  if (marks.size() == 1) return {};
  marks.push_back(outer);
  // Along x, which the lids' turn leaves as it is.
  std::vector<Vec3> points{inner};
  const double outward = outer.x > inner.x ? 1.0 : -1.0;
  for (std::size_t i = 1; i < marks.size(); ++i) {
    std::vector<Vec3> between = along_edges(mesh, marks[i - 1], marks[i]);
    between.push_back(marks[i]);
    for (const Vec3& p : between)
      if (outward * (p.x - points.back().x) > 0) points.push_back(p);
  }
  if (points.size() == 1) return {};
  std::vector<double> out;
  for (int i = 0; i <= samples; ++i) {
    const double x = glm::mix(inner.x, outer.x, double(i) / samples);
    std::size_t k = 0;
    while (k + 2 < points.size() && outward * (points[k + 1].x - x) < 0) ++k;
    const double t = std::clamp((x - points[k].x) / (points[k + 1].x - points[k].x), 0.0, 1.0);
    out.push_back(glm::mix(angle_of(points[k] - centre), angle_of(points[k + 1] - centre), t));
  }
  return out;
}

void smooth(std::vector<double>& values) {
  for (int round = 0; round < 2; ++round) {
    const std::vector<double> old = values;
    for (std::size_t i = 1; i + 1 < values.size(); ++i)
      values[i] = 0.25 * old[i - 1] + 0.5 * old[i] + 0.25 * old[i + 1];
  }
}

/// 1 at the lid's edge, 0 where the fold ends.
double share(double beyond, double end) {
  constexpr double whole = 2.2 * degree;
  return 1.0 - smoothstep01((beyond - whole) / (end - whole));
}

}  // namespace

LidOpening::LidOpening(const FaceMesh& mesh, const TriangleTree& skin, int side)
    : centre_(mesh.eye_centres[static_cast<std::size_t>(side)]), radius_(mesh.eye_radius), fold_(30 * degree) {
  constexpr double most = 80 * degree, step = degree, reach = 2.2, off_marks = 5 * degree;
  const std::string end = side == 0 ? "Left" : "Right";
  inner_ = mesh.marks.at("eyeInner" + end);
  outer_ = mesh.marks.at("eyeOuter" + end);
  const std::vector<double> upper_mark = edge_by_marks(mesh, "lidUpper", end, centre_),
                            lower_mark = edge_by_marks(mesh, "lidLower", end, centre_);
  const double from = angle_of(inner_ - centre_), to = angle_of(outer_ - centre_);
  upper_.resize(samples + 1);
  lower_.resize(samples + 1);
  int free = 0;
  double off = 0.0;
  for (int i = 0; i <= samples; ++i) {
    const double along = double(i) / samples;
    const Vec3 start(glm::mix(inner_.x, outer_.x, along), centre_.y, centre_.z);
    // From the ball's surface on: what lies inside is not seen.
    const double aside = start.x - centre_.x, surface = std::sqrt(std::max(0.0, radius_ * radius_ - aside * aside));
    const auto blocked = [&](double angle) {
      const Vec3 way(0, std::sin(angle), std::cos(angle));
      return skin.first_crossing(start + surface * way, way, reach * radius_ - surface).has_value();
    };
    const auto edge = [&](double inside, double outside) {
      for (int k = 0; k < 8; ++k) {
        const double half = 0.5 * (inside + outside);
        (blocked(half) ? outside : inside) = half;
      }
      return inside;
    };
    double middle = glm::mix(from, to, along);
    if (!upper_mark.empty() && !lower_mark.empty())
      middle = 0.5 * (upper_mark[static_cast<std::size_t>(i)] + lower_mark[static_cast<std::size_t>(i)]);
    std::optional<double> clear;
    for (int k = 0; k <= 12 && !clear; ++k)
      for (const double a : {middle + k * step, middle - k * step})
        if (!clear && !blocked(a)) clear = a;
    double up = middle, low = middle;
    if (clear && i > 0 && i < samples) {
      ++free;
      for (up = *clear; up < most && !blocked(up + step);) up += step;
      up = edge(up, up + step);
      for (low = *clear; low > -most && !blocked(low - step);) low -= step;
      low = edge(low, low - step);
    }
    const auto at = static_cast<std::size_t>(i);
    if (!upper_mark.empty()) off += std::abs(up - upper_mark[at]) / samples;
    if (!lower_mark.empty()) off += std::abs(low - lower_mark[at]) / samples;
    upper_[at] = std::max(up, low);
    lower_[at] = std::min(up, low);
  }
  const bool told = !upper_mark.empty() && !lower_mark.empty();
  const bool ball = mesh.has_eyeball[static_cast<std::size_t>(side)];
  // Where the ball would be is a guess without one: then the landmarks alone say where the lids are.
  open_ = told || (ball && free > samples / 4);
  if (told && !ball) off = INFINITY;
  // Where something else stands before the eye, such as a film of tears, the landmarks are believed.
  if (off > off_marks && !upper_mark.empty()) upper_ = upper_mark;
  if (off > off_marks && !lower_mark.empty()) lower_ = lower_mark;
  for (std::size_t i = 0; i <= samples; ++i)
    if (upper_[i] < lower_[i]) upper_[i] = lower_[i] = 0.5 * (upper_[i] + lower_[i]);
  smooth(upper_);
  smooth(lower_);
  if (const auto brow = mesh.marks.find("browMiddle" + end); brow != mesh.marks.end())
    fold_ = std::clamp(0.62 * (angle_of(brow->second - centre_) - upper(0.5)), 18 * degree, 40 * degree);
}

double LidOpening::at(const std::vector<double>& values, double along) {
  const double place = std::clamp(along, 0.0, 1.0) * samples;
  const auto i = std::min<std::size_t>(samples - 1, static_cast<std::size_t>(place));
  return glm::mix(values[i], values[i + 1], place - static_cast<double>(i));
}

std::array<double, 2> LidOpening::closing(const Vec3& place) const {
  constexpr double lower_fold = 26 * degree, beyond_corner = 0.18, near = 1.6, far = 2.4;
  if (!open_) return {0.0, 0.0};
  const Vec3 d = place - centre_;
  const double distance = std::hypot(d.y, d.z), along = (place.x - inner_.x) / (outer_.x - inner_.x);
  const double outside = std::max({0.0, -along, along - 1.0}) / beyond_corner;
  if (outside >= 1.0 || distance > far * radius_ || distance < 0.3 * radius_ || d.z < -0.2 * radius_) return {0.0, 0.0};
  const double opening = upper(along) - lower(along);
  if (opening < 0.5 * degree) return {0.0, 0.0};
  const double taper = (1.0 - outside) * (1.0 - smoothstep01((distance / radius_ - near) / (far - near)));
  // A little further than the other lid, so that no slit stays; more in the corners, where it would stay longest.
  const double corner = std::clamp(1.0 - std::min(along, 1.0 - along) / 0.16, 0.0, 1.0);
  const double whole = taper * (1.04 * opening + 0.02 + 0.08 * corner);
  const double angle = angle_of(d), middle = 0.5 * (upper(along) + lower(along));
  if (angle >= middle) return {whole * share(angle - upper(along), fold_), 0.0};
  return {0.0, whole * share(lower(along) - angle, lower_fold)};
}

}  // namespace sinew
