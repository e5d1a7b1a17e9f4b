#pragma once
/// Any file that holds a mesh, as a Model.

#include <filesystem>

#include "engine/core/result.h"
#include "engine/model/model.h"

namespace sinew {

/// True where the name ends in .obj or .ply, letter case ignored.
bool is_polygon_file(const std::filesystem::path& file);

/// An .obj or .ply file as one node with a mesh of its name: the file's vertices in its order, polygons as fans of
/// triangles, smooth normals; any other file as read_gltf() has it. Fails as bad_input naming the place in the file.
Result<Model> read_mesh(const std::filesystem::path& file);

}  // namespace sinew
