#include "engine/io/gltf_triangles.h"

#include <numeric>

#include "engine/io/gltf_access.h"

namespace sinew::gltf {
namespace {

using Indices = std::vector<std::uint32_t>;

/// The value that means "begin a new strip" elsewhere; glTF forbids it.
double restart_value(int component_type) {
  if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return 255.0;
  return component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 65535.0 : 4294967295.0;
}

Result<Indices> read_indices(Document& document, int accessor, const std::string& place, std::size_t vertices) {
  constexpr int types[] = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                           TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT};
  auto numbers = read_accessor(document, accessor, place + "/indices",
                               {TINYGLTF_TYPE_SCALAR, types, "SCALAR of unsigned bytes, shorts or ints"});
  if (!numbers) return pass_on(std::move(numbers));
  const tinygltf::Accessor& from = document.gltf.accessors[static_cast<std::size_t>(accessor)];
  if (from.normalized) return bad_input("{}/indices: indices must not be normalized", place);
  const double restart = restart_value(from.componentType);
  std::size_t restarts = 0;
  Indices indices;
  indices.reserve(numbers->count());
  for (std::size_t i = 0; i < numbers->count(); ++i) {
    const double index = numbers->values[i];
    if (index >= static_cast<double>(vertices))
      return bad_input("{}/indices: index {} is {}, but there are only {} vertices{}", place, i, index, vertices,
                       index == restart ? " (it is the primitive restart value, which glTF forbids)" : "");
    restarts += index == restart ? 1 : 0;
    indices.push_back(static_cast<std::uint32_t>(index));
  }
  if (restarts > 0)
    document.problem("{}/indices: {} times {}, the primitive restart value, which glTF forbids; taken as a vertex",
                     place, restarts, restart);
  return indices;
}

/// glTF 2.0 section 3.7.2.1: every second triangle of a strip is turned round.
Indices from_strip(const Indices& strip) {
  Indices list;
  for (std::size_t i = 0; i + 2 < strip.size(); ++i)
    list.insert(list.end(), {strip[i], strip[i + 1 + i % 2], strip[i + 2 - i % 2]});
  return list;
}

Indices from_fan(const Indices& fan) {
  Indices list;
  for (std::size_t i = 0; i + 2 < fan.size(); ++i) list.insert(list.end(), {fan[i + 1], fan[i + 2], fan[0]});
  return list;
}

}  // namespace

Result<Indices> read_triangles(Document& document, const tinygltf::Primitive& primitive, const std::string& place,
                               std::size_t vertices) {
  Indices indices;
  if (primitive.indices >= 0) {
    auto read = read_indices(document, primitive.indices, place, vertices);
    if (!read) return read;
    indices = std::move(*read);
  } else {
    indices.resize(vertices);
    std::iota(indices.begin(), indices.end(), 0u);
  }
  if (auto taken = document.take_memory(4 * sizeof(std::uint32_t) * indices.size(), place); !taken)
    return pass_on(std::move(taken));
  if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP) return from_strip(indices);
  if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) return from_fan(indices);
  if (const std::size_t rest = indices.size() % 3; rest != 0) {
    document.problem("{}: {} indices make no whole number of triangles; the last {} are left out", place,
                     indices.size(), rest);
    indices.resize(indices.size() - rest);
  }
  return indices;
}

std::vector<Vec3> smooth_normals(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles) {
  std::vector<Vec3> normals(positions.size(), Vec3(0.0));
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
    const Vec3& a = positions[triangles[t]];
    const Vec3 cross = glm::cross(positions[triangles[t + 1]] - a, positions[triangles[t + 2]] - a);
    for (std::size_t corner = 0; corner < 3; ++corner) normals[triangles[t + corner]] += cross;
  }
  for (Vec3& normal : normals) normal = unit_or(normal, Vec3(0, 0, 1));
  return normals;
}

}  // namespace sinew::gltf
