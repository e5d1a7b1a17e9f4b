#pragma once
/// Stanford PLY out.

#include <cstddef>

#include "engine/core/files.h"
#include "engine/model/baked_mesh.h"

namespace sinew {

/// One frame as `binary_little_endian 1.0`: vertices as float x, y, z, nx, ny, nz in world units, triangles as
/// `list uchar int vertex_indices`.
Bytes ply_bytes(const BakedMesh& mesh, std::size_t frame);

}  // namespace sinew
