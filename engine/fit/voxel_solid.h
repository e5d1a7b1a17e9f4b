#pragma once
/// A mesh as a solid of voxels, whether it is closed or not.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

enum class Voxel : std::uint8_t { air, surface, inside };

/// Cubes of one size that fill a box round the mesh, x fastest.
struct VoxelSolid {
  Vec3 origin{0.0};   ///< lowest corner
  double size = 1.0;  ///< of a voxel
  std::array<int, 3> count{};
  std::vector<Voxel> cells;

  std::array<int, 3> place(const Vec3& p) const;  ///< clamped to the box
  std::size_t index(const std::array<int, 3>& at) const {
    return (static_cast<std::size_t>(at[2]) * count[1] + at[1]) * count[0] + at[0];
  }
  std::array<int, 3> place(std::size_t index) const;
  std::size_t cell(const Vec3& p) const { return index(place(p)); }
  Vec3 centre(std::size_t index) const;
  bool solid(std::size_t index) const { return cells[index] != Voxel::air; }
  bool solid(const Vec3& p) const { return solid(cell(p)); }
  /// True where the straight line lies in the solid, looked at in steps of half a voxel.
  bool sees(const Vec3& from, const Vec3& to) const;
};

/// `resolution` voxels along the longest side. A voxel that no triangle touches is inside where surface shuts it in
/// from both sides along at least two of the three axes, so that a mesh may be open at both ends and in many pieces
/// (Dionne and de Lasa, *Geodesic Voxel Binding for Production Character Meshes*, 2013, ask for all three).
VoxelSolid voxel_solid(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles, int resolution);

}  // namespace sinew
