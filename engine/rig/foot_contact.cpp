#include "engine/rig/foot_contact.h"

#include <algorithm>
#include <set>

#include "engine/rig/joint_tree.h"

namespace sinew {
namespace {

using enum HumanoidBone;

/// Vertices this near to the foot's lowest, in heights of the body, are its sole.
constexpr double sole_thickness = 0.012;
constexpr std::size_t most_points = 160;

struct RestPoint {
  Vec3 place;
  std::vector<std::pair<int, Vec4>> follows;
};

}  // namespace

FootContact::FootContact(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global) {
  const JointTree tree(model, rest_global);
  std::set<int> feet;
  for (const HumanoidBone bone : {left_foot, right_foot})
    if (const int foot = humanoid.find(bone); foot >= 0)
      for (int node = 0; node < tree.size(); ++node)
        if (node == foot || tree.is_below(node, foot)) feet.insert(node);

  std::vector<RestPoint> candidates;
  Bounds bounds;
  for (const Node& node : model.nodes) {
    if (node.mesh < 0 || node.skin < 0) continue;
    const Skin& skin = model.skins[static_cast<std::size_t>(node.skin)];
    for (const Primitive& primitive : model.meshes[static_cast<std::size_t>(node.mesh)].primitives)
      for (std::size_t v = 0; v < primitive.influences.vertices(); ++v) {
        RestPoint point{Vec3(0.0), {}};
        double on_feet = 0.0;
        for (auto i = primitive.influences.first[v]; i < primitive.influences.first[v + 1]; ++i) {
          const Influence& influence = primitive.influences.entries[i];
          const int joint = skin.joints[influence.joint];
          const Vec4 local = skin.inverse_bind[influence.joint] * Vec4(primitive.positions[v], 1.0) * influence.weight;
          point.place += Vec3(rest_global[static_cast<std::size_t>(joint)] * local);
          point.follows.emplace_back(joint, local);
          if (feet.contains(joint)) on_feet += influence.weight;
        }
        if (point.follows.empty()) continue;
        bounds.add(point.place);
        if (on_feet > 0.5) candidates.push_back(std::move(point));
      }
  }
  if (candidates.empty()) {
    for (const int node : feet) {
      points_.push_back({{node, Vec4(0, 0, 0, 1)}});
      bounds.add(tree.position(node));
    }
    floor_ = bounds.empty() ? 0.0 : bounds.low.y;
    return;
  }
  floor_ = bounds.low.y;
  const double limit = sole_thickness * (bounds.high.y - bounds.low.y);
  double lowest = INFINITY;
  for (const RestPoint& point : candidates) lowest = std::min(lowest, point.place.y);
  // Toes curl up a little and heels round: the sole's edge counts, thinned out evenly.
  std::erase_if(candidates, [&](const RestPoint& point) { return point.place.y > lowest + limit; });
  const std::size_t step = candidates.size() / most_points + 1;
  for (std::size_t i = 0; i < candidates.size(); i += step) {
    Point& point = points_.emplace_back();
    for (const auto& [node, row] : candidates[i].follows) point.push_back({node, row});
  }
}

double FootContact::height(std::span<const Mat4> global) const {
  double lowest = INFINITY;
  for (const Point& point : points_) {
    double y = 0.0;
    for (const Follow& follow : point) {
      const Mat4& m = global[static_cast<std::size_t>(follow.node)];
      y += m[0].y * follow.row.x + m[1].y * follow.row.y + m[2].y * follow.row.z + m[3].y * follow.row.w;
    }
    lowest = std::min(lowest, y);
  }
  return points_.empty() ? 0.0 : lowest - floor_;
}

std::vector<double> smooth_lift(std::span<const double> heights, std::size_t reach) {
  const std::size_t n = heights.size();
  // The largest need within reach, then its mean within reach: nowhere less than the need itself.
  std::vector<double> largest(n, 0.0), lift(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i - std::min(i, reach); k <= std::min(n - 1, i + reach); ++k)
      largest[i] = std::max(largest[i], -heights[k]);
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k <= 2 * reach; ++k) {
      const std::size_t at = std::min(i + k < reach ? 0 : i + k - reach, n - 1);
      sum += largest[at];
    }
    lift[i] = sum / static_cast<double>(2 * reach + 1);
  }
  return lift;
}

}  // namespace sinew
