#pragma once
#include <cstddef>

#include "engine/core/result.h"
#include "engine/model/character_mesh.h"

namespace sinew {

/// The same character with about `vertices` vertices, for benchmarks: every triangle is split at its edges' midpoints
/// until there are enough, then edges are collapsed (meshoptimizer) until about that many are left. Vertex data at a
/// midpoint is the mean of both ends'. Parts, palette and morph slots stay. Fails as bad_input on a mesh without
/// triangles.
Result<CharacterMesh> resample(const CharacterMesh& mesh, std::size_t vertices);

}  // namespace sinew
