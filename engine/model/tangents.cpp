#include "engine/model/tangents.h"

#include <array>

namespace sinew {
namespace {

/// What the triangles round a vertex say, apart by handedness.
struct VertexFrame {
  std::array<Vec3, 2> tangent{Vec3(0.0), Vec3(0.0)};
  std::array<double, 2> angle{0.0, 0.0};
};

/// The part of v in the plane of the unit vector n.
Vec3 in_plane(const Vec3& v, const Vec3& n) { return v - glm::dot(v, n) * n; }

Vec3 any_in_plane(const Vec3& n) {
  const Vec3 helper = std::abs(n.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  return glm::normalize(in_plane(helper, n));
}

}  // namespace

std::vector<Vec4> generate_tangents(const Primitive& primitive, const Texture& texture) {
  const std::vector<Vec2>& coordinates =
      texture.coordinates == 1 ? primitive.second_texture_coordinates : primitive.texture_coordinates;
  const auto uv = [&](std::uint32_t v) { return coordinates.empty() ? Vec2(0.0) : texture.apply(coordinates[v]); };
  std::vector<VertexFrame> frames(primitive.positions.size());
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const std::uint32_t* corner = &primitive.indices[i];
    const std::array<Vec3, 3> p{primitive.positions[corner[0]], primitive.positions[corner[1]],
                                primitive.positions[corner[2]]};
    const Vec2 origin = uv(corner[0]), first = uv(corner[1]) - origin, second = uv(corner[2]) - origin;
    const double determinant = first.x * second.y - second.x * first.y;
    if (determinant == 0.0) continue;
    const Vec3 rising = (second.y * (p[1] - p[0]) - first.y * (p[2] - p[0])) / determinant;
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 &here = p[c], &next = p[(c + 1) % 3], &last = p[(c + 2) % 3];
      const Vec3 tangent = in_plane(rising, primitive.normals[corner[c]]);
      if (!(glm::length(tangent) > 0.0)) continue;
      const double angle = angle_degrees(next - here, last - here);
      VertexFrame& frame = frames[corner[c]];
      const std::size_t side = determinant < 0.0 ? 0 : 1;
      frame.tangent[side] += angle * glm::normalize(tangent);
      frame.angle[side] += angle;
    }
  }
  std::vector<Vec4> tangents;
  tangents.reserve(frames.size());
  for (std::size_t v = 0; v < frames.size(); ++v) {
    const std::size_t side = frames[v].angle[1] > frames[v].angle[0] ? 1 : 0;
    const Vec3& n = primitive.normals[v];
    const Vec3 tangent = unit_or(in_plane(frames[v].tangent[side], n), any_in_plane(n));
    // v points down and a normal texture's green up: a texture that is not mirrored has w = 1.
    tangents.emplace_back(tangent, side == 0 ? 1.0 : -1.0);
  }
  return tangents;
}

}  // namespace sinew
