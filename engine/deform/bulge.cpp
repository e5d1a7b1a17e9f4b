#include "engine/deform/bulge.h"

#include <map>

namespace sinew {
namespace {

/// Height of one muscle over one vertex, and how it changes over the rest surface.
struct Swelling {
  double height = 0.0;
  Vec3 gradient{0.0};  ///< rest space
};

Swelling swelling(const ActiveMuscle& active, const RegionVertex& v, BulgeMode mode) {
  const Muscle& m = active.muscle;
  const ProjectionPlane& plane = active.region.plane;
  const double amplitude = active.activation * m.peak;
  const double u = v.x / m.sigma.x, w = v.y / m.sigma.y;
  const double g = std::exp(-0.5 * (u * u + w * w));
  const RegionFade fade = mode == BulgeMode::paper ? RegionFade{} : region_fade(m, v);
  const double along = -v.x / (m.sigma.x * m.sigma.x) * g * fade.value + g * fade.slope / plane.length;
  const double across = -v.y / (m.sigma.y * m.sigma.y) * g * fade.value;
  return {amplitude * g * fade.value, amplitude * (along * plane.axis + across * plane.side)};
}

/// Two directions with t1 x t2 = n.
std::pair<Vec3, Vec3> spanning_tangents(const Vec3& n) {
  const Vec3 helper = std::abs(n.x) < 0.5 * glm::length(n) ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 t1 = glm::normalize(glm::cross(helper, n));
  return {t1, glm::cross(n, t1)};
}

}  // namespace

Result<void> BulgeJob::validate() const {
  const std::size_t vertices = positions.size();
  const std::pair<const char*, std::size_t> spans[] = {{"bind normals", bind_normals.size()},
                                                       {"rest blend", rest_blend.size()},
                                                       {"blend", blend.size()},
                                                       {"normals", normals.size()},
                                                       {"heights", heights.size()}};
  for (const auto& [what, size] : spans)
    if (size != vertices)
      return bad_input("bulge: {} has {} entries, expected {} (one a vertex)", what, size, vertices);
  if (!bind_tangents.empty() && (bind_tangents.size() != vertices || tangents.size() != vertices))
    return bad_input("bulge: tangents have {} and {} entries, expected {} (one a vertex) or none", bind_tangents.size(),
                     tangents.size(), vertices);
  for (const ActiveMuscle& active : muscles)
    for (const RegionVertex& v : active.region.vertices)
      if (v.vertex >= vertices)
        return bad_input("bulge: muscle \"{}\" names vertex {}, there are {}", active.muscle.name, v.vertex, vertices);
  return {};
}

void BulgeJob::run() const {
  std::fill(heights.begin(), heights.end(), 0.0);
  if (mode == BulgeMode::off) return;
  std::map<std::uint32_t, Swelling> swollen;
  for (const ActiveMuscle& active : muscles) {
    if (active.activation == 0.0) continue;
    for (const RegionVertex& v : active.region.vertices) {
      const Swelling s = swelling(active, v, mode);
      Swelling& sum = swollen[v.vertex];
      sum.height += s.height;
      sum.gradient += s.gradient;
    }
  }
  for (const auto& [v, s] : swollen) {
    const Vec3 outward = normals[v];
    const auto [t1, t2] = spanning_tangents(bind_normals[v]);
    const Vec3 swollen_t1 = blend[v] * t1 + glm::dot(s.gradient, rest_blend[v] * t1) * outward;
    const Vec3 swollen_t2 = blend[v] * t2 + glm::dot(s.gradient, rest_blend[v] * t2) * outward;
    const Vec3 normal = unit_or(glm::cross(swollen_t1, swollen_t2), outward);
    normals[v] = glm::dot(normal, outward) < 0.0 ? -normal : normal;
    positions[v] += s.height * outward;
    if (!tangents.empty()) {
      const Vec3 raised = glm::dot(s.gradient, rest_blend[v] * Vec3(bind_tangents[v])) * outward;
      tangents[v] += Vec4(raised, 0.0);
    }
    heights[v] = s.height;
  }
}

}  // namespace sinew
