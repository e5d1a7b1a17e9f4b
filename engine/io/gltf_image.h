#pragma once
/// Images (glTF 2.0 section 3.8).

#include <vector>

#include "engine/core/result.h"
#include "engine/io/gltf_document.h"
#include "engine/model/material.h"

namespace sinew::gltf {

/// All images, still encoded. One that cannot be found, or is neither PNG nor JPEG, is left empty and noted; fails only
/// where the images take more memory than a model may.
Result<std::vector<EncodedImage>> read_images(Document& document);

}  // namespace sinew::gltf
