#pragma once
/// Skin weights: every JOINTS_n and WEIGHTS_n pair of a primitive as one run of influences a vertex.

#include <map>
#include <string>

#include "engine/core/result.h"
#include "engine/io/gltf_document.h"
#include "engine/model/model.h"

namespace sinew::gltf {

/// Influences in the order that model.h promises, weights summing to 1; without vertices where the primitive has no
/// weights. Zero weights are dropped, a joint that stands twice is merged, and of more than max_influences the
/// strongest are kept; whatever changed the file's numbers is noted as a problem. Joint numbers are not compared with a
/// skin yet.
Result<Influences> read_influences(Document& document, const std::map<std::string, int>& attributes,
                                   const std::string& place, std::size_t vertices);

}  // namespace sinew::gltf
