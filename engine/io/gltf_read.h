#pragma once
/// glTF 2.0 in: .glb, .gltf and .vrm files as a Model.

#include <filesystem>

#include "engine/core/files.h"
#include "engine/core/result.h"
#include "engine/model/model.h"

namespace sinew {

/// Reads a glTF file, told by its content, not by its name, with the buffers and images that it refers to.
///
/// Read are: triangles (lists, strips, fans) with positions, normals, the base colour's texture coordinates, skin
/// weights and morph targets; nodes, skins, the scene that is shown; animations of nodes and morph weights; base colour
/// materials; VRM humanoid maps; KHR_mesh_quantization, KHR_texture_transform and what pbrSpecularGlossiness says of
/// the colour. The file is data from anywhere: every index, range and count is checked before it is used, and memory is
/// bounded (2 GiB with everything, 512 MiB of input).
///
/// Fails as bad_input, naming the file, the place in it ("accessors/3"), what is wrong and what would be right. What
/// can be put right or done without is not a failure: Model::problems has a sentence about each.
Result<Model> read_gltf(const std::filesystem::path& file);

/// The same of bytes that were read already; `file` is their name, and files that they refer to lie beside it.
Result<Model> read_gltf(const std::filesystem::path& file, Bytes bytes);

}  // namespace sinew
