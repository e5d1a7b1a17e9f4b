#pragma once
/// A mesh without more to it, as a model.

#include <filesystem>

#include "engine/core/result.h"
#include "engine/model/model.h"

namespace sinew {

/// A Wavefront OBJ file's vertices, in its order and with smooth normals, as a model of one mesh; polygons are cut into
/// fans. Fails as read_obj does, and as bad_input where there are no faces.
Result<Model> obj_model(const std::filesystem::path& file);

/// obj_model for a name that ends in .obj, else read_gltf.
Result<Model> read_mesh_model(const std::filesystem::path& file);

}  // namespace sinew
