#include "engine/io/ply.h"

#include <bit>
#include <cassert>
#include <cstring>

#include <fmt/format.h>

namespace sinew {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY's numbers are copied as they are");

constexpr std::size_t vertex_size = 6 * sizeof(float);
constexpr std::size_t triangle_size = 1 + 3 * sizeof(std::uint32_t);

std::string header(std::size_t vertices, std::size_t triangles) {
  return fmt::format(
      "ply\n"
      "format binary_little_endian 1.0\n"
      "element vertex {}\n"
      "property float x\n"
      "property float y\n"
      "property float z\n"
      "property float nx\n"
      "property float ny\n"
      "property float nz\n"
      "element face {}\n"
      "property list uchar int vertex_indices\n"
      "end_header\n",
      vertices, triangles);
}

}  // namespace

Bytes ply_bytes(const BakedMesh& mesh, std::size_t frame) {
  assert(frame < mesh.frames.size());
  const BakedFrame& baked = mesh.frames[frame];
  const std::size_t vertices = baked.positions.size(), triangles = mesh.triangles.size() / 3;
  const std::string head = header(vertices, triangles);

  Bytes file(head.size() + vertices * vertex_size + triangles * triangle_size);
  unsigned char* out = file.data();
  const auto put = [&out](const void* data, std::size_t size) {
    std::memcpy(out, data, size);
    out += size;
  };
  put(head.data(), head.size());
  for (std::size_t i = 0; i < vertices; ++i) {
    put(&baked.positions[i], sizeof(Vec3f));
    put(&baked.normals[i], sizeof(Vec3f));
  }
  const unsigned char corners = 3;
  for (std::size_t i = 0; i < triangles; ++i) {
    put(&corners, 1);
    put(&mesh.triangles[3 * i], 3 * sizeof(std::uint32_t));
  }
  return file;
}

}  // namespace sinew
