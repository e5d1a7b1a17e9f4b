#include "engine/render/overlay.h"

#include "engine/render/overlay_painter.h"

namespace sinew {
namespace {

/// An edge of a box along an axis; the other two coordinates are low or high.
struct BoxEdge {
  Vec3 from{0.0}, to{0.0};
  int visible_faces = 0;  ///< of the two that meet in it
};

BoxEdge box_edge(const Bounds& box, const Screen& screen, int axis, bool first_high, bool second_high) {
  const int first = (axis + 1) % 3, second = (axis + 2) % 3;
  BoxEdge edge;
  edge.from[axis] = box.low[axis];
  edge.to[axis] = box.high[axis];
  for (const auto& [other, high] : {std::pair(first, first_high), std::pair(second, second_high)}) {
    edge.from[other] = edge.to[other] = high ? box.high[other] : box.low[other];
    Vec3 normal(0.0);
    normal[other] = high ? 1.0 : -1.0;
    if (screen.faces(edge.from, normal)) ++edge.visible_faces;
  }
  return edge;
}

}  // namespace

void OverlayPainter::box(const Bounds& box) {
  if (box.empty()) return;
  for (int axis = 0; axis < 3; ++axis) {
    // The size stands at the outline's edge that is farthest down, or to the left for upright ones: under and beside
    // what the box holds.
    Vec2 labelled(0.0);
    double best = -INFINITY;
    for (int corner = 0; corner < 4; ++corner) {
      const BoxEdge edge = box_edge(box, screen, axis, corner & 1, corner & 2);
      const auto seen = screen.segment(edge.from, edge.to);
      if (!seen) continue;
      const bool hidden = edge.visible_faces == 0;
      canvas.line(seen->first.at, seen->second.at,
                  {.colour = faded(palette::box, hidden ? 0.5 : 0.95),
                   .width = line(hidden ? 1.1 : 1.7),
                   .cap = Cap::round,
                   .dash = hidden ? line(5.0) : 0.0,
                   .gap = hidden ? line(4.0) : 0.0});
      layout.avoid(seen->first.at, seen->second.at);
      const Vec2 at = 0.5 * (seen->first.at + seen->second.at);
      const double rank = (axis == 1 ? -at.x : at.y) - (edge.visible_faces == 1 ? 0.0 : 1e6);
      if (rank > best) {
        best = rank;
        labelled = at;
      }
    }
    if (std::isinf(best)) continue;
    Label label;
    label.text = fmt::format("{} {:.3g}", "xyz"[axis], box.high[axis] - box.low[axis]);
    label.request.anchor = labelled;
    label.request.away = axis == 1 ? Vec2(-1.0, 0.0) : Vec2(0.0, 1.0);
    label.request.clearance = line(5.0);
    label.request.may_cover = true;
    label.importance = 2e5;
    label.tick = palette::box;
    add_label(std::move(label));
  }
}

void OverlayPainter::axes() {
  // Above the corner's lowest strip, where a sheet puts the picture's label.
  const double length = line(34.0);
  const Vec2 origin(line(30.0) + length, canvas.height() - line(56.0) - length);
  layout.avoid(Rect{origin, origin}.grown(length + letters(18.0)));
  const bool dark = dark_under(Rect{origin, origin}.grown(length));
  struct Axis {
    int index = 0;
    Vec2 tip{0.0};
    double towards = 0.0;  ///< the viewer
  };
  std::array<Axis, 3> axes;
  for (int i = 0; i < 3; ++i)
    axes[i] = {i, origin + length * Vec2(viewpoint.right[i], -viewpoint.up[i]), viewpoint.back[i]};
  std::stable_sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.towards < b.towards; });
  canvas.disc(origin, line(3.0), palette::ink);
  for (const Axis& axis : axes) {
    const Colour& colour = palette::axes[axis.index];
    const double seen = glm::distance(origin, axis.tip) / length;
    const bool end_on = seen < 0.2;
    if (end_on) {
      // Seen from the tip: a dot in a ring, as in drawings of fields; from behind: a ring alone.
      canvas.disc(origin, line(6.0), faded(palette::paper, 0.9));
      canvas.circle(origin, line(6.0), {.colour = colour, .width = line(2.0)});
      if (axis.towards > 0.0) canvas.disc(origin, line(2.4), colour);
    } else {
      canvas.arrow(origin, axis.tip, {.colour = colour, .width = line(2.2), .cap = Cap::round}, line(9.0));
    }
    if (font_ == nullptr) continue;
    const Vec2 beyond = end_on ? Vec2(-0.7, 0.7) : (axis.tip - origin) / (seen * length);
    TextStyle style;
    style.size = letters(13.5);
    style.colour = colour;
    style.align_x = AlignX::centre;
    style.align_y = AlignY::middle;
    style.halo = faded(dark ? palette::ink : palette::paper, 0.75);
    style.halo_width = letters(1.6);
    draw_text(canvas, *font_, std::string_view("XYZ").substr(axis.index, 1),
              (end_on ? origin : axis.tip) + letters(end_on ? 18.0 : 10.0) * beyond, style);
  }
}

Result<void> draw_overlay(Picture& picture, const Font* font, const Viewpoint& viewpoint,
                          const OverlayContent& content) {
  for (const SkeletonOverlay& skeleton : content.skeletons)
    if (auto ok = skeleton.validate(); !ok) return ok;
  if (picture.width <= 0 || picture.height <= 0) return {};
  OverlayPainter painter(picture, font, viewpoint);
  if (content.box) painter.box(*content.box);
  for (const SkeletonOverlay& skeleton : content.skeletons) painter.skeleton(skeleton);
  for (const MuscleOverlay& muscle : content.muscles) painter.muscle(muscle);
  for (const FaceOverlay& face : content.faces) painter.face(face);
  if (content.axes) painter.axes();
  painter.draw_labels();
  return {};
}

}  // namespace sinew
