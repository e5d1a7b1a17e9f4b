#pragma once
/// Half a head that somebody modelled, made whole (Yen 1990, 5.2).

#include <filesystem>

#include "engine/core/result.h"
#include "engine/model/model.h"

namespace sinew {

/// The half's triangles and their mirror image about x = 0 as one mesh, vertices at the same place welded, those within
/// a ten-thousandth of the half's size of the middle put into it: exactly symmetric. A .glb, .gltf, .vrm or .obj.
/// Fails as bad_input where it is no half (vertices on both sides, none on the middle) or no surface: an edge with more
/// than two triangles, triangles that face different ways.
Result<Model> mirrored_half_model(const std::filesystem::path& file);

}  // namespace sinew
