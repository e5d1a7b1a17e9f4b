#include "engine/view/gizmo.h"

#include <algorithm>

namespace sinew {
namespace {

constexpr int pieces = 72;
constexpr double step_degrees = 5.0;
/// Cosine between sight and axis under which a ring is seen from the side.
constexpr double side_on = 0.2;

/// Two axes at right angles to a third.
std::array<Vec3, 2> across(const Vec3& axis) {
  const Vec3 helper = std::abs(axis.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  const Vec3 first = glm::normalize(glm::cross(helper, axis));
  return {first, glm::cross(axis, first)};
}

double to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a;
  const double squared = glm::dot(way, way);
  const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, way) / squared, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * way);
}

}  // namespace

Gizmo make_gizmo(const JointStand& stand, const Viewpoint& viewpoint, double picture_height, double pixels) {
  // R = Rz Ry Rx: x turns about an axis that y and z have turned, z about one of the model's own.
  const Quat z = rotation_xyz_degrees({0, 0, stand.degrees.z}), y = rotation_xyz_degrees({0, stand.degrees.y, 0});
  Gizmo gizmo;
  gizmo.centre = stand.joint.place;
  gizmo.axes = {stand.joint.carried * (z * y * Vec3(1, 0, 0)), stand.joint.carried * (z * Vec3(0, 1, 0)),
                stand.joint.carried * Vec3(0, 0, 1)};
  gizmo.radius = viewpoint.height_at(gizmo.centre) * pixels / std::max(picture_height, 1.0);
  return gizmo;
}

RingLines ring_lines(const Gizmo& gizmo, int ring, const Screen& screen) {
  const auto [first, second] = across(gizmo.axes[static_cast<std::size_t>(ring)]);
  RingLines out;
  const Vec3 to_eye = screen.towards_eye(gizmo.centre);
  // The front half is one run: it begins where the ring comes round.
  const double begin = std::atan2(glm::dot(to_eye, second), glm::dot(to_eye, first)) - 0.5 * std::numbers::pi;
  for (int i = 0; i <= pieces; ++i) {
    const double a = begin + 2.0 * std::numbers::pi * i / pieces;
    const auto seen = screen.point(gizmo.centre + gizmo.radius * (std::cos(a) * first + std::sin(a) * second));
    if (!seen) continue;
    out.whole.push_back(seen->at);
    if (2 * i <= pieces) out.front.push_back(seen->at);
  }
  return out;
}

int ring_near(const Gizmo& gizmo, const Screen& screen, const Vec2& at, double reach) {
  int nearest = -1;
  double least = reach;
  for (int ring = 0; ring < 3; ++ring) {
    const std::vector<Vec2> line = ring_lines(gizmo, ring, screen).front;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      if (const double away = to_segment(at, line[i], line[i + 1]); away < least) least = away, nearest = ring;
  }
  return nearest;
}

RingDrag::RingDrag(const Gizmo& gizmo, int ring, const Viewpoint& viewpoint, const Vec2& size, const Vec2& at)
    : gizmo_(gizmo), ring_(ring), viewpoint_(viewpoint), size_(size), taken_(at) {
  const Vec3& axis = gizmo.axes[static_cast<std::size_t>(ring)];
  const auto axes = across(axis);
  first_ = axes[0];
  second_ = axes[1];
  const Vec3 sight = glm::normalize(viewpoint.towards_eye(gizmo.centre));
  from_side_ = std::abs(glm::dot(sight, axis)) < side_on;
  const auto start = angle(at);
  if (!from_side_ && start) {
    last_ = *start;
    return;
  }
  // Seen from the side the front of a ring goes across the picture along cross(axis, sight).
  from_side_ = true;
  const Vec3 way = glm::normalize(glm::cross(axis, sight));
  const Vec2 seen(glm::dot(way, viewpoint.right), -glm::dot(way, viewpoint.up));
  const double pixels = gizmo.radius * size.y / viewpoint.height_at(gizmo.centre);
  tangent_ = radians_to_degrees / std::max(pixels, 1.0) * seen;
}

std::optional<double> RingDrag::angle(const Vec2& at) const {
  const auto met =
      meet_plane(pointer_ray(viewpoint_, at, size_), gizmo_.centre, gizmo_.axes[static_cast<std::size_t>(ring_)]);
  if (!met) return std::nullopt;
  const Vec3 from = *met - gizmo_.centre;
  return radians_to_degrees * std::atan2(glm::dot(from, second_), glm::dot(from, first_));
}

double RingDrag::follow(const Vec2& at) {
  if (from_side_) return turned_ = glm::dot(at - taken_, tangent_);
  if (const auto now = angle(at)) {
    turned_ += std::remainder(*now - last_, 360.0);
    last_ = *now;
  }
  return turned_;
}

double turned_number(double from, double by, const DegreeRange& range, bool steps) {
  double number = std::clamp(from + by, range.low, range.high);
  if (!steps) return number;
  number = step_degrees * std::round(number / step_degrees);
  if (number > range.high) number = step_degrees * std::floor(range.high / step_degrees);
  if (number < range.low) number = step_degrees * std::ceil(range.low / step_degrees);
  return std::clamp(number, range.low, range.high);
}

}  // namespace sinew
