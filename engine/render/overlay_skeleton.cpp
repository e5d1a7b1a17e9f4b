#include <algorithm>

#include "engine/render/overlay_painter.h"

namespace sinew {
namespace {

/// Bones and joints at the back are drawn with this part of their opacity.
constexpr double faintest = 0.6;

struct Bone {
  int from = -1, to = -1;  ///< nodes
  ScreenPoint head, tail;
};

Vec3 place_of(const SkeletonOverlay& skeleton, int node) { return Vec3(skeleton.global[node][3]); }

int joint_above(const SkeletonOverlay& skeleton, int node) {
  int above = skeleton.parents[node];
  while (above >= 0 && !skeleton.joints[above]) above = skeleton.parents[above];
  return above;
}

/// What is known of a joint on the screen.
struct Joint {
  int node = -1;
  ScreenPoint at;
  bool root = true, end = true;
  double shortest = INFINITY, longest = 0.0;  ///< bones at it, pixels
};

/// 1 at the front, `faintest` at the back of a depth range; a flat skeleton is not faded by its few millimetres.
class DepthFade {
 public:
  void add(double depth) {
    near_ = std::min(near_, depth);
    far_ = std::max(far_, depth);
  }
  double at(double depth) const {
    const double range = std::max(far_ - near_, 0.12 * far_);
    return range > 0.0 ? 1.0 - (1.0 - faintest) * std::clamp((depth - near_) / range, 0.0, 1.0) : 1.0;
  }

 private:
  double near_ = INFINITY, far_ = 0.0;
};

class SkeletonDrawing {
 public:
  SkeletonDrawing(OverlayPainter& painter, const SkeletonOverlay& skeleton) : painter_(painter), skeleton_(skeleton) {
    index_.assign(skeleton.global.size(), -1);
    for (int node = 0; node < int(skeleton.global.size()); ++node) add_joint(node);
    for (const Joint& joint : joints_) add_bone(joint.node);
    std::stable_sort(bones_.begin(), bones_.end(), [](const Bone& a, const Bone& b) {
      return a.head.depth + a.tail.depth > b.head.depth + b.tail.depth;
    });
  }

  void draw() {
    for (const Bone& bone : bones_) draw_bone(bone);
    std::vector<const Joint*> by_depth;
    for (const Joint& joint : joints_) by_depth.push_back(&joint);
    // Roots last: exporters put other joints on the same spot.
    std::stable_sort(by_depth.begin(), by_depth.end(), [](const Joint* a, const Joint* b) {
      return a->root != b->root ? b->root : a->at.depth > b->at.depth;
    });
    for (const Joint* joint : by_depth) draw_joint(*joint);
    if (!skeleton_.names.empty()) add_names();
  }

 private:
  void add_joint(int node) {
    if (!skeleton_.joints[node]) return;
    const auto seen = painter_.screen.point(place_of(skeleton_, node));
    if (!seen) return;
    index_[node] = int(joints_.size());
    Joint joint;
    joint.node = node;
    joint.at = *seen;
    joint.root = joint_above(skeleton_, node) < 0;
    joints_.push_back(joint);
    fade_.add(seen->depth);
  }

  void add_bone(int node) {
    const int above = joint_above(skeleton_, node);
    if (above < 0) return;
    const auto seen = painter_.screen.segment(place_of(skeleton_, above), place_of(skeleton_, node));
    if (!seen) return;
    bones_.push_back({above, node, seen->first, seen->second});
    const double length = glm::distance(seen->first.at, seen->second.at);
    for (const int end : {above, node}) {
      if (index_[end] < 0) continue;
      Joint& joint = joints_[index_[end]];
      // Joints on one spot (a twist joint at its bone's) say nothing about the room that there is.
      if (length > 1.0) joint.shortest = std::min(joint.shortest, length);
      joint.longest = std::max(joint.longest, length);
      if (end == above) joint.end = false;
    }
  }

  void draw_bone(const Bone& bone) {
    const double opacity = fade_.at(0.5 * (bone.head.depth + bone.tail.depth));
    const Vec2 along = bone.tail.at - bone.head.at;
    const double length = glm::length(along);
    if (!(length > 0.5)) return;
    const Colour outline = faded(palette::ink, 0.9 * opacity), fill = faded(palette::bone, 0.92 * opacity);
    if (skeleton_.shape == BoneShape::line || length < painter_.line(7.0)) {
      painter_.canvas.line(bone.head.at, bone.tail.at,
                           {.colour = outline, .width = painter_.line(3.4), .cap = Cap::round});
      painter_.canvas.line(bone.head.at, bone.tail.at,
                           {.colour = fill, .width = painter_.line(1.6), .cap = Cap::round});
      return;
    }
    const Vec2 side = Vec2(-along.y, along.x) / length;
    const double half = std::clamp(0.075 * length, painter_.line(2.0), painter_.line(5.5));
    const Vec2 widest = bone.head.at + std::min(0.2 * length, painter_.line(16.0)) * along / length;
    const Contour diamond{bone.head.at, widest + half * side, bone.tail.at, widest - half * side};
    painter_.canvas.polygon(diamond, fill);
    painter_.canvas.polyline(diamond, {.colour = outline, .width = painter_.line(1.4)}, true);
  }

  double radius(const Joint& joint) const {
    const double room = std::isfinite(joint.shortest) ? 0.17 * joint.shortest : INFINITY;
    return std::clamp(room, painter_.line(1.4), painter_.line(joint.root ? 5.0 : 3.4));
  }

  void draw_joint(const Joint& joint) {
    const double opacity = fade_.at(joint.at.depth), r = radius(joint);
    Canvas& canvas = painter_.canvas;
    canvas.disc(joint.at.at, r, faded(joint.root ? palette::root : palette::joint, opacity));
    canvas.circle(joint.at.at, r + painter_.line(0.4),
                  {.colour = faded(palette::ink, 0.9 * opacity), .width = painter_.line(1.2)});
    // An end joint is a ring, the root a target: both are told from the rest without colour.
    if (joint.end && !joint.root) canvas.disc(joint.at.at, 0.5 * r, faded(palette::paper, opacity));
    if (joint.root && r > painter_.line(3.0)) canvas.disc(joint.at.at, 0.4 * r, palette::paper);
  }

  void add_names() {
    Vec2 middle(0.0);
    for (const Joint& joint : joints_) middle += joint.at.at / double(joints_.size());
    for (const Joint& joint : joints_) {
      const double r = radius(joint) + painter_.line(1.0);
      painter_.layout.avoid(Rect{joint.at.at, joint.at.at}.grown(r));
    }
    for (const Bone& bone : bones_) painter_.layout.avoid(bone.head.at, bone.tail.at);
    for (const Joint& joint : joints_) {
      Label label;
      label.text = shortened(skeleton_.names[joint.node]);
      label.request.anchor = joint.at.at;
      // Names stand outwards and, being wide, rather beside their joints than over or under them.
      const Vec2 outwards = joint.at.at - middle;
      label.request.away = Vec2(outwards.x < 0.0 ? -1.0 : 1.0, std::clamp(0.002 * outwards.y, -0.4, 0.4));
      label.request.dot = radius(joint) + painter_.line(1.0);
      label.request.clearance = label.request.dot + painter_.line(3.0);
      label.importance = joint.longest + (joint.root ? 1e4 : 0.0);
      label.tick = faded(palette::joint, 0.0);
      painter_.add_label(std::move(label));
    }
  }

  /// Exporters put paths and name spaces before a joint's name; its end is what tells it from others.
  static std::string shortened(const std::string& name) {
    constexpr std::size_t longest = 28;
    if (name.size() <= longest) return name;
    std::size_t cut = name.size() - longest;
    while (cut < name.size() && (static_cast<unsigned char>(name[cut]) & 0xC0) == 0x80) ++cut;
    return "\u2026" + name.substr(cut);
  }

  OverlayPainter& painter_;
  const SkeletonOverlay& skeleton_;
  std::vector<int> index_;  ///< [nodes] into joints_, -1: not seen
  std::vector<Joint> joints_;
  std::vector<Bone> bones_;
  DepthFade fade_;
};

}  // namespace

Result<void> SkeletonOverlay::validate() const {
  const std::size_t nodes = global.size();
  if (parents.size() != nodes || joints.size() != nodes || (!names.empty() && names.size() != nodes))
    return bad_input("skeleton overlay: {} transforms, {} parents, {} joint marks, {} names; expected as many of each",
                     nodes, parents.size(), joints.size(), names.size());
  for (std::size_t node = 0; node < nodes; ++node) {
    std::size_t steps = 0;
    for (int above = int(node); above >= 0; above = parents[above], ++steps) {
      if (above >= int(nodes))
        return bad_input("skeleton overlay: node {} hangs from node {} of {}", node, above, nodes);
      if (steps > nodes) return bad_input("skeleton overlay: node {} hangs from itself", node);
    }
  }
  return {};
}

void OverlayPainter::skeleton(const SkeletonOverlay& skeleton) { SkeletonDrawing(*this, skeleton).draw(); }

}  // namespace sinew
