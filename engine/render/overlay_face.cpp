#include <algorithm>
#include <array>

#include "engine/render/overlay_painter.h"

namespace sinew {
namespace {

constexpr Colour guide_colour{20, 92, 168};

}  // namespace

/// What faces the eye whole and strong, what is behind the head thin and broken.
void OverlayPainter::face_cuts(std::span<const SurfaceCut> cuts, const Colour& colour, double width) {
  for (const bool front : {false, true}) {
    std::size_t n = 0;
    for (const SurfaceCut& cut : cuts) {
      if (screen.faces(cut.from, cut.normal) != front) continue;
      if (!front && ++n % 2 == 0) continue;
      line_3d(
          cut.from, cut.to,
          {.colour = front ? colour : faded(colour, 0.35), .width = front ? width : 0.6 * width, .cap = Cap::round});
    }
  }
}

void OverlayPainter::face_guide(const FaceGuideLine& guide) {
  std::vector<SurfaceCut> halo(guide.cuts.begin(), guide.cuts.end());
  std::erase_if(halo, [&](const SurfaceCut& cut) { return !screen.faces(cut.from, cut.normal); });
  face_cuts(halo, faded(palette::paper, 0.55), line(3.4));
  face_cuts(guide.cuts, guide_colour, line(guide.name.empty() ? 1.1 : 1.7));
  if (guide.name.empty()) return;
  // At the end that is farthest to the right; the centre line at its top.
  const bool upright = guide.name == "centre line";
  std::optional<Vec2> end;
  for (const SurfaceCut& cut : guide.cuts) {
    if (!screen.faces(cut.from, cut.normal)) continue;
    if (const auto seen = screen.point(cut.from))
      if (!end || (upright ? seen->at.y < end->y : seen->at.x > end->x)) end = seen->at;
  }
  if (!end) return;
  Label label;
  label.text = guide.name;
  label.request.anchor = *end;
  label.request.away = upright ? Vec2(0.0, -1.0) : Vec2(1.0, 0.0);
  label.request.clearance = line(10.0);
  label.request.may_cover = true;
  label.importance = 5e4;
  label.tick = guide_colour;
  add_label(std::move(label));
}

void OverlayPainter::face_region(const FaceRegionOverlay& region) {
  std::vector<Contour> tint;
  for (const auto& [a, b, c] : region.area) {
    const auto p = screen.point(a), q = screen.point(b), r = screen.point(c);
    if (!p || !q || !r) continue;
    if (screen.faces(a, glm::cross(b - a, c - a))) tint.push_back({p->at, q->at, r->at});
  }
  canvas.fill(tint, faded(region.colour, 0.22));
  std::vector<SurfaceCut> front(region.outline.begin(), region.outline.end());
  std::erase_if(front, [&](const SurfaceCut& cut) { return !screen.faces(cut.from, cut.normal); });
  face_cuts(front, faded(region.colour, 0.9), line(1.3));
  for (const std::vector<Vec3>& limit : region.limits)
    polyline_3d(limit, {.colour = faded(region.colour, 0.95), .width = line(1.2), .dash = line(4.0), .gap = line(3.0)},
                true);
  for (const auto& [a, b] : region.hinges) {
    line_3d(a, b, {.colour = faded(region.colour, 0.6), .width = line(1.1), .dash = line(2.0), .gap = line(3.0)});
    for (const Vec3& p : {a, b})
      if (const auto seen = screen.point(p)) canvas.disc(seen->at, line(2.6), region.colour);
  }
  for (const Vec3& pivot : region.pivots)
    if (const auto seen = screen.point(pivot)) {
      canvas.disc(seen->at, line(4.0), palette::paper);
      canvas.disc(seen->at, line(2.8), region.colour);
    }
}

/// In a column on either side of the face, in the regions' order from the top down, each as near its region's height as
/// its neighbours leave room.
void OverlayPainter::face_region_labels(std::span<const FaceRegionOverlay> regions) {
  double left = canvas.width(), right = 0.0;
  for (const FaceRegionOverlay& region : regions)
    for (const SurfaceCut& cut : region.outline)
      if (const auto seen = screen.point(cut.from)) {
        left = std::min(left, seen->at.x);
        right = std::max(right, seen->at.x);
      }
  struct Side {
    std::vector<const FaceRegionOverlay*> regions;
    std::vector<Vec2> anchors;
  };
  std::array<Side, 2> sides;
  std::vector<std::pair<Vec2, const FaceRegionOverlay*>> all;
  for (const FaceRegionOverlay& region : regions)
    if (const auto anchor = screen.point(region.anchor)) all.push_back({anchor->at, &region});
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first.y < b.first.y; });
  const double middle = 0.5 * (left + right), narrow = 0.04 * (right - left);
  for (const auto& [anchor, region] : all) {
    // What lies in the middle goes where there is more room.
    const bool to_right =
        std::abs(anchor.x - middle) > narrow ? anchor.x > middle : sides[0].anchors.size() > sides[1].anchors.size();
    sides[to_right].anchors.push_back(anchor);
    sides[to_right].regions.push_back(region);
  }
  for (int i = 0; i < 2; ++i) {
    std::vector<double> heights;
    for (const Vec2& anchor : sides[i].anchors) heights.push_back(anchor.y);
    heights = spread_apart(heights, letters(34.0));
    for (std::size_t k = 0; k < heights.size(); ++k) {
      const Vec2 place(i == 0 ? left - line(40.0) : right + line(40.0), heights[k]);
      Label label;
      label.text = sides[i].regions[k]->name;
      label.request.anchor = sides[i].anchors[k];
      label.request.away = place - label.request.anchor;
      label.request.clearance = glm::length(label.request.away);
      label.request.dot = line(2.0);
      label.request.may_cover = true;
      label.importance = 4e4 - heights[k];
      label.tick = sides[i].regions[k]->colour;
      label.boxed = true;
      add_label(std::move(label));
    }
  }
}

void OverlayPainter::face(const FaceOverlay& face) {
  for (const FaceRegionOverlay& region : face.regions) face_region(region);
  face_region_labels(face.regions);
  for (const FaceGuideLine& guide : face.guides) face_guide(guide);
}

}  // namespace sinew
