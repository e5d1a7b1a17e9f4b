#include "engine/render/screen.h"

namespace sinew {
namespace {

/// In clip space a point lies beyond the near plane where z > 0.
bool beyond(const Vec4& clip) { return clip.z > 0.0; }

bool finite(const Vec4& v) { return std::isfinite(v.x + v.y + v.z + v.w); }

/// Where the segment meets the near plane.
Vec4 crossing(const Vec4& a, const Vec4& b) { return a + (a.z / (a.z - b.z)) * (b - a); }

}  // namespace

Screen::Screen(const Viewpoint& viewpoint, int width, int height)
    : view_projection_(viewpoint.view_projection(double(width) / height)),
      eye_(viewpoint.eye, 1.0),
      size_(width, height) {
  if (!viewpoint.is_parallel()) return;
  eye_ = Vec4(viewpoint.back, 0.0);
  parallel_ = {viewpoint.near_plane, viewpoint.far_plane - viewpoint.near_plane};
}

ScreenPoint Screen::on_screen(const Vec4& clip) const {
  const double depth = eye_.w > 0.0 ? clip.w : parallel_.x + clip.z * parallel_.y;
  return {(Vec2(clip.x, clip.y) / clip.w * 0.5 + 0.5) * size_, depth};
}

std::optional<ScreenPoint> Screen::point(const Vec3& p) const {
  const Vec4 c = clip(p);
  if (!finite(c) || !beyond(c)) return {};
  return on_screen(c);
}

std::optional<std::pair<ScreenPoint, ScreenPoint>> Screen::segment(const Vec3& a, const Vec3& b) const {
  Vec4 from = clip(a), to = clip(b);
  if (!finite(from) || !finite(to) || (!beyond(from) && !beyond(to))) return {};
  if (!beyond(from)) from = crossing(from, to);
  if (!beyond(to)) to = crossing(to, from);
  return std::pair(on_screen(from), on_screen(to));
}

Contour Screen::polygon(std::span<const Vec3> corners) const {
  Contour result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec4 from = clip(corners[i]), to = clip(corners[(i + 1) % corners.size()]);
    if (!finite(from) || !finite(to)) return {};
    if (beyond(from)) result.push_back(on_screen(from).at);
    if (beyond(from) != beyond(to)) result.push_back(on_screen(crossing(from, to)).at);
  }
  return result;
}

}  // namespace sinew
