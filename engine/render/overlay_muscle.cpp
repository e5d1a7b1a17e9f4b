#include "engine/render/overlay_painter.h"

namespace sinew {
namespace {

/// How far the plane that is shown goes beyond two sigmas to either side, and beyond the limb's ends along it.
constexpr double plane_reach = 2.4, plane_overhang = 0.06;

std::vector<Vec3> ellipse_in_plane(const MuscleOverlay& muscle, double sigmas) {
  constexpr int corners = 96;
  std::vector<Vec3> points;
  for (int i = 0; i < corners; ++i) {
    const double a = 2.0 * std::numbers::pi * i / corners;
    points.push_back(muscle.centre + sigmas * (std::cos(a) * muscle.along + std::sin(a) * muscle.across));
  }
  return points;
}

/// Every so many-th vertex is drawn, so that a dense mesh is not painted over.
std::size_t stride(std::size_t points) {
  constexpr std::size_t most = 600;
  return points / most + 1;
}

/// The dots of a dense or a distant region are smaller, so that the surface shows between them.
double dot_radius(double pixels_across, std::size_t points) {
  return 0.24 * pixels_across / std::sqrt(double(std::max<std::size_t>(points, 1)));
}

/// A shape on the screen: where it is, and its corners farthest to the left and to the right.
struct Extent {
  Rect box{Vec2(INFINITY), Vec2(-INFINITY)};
  Vec2 left{0.0}, right{0.0};

  void add(const Vec2& p) {
    if (p.x < box.low.x) left = p;
    if (p.x > box.high.x) right = p;
    box = {glm::min(box.low, p), glm::max(box.high, p)};
  }
};

}  // namespace

MuscleOverlay posed_muscle(const Muscle& muscle, const MuscleRegion& region, const Mat4& rest_to_world,
                           std::span<const Vec3> positions, std::span<const Vec3> normals, double activation) {
  const ProjectionPlane& plane = region.plane;
  const auto point = [&](const Vec3& p) { return Vec3(rest_to_world * Vec4(p, 1.0)); };
  const Mat3 linear(rest_to_world);
  MuscleOverlay overlay;
  overlay.name = muscle.name;
  overlay.activation = activation;
  const double half = std::max(plane_reach * muscle.sigma.y, 0.12 * plane.length);
  const double begin = std::min(0.0, muscle.from) - plane_overhang, end = std::max(1.0, muscle.to) + plane_overhang;
  const auto corner = [&](double t, double across) {
    return point(plane.bone + t * plane.length * plane.axis + across * plane.side);
  };
  overlay.plane = {corner(begin, -half), corner(end, -half), corner(end, half), corner(begin, half)};
  overlay.centre = point(region.centre);
  overlay.along = linear * (muscle.sigma.x * plane.axis);
  overlay.across = linear * (muscle.sigma.y * plane.side);
  overlay.normal = unit_or(cofactor(linear) * plane.normal, plane.normal);
  for (const RegionVertex& v : region.vertices) {
    overlay.points.push_back(positions[v.vertex]);
    overlay.feet.push_back(point(region.centre + v.x * plane.axis + v.y * plane.side));
    if (!normals.empty()) overlay.normals.push_back(normals[v.vertex]);
  }
  return overlay;
}

void OverlayPainter::muscle_plane(const MuscleOverlay& muscle) {
  const Contour plane = screen.polygon(muscle.plane);
  canvas.polygon(plane, faded(palette::plane, 0.16));
  polyline_3d(muscle.plane, {.colour = faded(palette::plane, 0.85), .width = line(1.4)}, true);
  for (std::size_t i = 0; i < plane.size(); ++i) layout.avoid(plane[i], plane[(i + 1) % plane.size()]);
}

/// From each point to the plane.
void OverlayPainter::muscle_feet(const MuscleOverlay& muscle, double dot) {
  const std::size_t step = stride(muscle.points.size());
  for (std::size_t i = 0; i < muscle.feet.size(); i += step)
    line_3d(muscle.points[i], muscle.feet[i], {.colour = faded(palette::muscle, 0.45), .width = line(0.9)});
  for (std::size_t i = 0; i < muscle.feet.size(); i += step)
    if (const auto seen = screen.point(muscle.feet[i])) {
      canvas.disc(seen->at, dot + line(0.5), palette::paper);
      canvas.disc(seen->at, dot, palette::plane);
    }
}

void OverlayPainter::muscle_points(const MuscleOverlay& muscle, double pixels_across) {
  const double reach = 0.5 * (glm::length(muscle.along) + glm::length(muscle.across));
  const std::size_t step = stride(muscle.points.size());
  const double dot = std::clamp(dot_radius(pixels_across, muscle.points.size() / step), line(0.7), line(1.7));
  if (muscle.projection) muscle_feet(muscle, dot);
  for (std::size_t i = 0; i < muscle.points.size(); i += step) {
    const Vec3& p = muscle.points[i];
    const bool turned = !muscle.normals.empty();
    const double opacity = turned && !screen.faces(p, muscle.normals[i]) ? 0.3 : 0.9;
    if (muscle.arrows && turned) {
      if (const auto seen = screen.segment(p, p + 0.35 * reach * muscle.normals[i]))
        canvas.arrow(seen->first.at, seen->second.at, {.colour = faded(palette::muscle, opacity), .width = line(1.0)},
                     line(4.5));
    } else if (const auto seen = screen.point(p)) {
      canvas.disc(seen->at, dot, faded(palette::muscle, opacity));
    }
  }
}

/// The ellipses of one and two sigmas and the way that the plane faces.
void OverlayPainter::muscle_gaussian(const MuscleOverlay& muscle, double bold) {
  for (const auto& [sigmas, dash] : {std::pair(1.0, 0.0), std::pair(2.0, bold * line(5.0))}) {
    const std::vector<Vec3> ellipse = ellipse_in_plane(muscle, sigmas);
    polyline_3d(ellipse, {.colour = faded(palette::paper, 0.6), .width = bold * line(3.2)}, true);
    polyline_3d(ellipse, {.colour = palette::muscle, .width = bold * line(1.8), .dash = dash, .gap = 0.7 * dash}, true);
  }
  if (!screen.point(muscle.centre)) return;
  const double reach = 0.5 * (glm::length(muscle.along) + glm::length(muscle.across));
  if (const auto arrow = screen.segment(muscle.centre, muscle.centre + 2.0 * reach * muscle.normal)) {
    const double head = std::min(line(10.0), 0.45 * glm::distance(arrow->first.at, arrow->second.at));
    canvas.arrow(arrow->first.at, arrow->second.at, {.colour = faded(palette::paper, 0.7), .width = bold * line(4.0)},
                 1.2 * head);
    canvas.arrow(arrow->first.at, arrow->second.at, {.colour = palette::plane, .width = bold * line(2.0)}, head);
    layout.avoid(arrow->first.at, arrow->second.at);
  }
}

void OverlayPainter::muscle(const MuscleOverlay& muscle) {
  Extent extent;
  for (const Vec3& p : ellipse_in_plane(muscle, 2.0))
    if (const auto seen = screen.point(p)) extent.add(seen->at);
  const auto centre = screen.point(muscle.centre);
  const double across = extent.left.x < extent.right.x ? glm::length(extent.box.size()) : 0.0;
  // Seen from afar the same lines would fill the ellipse that they outline.
  const double bold = std::clamp(across / line(120.0), 0.6, 1.0);
  const bool plane_is_shown = muscle.gaussian || muscle.projection;
  if (plane_is_shown) muscle_plane(muscle);
  muscle_points(muscle, across);
  if (muscle.gaussian) muscle_gaussian(muscle, bold);
  if (!centre) return;
  const double arm = bold * line(5.0);
  for (const Colour& colour : {palette::paper, palette::ink}) {
    if (!plane_is_shown) break;
    const Stroke stroke{.colour = colour, .width = bold * line(colour == palette::ink ? 1.7 : 3.8), .cap = Cap::round};
    canvas.line(centre->at - Vec2(arm, arm), centre->at + Vec2(arm, arm), stroke);
    canvas.line(centre->at - Vec2(arm, -arm), centre->at + Vec2(arm, -arm), stroke);
  }
  if (across == 0.0) return;

  layout.avoid(extent.box);
  const bool leftwards = centre->at.x < 0.5 * canvas.width();
  Label label;
  label.text = fmt::format("{}  {:.0f} %", muscle.name, 100.0 * muscle.activation);
  label.request.anchor = leftwards ? extent.left : extent.right;
  label.request.away = {leftwards ? -1.0 : 1.0, 0.0};
  label.request.clearance = line(14.0);
  label.request.may_cover = true;
  label.importance = 1e5;
  label.tick = palette::muscle;
  label.boxed = true;
  add_label(std::move(label));
}

}  // namespace sinew
