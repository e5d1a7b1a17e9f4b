#pragma once
/// The weights of one mesh on another that stands in the same place.

#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/model/model.h"

namespace sinew {

/// Replaces the weights of every skinned mesh of `model` by those of `other`'s, each vertex those of the closest point
/// of its surface, in the triangle's proportions; both in their bind shapes. Joints are those of the same names; a
/// joint that the model lacks gives its weight to the nearest one above it that the model has. Returns the names of
/// those joints. Fails as bad_input where either has no skinned mesh or no joint has the same name.
Result<std::vector<std::string>> transfer_weights(const Model& other, Model& model);

/// The same from a skinned glTF file; the joints that the model lacks are named in `problems`.
Result<void> take_weights(const std::string& file, Model& model, std::vector<std::string>& problems);

}  // namespace sinew
