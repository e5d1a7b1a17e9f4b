#pragma once
/// Morph targets of a primitive and their names (glTF 2.0 section 3.7.2.2; names by the convention of
/// mesh.extras.targetNames).

#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/io/gltf_document.h"
#include "engine/model/model.h"

namespace sinew::gltf {

/// The names that the mesh gives its morph targets; may be shorter than their list.
std::vector<std::string> read_target_names(const Document& document, std::size_t mesh);

/// Target `index` with its name ("target_<index>" where the file gives none) and no changes. Fails where the targets
/// take more memory than a model may: a short file can ask for very many.
Result<MorphTarget> empty_morph_target(Document& document, const std::string& place,
                                       const std::vector<std::string>& names, std::size_t index);

/// Changes of position and normal; tangents and colours are not read. A change of the normal without a normal of the
/// primitive's own, and numbers that are not finite, are left out and noted.
Result<std::vector<MorphTarget>> read_morph_targets(Document& document, const tinygltf::Primitive& primitive,
                                                    const std::string& place, const std::vector<std::string>& names);

}  // namespace sinew::gltf
