#pragma once
/// The part of glTF 2.0's JSON that Sinew reads: which properties there are, of what type, and what they refer to.

#include <nlohmann/json.hpp>

#include "engine/core/result.h"

namespace sinew::gltf {

/// A copy of the document that holds only properties of known type and range, every reference within its list, whole
/// numbers as unsigned integers. Extensions, extras and everything Sinew does not read is left out. Fails as bad_input
/// with the property's place ("accessors/3/count"), what it must be and what it is.
Result<nlohmann::json> conform(const nlohmann::json& document);

/// The value at the end of a chain of object keys, or nullptr where any of them is missing.
const nlohmann::json* find(const nlohmann::json& value, std::initializer_list<const char*> keys);

}  // namespace sinew::gltf
