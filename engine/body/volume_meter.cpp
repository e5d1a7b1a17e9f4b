#include "engine/body/volume_meter.h"

#include <array>
#include <map>
#include <numeric>
#include <optional>

namespace sinew {
namespace {

/// An end moves inwards by one part of so many.
constexpr double steps = 100.0;

/// Sets of triangles that are joined one by one.
class Joined {
 public:
  explicit Joined(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

/// The part of space between two planes across a limb; heights are above the lower one.
struct Slab {
  Vec3 low, axis;
  double thickness;

  double height(const Vec3& p) const { return glm::dot(p - low, axis); }
  bool holds_part_of(double a, double b) const { return std::max(a, b) > 0.0 && std::min(a, b) < thickness; }
};

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The triangles that hang together with one of them inside the slab, and how many edges there have no neighbour.
struct Part {
  std::vector<std::uint32_t> triangles;
  std::size_t open_edges = 0;
};

Part part_of(const PosedSurface& surface, const Slab& slab, std::uint32_t seed) {
  const std::size_t count = surface.triangles.size() / 3;
  Joined joined(count);
  struct Use {
    std::uint32_t first, times;
  };
  std::map<Edge, Use> edges;
  std::vector<bool> inside(count);
  for (std::uint32_t t = 0; t < count; ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::uint32_t a = surface.triangles[3 * t + corner], b = surface.triangles[3 * t + (corner + 1) % 3];
      const double ha = slab.height(surface.positions[a]), hb = slab.height(surface.positions[b]);
      if (a == b || !slab.holds_part_of(ha, hb)) continue;
      inside[t] = true;
      if (a > b) std::swap(a, b);
      const auto [found, is_new] = edges.try_emplace({a, b}, Use{t, 0});
      ++found->second.times;
      if (!is_new) joined.join(t, found->second.first);
    }
  Part part;
  for (std::uint32_t t = 0; t < count; ++t)
    if (inside[t] && joined.find(t) == joined.find(seed)) part.triangles.push_back(t);
  for (const auto& [edge, use] : edges)
    if (use.times == 1 && joined.find(use.first) == joined.find(seed)) ++part.open_edges;
  return part;
}

/// The polygon's part on the side of the plane where `keep` times (height - level) is not negative.
std::vector<Vec3> clipped(const Slab& slab, const std::vector<Vec3>& polygon, double level, double keep) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = keep * (slab.height(a) - level), db = keep * (slab.height(b) - level);
    if (da >= 0.0) kept.push_back(a);
    if ((da < 0.0) != (db < 0.0)) kept.push_back(glm::mix(a, b, da / (da - db)));
  }
  return kept;
}

/// By the divergence theorem about a point of the lower plane, to which that plane's own face adds nothing. What the
/// upper face adds is its area times a third of the thickness; the area is that of the section's outline, gathered from
/// the triangles' edges in the plane.
double volume_of(const PosedSurface& surface, const Slab& slab, const Part& part) {
  double volume = 0.0, upper_area = 0.0;
  const Vec3 top = slab.low + slab.thickness * slab.axis;
  for (const std::uint32_t t : part.triangles) {
    std::vector<Vec3> polygon;
    for (std::size_t corner = 0; corner < 3; ++corner)
      polygon.push_back(surface.positions[surface.triangles[3 * t + corner]]);
    polygon = clipped(slab, clipped(slab, polygon, 0.0, 1.0), slab.thickness, -1.0);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 a = polygon[i] - slab.low, b = polygon[(i + 1) % polygon.size()] - slab.low;
      if (i > 0) volume += glm::dot(polygon[0] - slab.low, glm::cross(a, b)) / 6.0;
      const double reach = 1e-12 * slab.thickness;
      if (std::abs(glm::dot(a, slab.axis) - slab.thickness) > reach ||
          std::abs(glm::dot(b, slab.axis) - slab.thickness) > reach)
        continue;
      // The face's outline runs against the triangle's edge.
      upper_area += 0.5 * glm::dot(slab.axis, glm::cross(b + slab.low - top, a + slab.low - top));
    }
  }
  return std::abs(volume + upper_area * slab.thickness / 3.0);
}

/// The nearest share from `at` towards the middle where a section is the limb's alone.
Result<double> own_end(const PosedSurface& surface, int joint, int child, double at, double middle) {
  for (int moved = 0;; ++moved) {
    const double share = at + (at < middle ? moved : -moved) / steps;
    const bool last = std::abs(share - middle) < 1.0 / steps;
    auto section = limb_section(surface, joint, child, share);
    if (section) return share;
    if (last) return pass_on(std::move(section));
  }
}

}  // namespace

Result<SegmentVolume> segment_volume(const PosedSurface& surface, int joint, int child, double from, double to) {
  if (!(from < to)) return bad_input("a volume from {} to {}: from must be less than to", from, to);
  const double middle = 0.5 * (from + to);
  const auto seed = limb_section(surface, joint, child, middle);
  if (!seed) return tl::unexpected<Error>(seed.error());
  const auto low = own_end(surface, joint, child, from, middle), high = own_end(surface, joint, child, to, middle);
  if (!low) return tl::unexpected<Error>(low.error());
  if (!high) return tl::unexpected<Error>(high.error());
  const Vec3 begin(surface.global[joint][3]), end(surface.global[child][3]);
  const Slab slab{glm::mix(begin, end, *low), seed->axis, (*high - *low) * glm::distance(begin, end)};
  const Part part = part_of(surface, slab, seed->triangle);
  return SegmentVolume{*low, *high, volume_of(surface, slab, part), part.open_edges};
}

}  // namespace sinew
