#include "engine/body/figure_part.h"

#include <array>
#include <cassert>

namespace sinew {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr double least_radius = 1e-3;

/// Beyond these a slope is the table's noise, and counts no more in turning a radial distance into a normal one.
constexpr double steepest_along = 1.5, steepest_across = 1.2;

/// How deep inside a part the field goes on falling: it must not reach through to where other parts are joined.
constexpr double deepest = 0.02;

/// Over so much difference, less than its cap by this, a part's rounded end goes over into the plane that closes it:
/// not at all at fingertips.
constexpr double unrounded_cap = 0.006;

/// Catmull-Rom weights of four neighbours, and their slopes, at fraction f between the middle two.
struct Spline {
  std::array<double, 4> weight, slope;

  explicit Spline(double f)
      : weight{-0.5 * f + f * f - 0.5 * f * f * f, 1.0 - 2.5 * f * f + 1.5 * f * f * f,
               0.5 * f + 2.0 * f * f - 1.5 * f * f * f, -0.5 * f * f + 0.5 * f * f * f},
        slope{-0.5 + 2.0 * f - 1.5 * f * f, -5.0 * f + 4.5 * f * f, 0.5 + 4.0 * f - 4.5 * f * f, -f + 1.5 * f * f} {}
};

double positive_angle(double y, double x) {
  const double angle = std::atan2(y, x);
  return angle < 0.0 ? angle + full_turn : angle;
}

}  // namespace

RadiusTable::Sample RadiusTable::at(double row, double column) const {
  row = std::clamp(row, 0.0, static_cast<double>(rows - 1));
  const int i = std::clamp(static_cast<int>(row), 0, rows - 2);
  const int j = static_cast<int>(std::floor(column));
  const Spline along(row - i), across(column - j);
  Sample sample;
  for (int a = 0; a < 4; ++a) {
    const double* values_of_row = &values[static_cast<std::size_t>(std::clamp(i + a - 1, 0, rows - 1) * columns)];
    double value = 0.0, slope = 0.0;
    for (int b = 0; b < 4; ++b) {
      const int k = ((j + b - 1) % columns + columns) % columns;
      value += across.weight[b] * values_of_row[k];
      slope += across.slope[b] * values_of_row[k];
    }
    sample.radius += along.weight[a] * value;
    sample.by_row += along.slope[a] * value;
    sample.by_column += along.weight[a] * slope;
  }
  return sample;
}

Vec3 BodyPart::v(std::size_t segment) const {
  return glm::cross(glm::normalize(axis[segment + 1] - axis[segment]), u[segment]);
}

double BodyPart::t_at(std::size_t index) const {
  double t = 0.0;
  for (std::size_t i = 0; i < index; ++i) t += glm::distance(axis[i], axis[i + 1]);
  return t;
}

double BodyPart::length() const { return t_at(axis.size() - 1); }

std::size_t BodyPart::segment_at(double t) const {
  std::size_t segment = 0;
  for (double end = glm::distance(axis[0], axis[1]); segment + 2 < axis.size() && t > end; ++segment)
    end += glm::distance(axis[segment + 1], axis[segment + 2]);
  return segment;
}

Vec3 BodyPart::direction(double t) const {
  const std::size_t segment = segment_at(t);
  return glm::normalize(axis[segment + 1] - axis[segment]);
}

Vec3 BodyPart::on_axis(double t) const {
  const std::size_t segment = segment_at(t);
  return axis[segment] + (t - t_at(segment)) * direction(t);
}

double BodyPart::row_of(double t) const { return (std::clamp(t, first, last) - first) * rows_per_length(); }

double BodyPart::rows_per_length() const { return (radius.rows - 1) / (last - first); }

void BodyPart::section_centre(double t, Vec2& centre_at, Vec2& slope) const {
  const double row = row_of(t);
  const int i = std::clamp(static_cast<int>(row), 0, radius.rows - 2);
  const Spline along(row - i);
  centre_at = slope = Vec2(0.0);
  for (int a = 0; a < 4; ++a) {
    const Vec2& c = centre[static_cast<std::size_t>(std::clamp(i + a - 1, 0, radius.rows - 1))];
    centre_at += along.weight[a] * c;
    slope += along.slope[a] * rows_per_length() * c;
  }
  if (t < first || t > last) slope = Vec2(0.0);
}

BodyPart::Foot BodyPart::foot_of(const Vec3& p) const {
  Foot best;
  double nearest = INFINITY, start = 0.0;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const Vec3 step = axis[i + 1] - axis[i];
    const double length = glm::length(step);
    const Vec3 direction = step / length;
    const double free = glm::dot(p - axis[i], direction);
    double t = free;
    if (i > 0) t = std::max(t, 0.0);
    if (i + 2 < axis.size()) t = std::min(t, length);
    const Vec3 away = p - axis[i] - t * direction;
    const double squared = glm::dot(away, away);
    if (squared < nearest) {
      nearest = squared;
      best = {i, start + t, t != free};
    }
    start += length;
  }
  return best;
}

double BodyPart::along(const Vec3& p) const { return foot_of(p).t; }

FieldSample BodyPart::tube_at(const Vec3& p) const {
  const Foot foot = foot_of(p);
  const Vec3 direction = glm::normalize(axis[foot.segment + 1] - axis[foot.segment]);
  const Vec3 &side_u = u[foot.segment], side_v = glm::cross(direction, side_u);
  Vec2 middle, middle_slope;
  section_centre(foot.t, middle, middle_slope);
  const Vec3 from_axis = p - axis[foot.segment];
  const double a = glm::dot(from_axis, side_u) - middle.x, b = glm::dot(from_axis, side_v) - middle.y;
  const double rho = std::max(std::sqrt(a * a + b * b), 1e-9);
  const double per_column = radius.columns / full_turn;
  const RadiusTable::Sample r = radius.at(row_of(foot.t), positive_angle(b, a) * per_column);
  const double R = std::max(r.radius, least_radius);

  const double over = foot.t < first ? foot.t - first : foot.t > last ? foot.t - last : 0.0;
  const double slope_along = over == 0.0 ? r.by_row * rows_per_length() : 0.0;
  const double slope_across = r.by_column * per_column;
  const double cap = over < 0.0 ? cap_first : cap_last;
  const double steep_along = std::clamp(slope_along, -steepest_along, steepest_along);
  const double steep_across = std::clamp(slope_across / std::max(R, 3e-3), -steepest_across, steepest_across);
  const double cosine = 1.0 / std::sqrt(1.0 + steep_along * steep_along + steep_across * steep_across);

  const Vec3 grad_t = foot.in_corner ? Vec3(0.0) : direction;
  const Vec3 grad_a = side_u - middle_slope.x * grad_t, grad_b = side_v - middle_slope.y * grad_t;
  const Vec3 grad_rho = (a * grad_a + b * grad_b) / rho;
  const Vec3 grad_angle = (a * grad_b - b * grad_a) / (rho * rho);
  const Vec3 grad_R = slope_along * grad_t + slope_across * grad_angle;

  FieldSample sample;
  if (over == 0.0) {
    sample.gradient = cosine * (grad_rho - grad_R);
    sample.distance = std::max((rho - R) * cosine, -std::min(cap_last, deepest));
    return sample;
  }
  // The cap goes on as the sections end: where they narrow towards it, so does it at first.
  const double beyond_end = std::abs(over), side = over < 0.0 ? -1.0 : 1.0;
  const double narrowing = std::clamp(-side * r.by_row * rows_per_length(), 0.0, steepest_along);
  const double left = std::max(1.0 - beyond_end / cap, 0.0);
  const double narrowed = std::max(R - narrowing * beyond_end * left * left, least_radius);
  const double narrowed_slope = -narrowing * left * (left - 2.0 * beyond_end / cap) * side;
  const double stretched = beyond_end * R / cap;
  const double round = std::max(std::sqrt(rho * rho + stretched * stretched), 1e-9);
  sample.distance = (round - narrowed) * cosine;
  sample.gradient =
      cosine * ((rho * grad_rho + over * (R / cap) * (R / cap) * grad_t) / round - grad_R - narrowed_slope * grad_t);
  // A cap that is scaled by the radius would leave a ghost of the part along its axis: a plane beyond its end cuts that
  // off, rounded where the two meet.
  const double end_rounding = std::max(std::min(cap, deepest) - unrounded_cap, 1e-6);
  const double plane = beyond_end - std::min(cap, deepest), apart = std::abs(plane - sample.distance);
  const double shared = 0.5 * std::max(1.0 - apart / end_rounding, 0.0);
  const double share = plane > sample.distance ? 1.0 - shared : shared;
  sample.distance = std::max(plane, sample.distance) + shared * shared * end_rounding;
  sample.gradient = glm::mix(sample.gradient, side * grad_t, share);
  return sample;
}

FieldSample BodyPart::ball_at(const Vec3& p) const {
  const Vec3 from_centre = p - ball_centre, side = glm::cross(pole, zero);
  const double h = glm::dot(from_centre, pole), a = glm::dot(from_centre, zero), b = glm::dot(from_centre, side);
  const double rho = std::max(glm::length(from_centre), 1e-9), flat = std::max(std::hypot(a, b), 1e-9);
  const double latitude = std::atan2(h, flat), longitude = positive_angle(b, a);
  const double per_row = (radius.rows - 1) / std::numbers::pi, per_column = radius.columns / full_turn;
  const RadiusTable::Sample r =
      radius.at((latitude + 0.5 * std::numbers::pi) * per_row, (longitude + warp * std::sin(longitude)) * per_column);
  const double R = std::max(r.radius, least_radius);
  const double by_latitude = r.by_row * per_row;
  const double by_longitude = r.by_column * per_column * (1.0 + warp * std::cos(longitude));
  const double steep_latitude = std::clamp(by_latitude / R, -steepest_across, steepest_across);
  const double steep_longitude =
      std::clamp(by_longitude / R / std::max(std::cos(latitude), 0.15), -steepest_across, steepest_across);
  const double cosine = 1.0 / std::sqrt(1.0 + steep_latitude * steep_latitude + steep_longitude * steep_longitude);
  const Vec3 outward = from_centre / rho;
  const Vec3 level = (a * zero + b * side) / flat;
  const Vec3 grad_latitude = (flat * pole - h * level) / (rho * rho);
  const Vec3 grad_longitude = (a * side - b * zero) / (flat * std::max(flat, 0.15 * rho));
  return {(rho - R) * cosine, cosine * (outward - by_latitude * grad_latitude - by_longitude * grad_longitude)};
}

FieldSample BodyPart::at(const Vec3& p) const { return ball ? ball_at(p) : tube_at(p); }

Vec3 BodyPart::on_surface(double t, double angle, double scale) const {
  assert(!ball);
  const std::size_t segment = segment_at(t);
  Vec2 middle, slope;
  section_centre(t, middle, slope);
  const double R = scale * radius.at(row_of(t), angle / full_turn * radius.columns).radius;
  return on_axis(t) + (middle.x + R * std::cos(angle)) * u[segment] + (middle.y + R * std::sin(angle)) * v(segment);
}

Vec3 BodyPart::on_ball(double latitude, double longitude) const {
  assert(ball);
  const double R = radius
                       .at((latitude + 0.5 * std::numbers::pi) / std::numbers::pi * (radius.rows - 1),
                           (longitude + warp * std::sin(longitude)) / full_turn * radius.columns)
                       .radius;
  const Vec3 side = glm::cross(pole, zero);
  return ball_centre + R * (std::cos(latitude) * (std::cos(longitude) * zero + std::sin(longitude) * side) +
                            std::sin(latitude) * pole);
}

}  // namespace sinew
