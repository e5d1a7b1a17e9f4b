#include "engine/fit/voxel_solid.h"

#include <algorithm>

namespace sinew {
namespace {

constexpr int margin = 2;           ///< voxels of air round the mesh
constexpr std::uint8_t hiding = 2;  ///< axes along which an inner voxel is shut in

void mark_triangle(const std::array<Vec3, 3>& p, VoxelSolid& solid) {
  const double step = 0.5 * solid.size;
  const double longest = std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
  const int n = std::max(1, static_cast<int>(std::ceil(longest / step)));
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
      solid.cells[solid.cell(p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]))] = Voxel::surface;
    }
}

/// Counts the cells between the first and the last surface of every line along an axis.
void look_along(int axis, const VoxelSolid& solid, std::vector<std::uint8_t>& hidden) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  std::array<int, 3> at{};
  for (at[a] = 0; at[a] < solid.count[a]; ++at[a])
    for (at[b] = 0; at[b] < solid.count[b]; ++at[b]) {
      int first = solid.count[axis], last = -1;
      for (at[axis] = 0; at[axis] < solid.count[axis]; ++at[axis]) {
        if (solid.cells[solid.index(at)] != Voxel::surface) continue;
        first = std::min(first, at[axis]);
        last = at[axis];
      }
      for (at[axis] = first; at[axis] < last; ++at[axis]) ++hidden[solid.index(at)];
    }
}

}  // namespace

std::array<int, 3> VoxelSolid::place(const Vec3& p) const {
  std::array<int, 3> at{};
  for (int i = 0; i < 3; ++i)
    at[i] = static_cast<int>(std::clamp(std::floor((p[i] - origin[i]) / size), 0.0, count[i] - 1.0));
  return at;
}

std::array<int, 3> VoxelSolid::place(std::size_t index) const {
  const std::size_t row = index / count[0];
  return {static_cast<int>(index % count[0]), static_cast<int>(row % count[1]), static_cast<int>(row / count[1])};
}

Vec3 VoxelSolid::centre(std::size_t index) const {
  const std::array<int, 3> at = place(index);
  return origin + size * (Vec3(at[0], at[1], at[2]) + 0.5);
}

bool VoxelSolid::sees(const Vec3& from, const Vec3& to) const {
  const int steps = static_cast<int>(std::ceil(2.0 * glm::length(to - from) / size));
  for (int i = 0; i <= steps; ++i)
    if (!solid(steps == 0 ? from : glm::mix(from, to, static_cast<double>(i) / steps))) return false;
  return true;
}

VoxelSolid voxel_solid(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles, int resolution) {
  Bounds bounds;
  for (const Vec3& p : positions) bounds.add(p);
  const Vec3 extent = bounds.high - bounds.low;
  VoxelSolid solid;
  solid.size = std::max({extent.x, extent.y, extent.z, 1e-30}) / resolution;
  // The mesh stands in the middle of an odd number of voxels, so that both halves of a symmetric one are cut alike.
  for (int i = 0; i < 3; ++i) {
    solid.count[i] = (static_cast<int>(std::ceil(extent[i] / solid.size)) + 1 + 2 * margin) | 1;
    solid.origin[i] = bounds.centre()[i] - 0.5 * solid.count[i] * solid.size;
  }
  solid.cells.resize(static_cast<std::size_t>(solid.count[0]) * solid.count[1] * solid.count[2], Voxel::air);
  for (const Vec3& p : positions) solid.cells[solid.cell(p)] = Voxel::surface;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
    mark_triangle({positions[triangles[i]], positions[triangles[i + 1]], positions[triangles[i + 2]]}, solid);
  std::vector<std::uint8_t> hidden(solid.cells.size());
  for (int axis = 0; axis < 3; ++axis) look_along(axis, solid, hidden);
  for (std::size_t i = 0; i < solid.cells.size(); ++i)
    if (solid.cells[i] == Voxel::air && hidden[i] >= hiding) solid.cells[i] = Voxel::inside;
  return solid;
}

}  // namespace sinew
