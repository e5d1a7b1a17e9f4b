#include "engine/render/label_layout.h"

namespace sinew {
namespace {

/// Distances to try, in heights of a label beyond the clearance: beside the anchor, then ever farther off.
constexpr double distances[] = {0.0, 0.6, 1.4, 2.4, 3.6, 5.0};
constexpr int directions = 16;

/// Room between two labels, and between a label and the picture's edge.
constexpr double gap = 2.0, edge = 4.0;

/// A place to try: a distance from the list, and a turn in radians from the best direction.
struct Candidate {
  double distance = 0.0, turn = 0.0;

  /// Half a turn is as bad as three labels' heights.
  double cost() const { return distance + 3.0 * std::abs(turn) / std::numbers::pi; }
};

std::vector<Candidate> candidates() {
  std::vector<Candidate> all;
  for (const double distance : distances)
    for (int i = 0; i < directions; ++i)
      all.push_back({distance, (i % 2 == 1 ? 1 : -1) * ((i + 1) / 2) * 2.0 * std::numbers::pi / directions});
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.cost() < b.cost(); });
  return all;
}

/// The box of this size whose border is `distance` from the anchor in this direction.
Rect box_towards(const LabelRequest& request, const Vec2& direction, double distance) {
  const Vec2 half = 0.5 * request.size;
  const double reach =
      std::min(half.x / std::max(std::abs(direction.x), 1e-9), half.y / std::max(std::abs(direction.y), 1e-9));
  const Vec2 centre = request.anchor + (distance + reach) * direction;
  return {glm::floor(centre - half + 0.5), glm::floor(centre - half + 0.5) + request.size};
}

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
}

}  // namespace

bool meets(const Vec2& from, const Vec2& to, const Rect& box) {
  double enter = 0.0, leave = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = to[axis] - from[axis], low = box.low[axis] - from[axis], high = box.high[axis] - from[axis];
    if (step == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    enter = std::max(enter, std::min(low / step, high / step));
    leave = std::min(leave, std::max(low / step, high / step));
  }
  return enter <= leave;
}

std::vector<double> spread_apart(std::span<const double> wanted, double gap) {
  struct Pool {
    double sum = 0.0;
    std::size_t count = 0;
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    // Without the gaps, neighbours must not fall.
    pools.push_back({wanted[i] - gap * static_cast<double>(i), 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().sum += last.sum;
      pools.back().count += last.count;
    }
  }
  std::vector<double> spread;
  for (const Pool& pool : pools)
    for (std::size_t k = 0; k < pool.count; ++k)
      spread.push_back(pool.mean() + gap * static_cast<double>(spread.size()));
  return spread;
}

LabelLayout::LabelLayout(int width, int height) : picture_{Vec2(edge), Vec2(width, height) - edge} {}

bool LabelLayout::is_free(const PlacedLabel& label, bool over_lines) const {
  if (!picture_.contains(label.box)) return false;
  const Rect room = label.box.grown(gap);
  const auto overlaps = [&](const Rect& other) { return room.overlaps(other); };
  const auto under = [&](const Line& line) { return meets(line.from, line.to, label.box); };
  if (std::any_of(labels_.begin(), labels_.end(), overlaps) || std::any_of(boxes_.begin(), boxes_.end(), overlaps))
    return false;
  if (std::any_of(leaders_.begin(), leaders_.end(), under)) return false;
  if (!over_lines && std::any_of(lines_.begin(), lines_.end(), under)) return false;
  if (!label.leader) return true;
  for (const Rect& other : labels_)
    if (meets(label.leader_from, label.leader_to, other)) return false;
  for (const Line& other : leaders_)
    if (segments_cross(label.leader_from, label.leader_to, other.from, other.to)) return false;
  return true;
}

std::optional<PlacedLabel> LabelLayout::place(const LabelRequest& request) {
  const double length = glm::length(request.away);
  const Vec2 best = length > 1e-9 ? request.away / length : Vec2(1.0, 0.0);
  const bool far = request.clearance > 1.5 * request.size.y;
  static const std::vector<Candidate> all = candidates();
  for (const bool over_lines : {false, true}) {
    if (over_lines && !request.may_cover) break;
    for (const Candidate& candidate : all) {
      const double cosine = std::cos(candidate.turn), sine = std::sin(candidate.turn);
      const Vec2 direction(best.x * cosine - best.y * sine, best.x * sine + best.y * cosine);
      const double distance = request.clearance + candidate.distance * request.size.y;
      PlacedLabel label{box_towards(request, direction, distance), candidate.distance > 0.7 || far, {}, {}};
      if (label.leader) {
        label.leader_to = glm::clamp(request.anchor, label.box.low, label.box.high);
        const Vec2 along = label.leader_to - request.anchor;
        label.leader_from = request.anchor + std::min(request.dot / glm::length(along), 1.0) * along;
      }
      if (!is_free(label, over_lines)) continue;
      labels_.push_back(label.box);
      if (label.leader) leaders_.push_back({label.leader_from, label.leader_to});
      return label;
    }
  }
  return {};
}

}  // namespace sinew
