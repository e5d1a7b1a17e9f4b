#include "engine/deform/muscle_region.h"

#include <algorithm>

namespace sinew {
namespace {

double weight_share(const CharacterMesh& mesh, const std::vector<bool>& in_segment, std::size_t v) {
  double share = 0.0;
  for (std::uint32_t i = mesh.influences.first[v]; i < mesh.influences.first[v + 1]; ++i)
    if (in_segment[mesh.palette[mesh.influences.entries[i].joint].node]) share += mesh.influences.entries[i].weight;
  return share;
}

double along_bone(const ProjectionPlane& plane, const Vec3& p) {
  return glm::dot(p - plane.bone, plane.axis) / plane.length;
}

/// 180 where the normal runs along the limb and so faces neither side.
double angle_to_normal(const ProjectionPlane& plane, const Vec3& normal) {
  const Vec3 across = normal - glm::dot(normal, plane.axis) * plane.axis;
  return glm::length(across) < 1e-9 ? 180.0 : angle_degrees(across, plane.normal);
}

}  // namespace

std::vector<bool> segment_nodes(const Model& model, int bone, int child, std::span<const int> except) {
  std::vector<bool> in_segment(model.nodes.size());
  std::vector<int> pending{bone};
  while (!pending.empty()) {
    const int node = pending.back();
    pending.pop_back();
    if (node == child || std::find(except.begin(), except.end(), node) != except.end()) continue;
    in_segment[node] = true;
    pending.insert(pending.end(), model.nodes[node].children.begin(), model.nodes[node].children.end());
  }
  return in_segment;
}

Result<ProjectionPlane> projection_plane(const Muscle& muscle, std::span<const Mat4> rest_global) {
  ProjectionPlane plane;
  plane.bone = Vec3(rest_global[muscle.bone][3]);
  plane.child = Vec3(rest_global[muscle.child][3]);
  plane.length = glm::length(plane.child - plane.bone);
  if (plane.length < 1e-12)
    return bad_input("muscle \"{}\": its bone and its child stand at the same place", muscle.name);
  plane.axis = (plane.child - plane.bone) / plane.length;
  const Vec3 facing = unit_or(muscle.facing, Vec3(0.0));
  const Vec3 across = facing - glm::dot(facing, plane.axis) * plane.axis;
  if (glm::length(across) < 1e-6)
    return bad_input("muscle \"{}\": its facing ({}, {}, {}) runs along the limb; give the side that the belly faces",
                     muscle.name, muscle.facing.x, muscle.facing.y, muscle.facing.z);
  plane.normal = glm::normalize(across);
  plane.side = glm::cross(plane.normal, plane.axis);
  return plane;
}

Result<MuscleRegion> muscle_region(const Model& model, const CharacterMesh& mesh, const RestShape& rest,
                                   const Muscle& muscle) {
  auto plane = projection_plane(muscle, rest.global);
  if (!plane) return pass_on(std::move(plane));
  MuscleRegion region;
  region.plane = *plane;
  const std::vector<bool> in_segment = segment_nodes(model, muscle.bone, muscle.child, muscle.except);

  Vec2 centre(0.0);
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    if (!in_segment[mesh.bone(v)]) continue;
    ++region.segment_vertices;
    RegionVertex r;
    r.vertex = static_cast<std::uint32_t>(v);
    r.t = along_bone(*plane, rest.positions[v]);
    r.angle = angle_to_normal(*plane, rest.normals[v]);
    if (r.t < muscle.from || r.t > muscle.to || !(r.angle <= muscle.spread)) continue;
    const Vec3 from_child = rest.positions[v] - plane->child;
    r.x = glm::dot(from_child, plane->axis);
    r.y = glm::dot(from_child, plane->side);
    r.share = weight_share(mesh, in_segment, v);
    centre += Vec2(r.x, r.y);
    region.vertices.push_back(r);
  }
  if (!region.vertices.empty()) centre /= static_cast<double>(region.vertices.size());
  for (RegionVertex& r : region.vertices) {
    r.x -= centre.x;
    r.y -= centre.y;
  }
  region.centre = plane->child + centre.x * plane->axis + centre.y * plane->side;
  return region;
}

double limb_radius(const Model& model, const CharacterMesh& mesh, const RestShape& rest, const Muscle& muscle,
                   const MuscleRegion& region) {
  const ProjectionPlane& plane = region.plane;
  const std::vector<bool> in_segment = segment_nodes(model, muscle.bone, muscle.child, muscle.except);
  const double centre = along_bone(plane, region.centre);
  for (double reach = 0.05; reach < 2.0; reach *= 2.0) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
      if (!in_segment[mesh.bone(v)]) continue;
      const double t = along_bone(plane, rest.positions[v]);
      if (std::abs(t - centre) > reach) continue;
      sum += glm::length(rest.positions[v] - plane.bone - t * plane.length * plane.axis);
      ++count;
    }
    if (count > 0) return sum / static_cast<double>(count);
  }
  return 0.0;
}

RegionFade region_fade(const Muscle& muscle, const RegionVertex& v) {
  const double q = (muscle.to - muscle.from) / 4.0;
  const double begin = (v.t - muscle.from) / q, end = (muscle.to - v.t) / q;
  const double held = smoothstep01((muscle.spread - v.angle) / 20.0) * smoothstep01((v.share - 0.5) / 0.25);
  return {smoothstep01(begin) * smoothstep01(end) * held,
          (smoothstep01_slope(begin) * smoothstep01(end) - smoothstep01(begin) * smoothstep01_slope(end)) / q * held};
}

}  // namespace sinew
