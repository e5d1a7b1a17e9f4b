#pragma once
/// Animations as clips (glTF 2.0 section 3.11).

#include <vector>

#include "engine/core/result.h"
#include "engine/io/gltf_document.h"
#include "engine/model/model.h"

namespace sinew::gltf {

/// All animations in the file's order. Keys whose times do not rise or whose values are no numbers are dropped,
/// channels on unknown properties or on one that has a channel already are left out; each is noted. Fails where a
/// sampler's formats or counts are wrong.
Result<std::vector<Clip>> read_clips(Document& document, const std::vector<Node>& nodes,
                                     const std::vector<Mesh>& meshes);

}  // namespace sinew::gltf
