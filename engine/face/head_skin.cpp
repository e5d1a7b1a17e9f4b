#include "engine/face/head_skin.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "engine/core/parallel.h"
#include "engine/face/quad_mesh_check.h"

namespace sinew {
namespace {

/// Of one damped step towards the points for all of the cage, and of five more for features.
constexpr double first_step = 0.6, feature_step = 0.9;
constexpr int feature_steps = 5;

/// How closely the skin follows a point of the cage, 0 to 1.
double feature_share(const CagePoint& name) {
  switch (name.part) {
    case HeadPart::eye: {
      constexpr double share[] = {1.0, 1.0, 1.0, 1.0, 0.9, 0.2, 0.0};
      return share[name.ring];
    }
    case HeadPart::mouth: {
      constexpr double share[] = {0.0, 0.5, 0.8, 0.8, 0.8, 0.3, 0.0};
      return share[name.ring];
    }
    case HeadPart::nose: {
      constexpr double share[] = {0.4, 0.3, 0.3, 0.0};
      return share[name.ring];
    }
    case HeadPart::ear:
      return name.ring == 2 || name.ring == 3 ? 0.3 : 0.0;
    default:
      return 0.0;
  }
}

Vec3 mirrored(const Vec3& p) { return {-p.x, p.y, p.z}; }

/// Quads wound alike, outside out.
std::vector<Quad> wound(const std::vector<Quad>& quads, const std::vector<Vec3>& positions) {
  Polygons polygons;
  for (const Quad& q : quads) polygons.emplace_back(q.begin(), q.end());
  wind_alike(polygons);
  double volume = 0.0;
  for (const auto& p : polygons)
    for (std::size_t i = 1; i < 3; ++i)
      volume += glm::dot(positions[p[0]], glm::cross(positions[p[i]], positions[p[i + 1]]));
  std::vector<Quad> out;
  for (const auto& p : polygons)
    out.push_back(volume > 0 ? Quad{p[0], p[1], p[2], p[3]} : Quad{p[3], p[2], p[1], p[0]});
  return out;
}

/// For each vertex the one at its mirrored place.
std::vector<std::uint32_t> mirror_of(const std::vector<Vec3>& positions) {
  constexpr double same = 1e-9;
  std::vector<std::uint32_t> by_height(positions.size()), out(positions.size());
  std::iota(by_height.begin(), by_height.end(), 0u);
  std::ranges::sort(by_height, {}, [&](std::uint32_t v) { return positions[v].y; });
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    const Vec3 wanted = mirrored(positions[v]);
    auto at = std::ranges::lower_bound(by_height, wanted.y - same, {}, [&](std::uint32_t u) { return positions[u].y; });
    while (at != by_height.end() && glm::distance(positions[*at], wanted) > same) ++at;
    assert(at != by_height.end());
    out[v] = *at;
  }
  return out;
}

}  // namespace

HeadTopology::HeadTopology(int level) : cage_(build_head_cage(HeadPlan(measures_of_age(0.0)))) {
  const std::size_t half = cage_.positions.size();
  whole_cage_ = half;
  for (const Vec3& p : cage_.positions)
    cage_mirror_.push_back(p.x == 0.0 ? static_cast<std::uint32_t>(cage_mirror_.size())
                                      : static_cast<std::uint32_t>(whole_cage_++));
  const std::vector<Vec3> positions = whole(cage_.positions);
  std::vector<Quad> coarse;
  for (const CageQuad& quad : cage_.quads) coarse.push_back(quad.corners);
  for (const CageQuad& quad : cage_.quads) {
    const auto& [a, b, c, d] = quad.corners;
    coarse.push_back({cage_mirror_[d], cage_mirror_[c], cage_mirror_[b], cage_mirror_[a]});
  }
  coarse = wound(coarse, positions);
  coarse_limit_ = subdivide(whole_cage_, coarse, 0).limit;

  const Subdivision fine = subdivide(whole_cage_, coarse, level);
  std::vector<Vec3> places;
  for (std::size_t v = 0; v < fine.limit.rows(); ++v) places.push_back(fine.limit.times<Vec3>(v, positions));
  const std::vector<std::uint32_t> partner = mirror_of(places);
  // New numbers: the left half and the mid line, then the right half in the left's order.
  std::vector<std::uint32_t> number(places.size()), kept;
  for (std::uint32_t v = 0; v < places.size(); ++v)
    if (partner[v] == v || places[v].x > 0.0) kept.push_back(v);
  auto next = static_cast<std::uint32_t>(kept.size());
  mirror_.resize(places.size());
  for (std::uint32_t i = 0; i < kept.size(); ++i) {
    const std::uint32_t v = kept[i];
    number[v] = i;
    if (partner[v] != v) number[partner[v]] = next++;
    mirror_[number[v]] = number[partner[v]];
    mirror_[number[partner[v]]] = number[v];
    const auto row = fine.limit.row(v);
    half_.entries.insert(half_.entries.end(), row.begin(), row.end());
    half_.first.push_back(static_cast<std::uint32_t>(half_.entries.size()));
  }
  for (std::size_t q = 0; q < fine.quads.size(); ++q) {
    Quad renamed = fine.quads[q];
    for (std::uint32_t& corner : renamed) corner = number[corner];
    quads_.push_back(renamed);
    kinds_.push_back(cage_.quads[fine.from[q] % cage_.quads.size()].kind);
  }
  // OpenSubdiv's fine vertices end with those that stem from coarse ones, level by level.
  for (std::size_t v = 0; v < half; ++v) {
    const Vec3 limit = coarse_limit_.times<Vec3>(v, positions);
    const auto nearest = std::ranges::min_element(places, {}, [&](const Vec3& p) { return glm::distance(p, limit); });
    of_cage_.push_back(number[static_cast<std::size_t>(nearest - places.begin())]);
  }
}

std::vector<Vec3> HeadTopology::whole(const std::vector<Vec3>& half_cage) const {
  std::vector<Vec3> out(whole_cage_);
  for (std::size_t v = 0; v < half_cage.size(); ++v) {
    out[cage_mirror_[v]] = mirrored(half_cage[v]);
    out[v] = half_cage[v];
  }
  return out;
}

std::vector<Vec3> HeadTopology::positions(const std::vector<Vec3>& half_cage) const {
  const std::vector<Vec3> coarse = whole(half_cage);
  std::vector<Vec3> out(vertices());
  parallel_for(half_vertices(), [&](std::size_t v) {
    Vec3 p = half_.times<Vec3>(v, coarse);
    if (on_mid_line(v)) p.x = 0.0;
    out[mirror_[v]] = mirrored(p);
    out[v] = p;
  });
  return out;
}

std::vector<double> HeadTopology::values(const std::vector<double>& whole_cage) const {
  std::vector<double> swapped(whole_cage_), out(vertices());
  for (std::size_t v = 0; v < cage_mirror_.size(); ++v) {
    swapped[v] = whole_cage[cage_mirror_[v]];
    swapped[cage_mirror_[v]] = whole_cage[v];
  }
  for (std::size_t v = 0; v < half_vertices(); ++v) {
    out[mirror_[v]] = half_.times<double>(v, swapped);
    out[v] = half_.times<double>(v, whole_cage);
  }
  return out;
}

std::vector<double> HeadTopology::left_values(const CageValues& half_cage) const {
  std::vector<double> coarse(whole_cage_, 0.0);
  std::ranges::copy(half_cage, coarse.begin());
  return values(coarse);
}

std::vector<double> HeadTopology::even_values(const CageValues& half_cage) const {
  std::vector<double> coarse(whole_cage_, 0.0);
  for (std::size_t v = 0; v < half_cage.size(); ++v) coarse[v] = coarse[cage_mirror_[v]] = half_cage[v];
  return values(coarse);
}

std::vector<Vec3> HeadTopology::fitted(const std::vector<Vec3>& half_cage) const {
  std::vector<Vec3> moved = half_cage;
  const auto step = [&](const auto& share) {
    const std::vector<Vec3> coarse = whole(moved);
    for (std::size_t v = 0; v < moved.size(); ++v) {
      const double s = share(v);
      if (s == 0.0) continue;
      moved[v] += s * (half_cage[v] - coarse_limit_.times<Vec3>(v, coarse));
      if (half_cage[v].x == 0.0) moved[v].x = 0.0;
    }
  };
  step([](std::size_t) { return first_step; });
  for (int i = 0; i < feature_steps; ++i)
    step([&](std::size_t v) { return feature_step * feature_share(cage_.names[v]); });
  return moved;
}

}  // namespace sinew
