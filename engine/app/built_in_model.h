#pragma once
/// The models that need no file.

#include <string>

#include "engine/core/result.h"
#include "engine/model/model.h"

namespace sinew {

/// "builtin:arm" or "builtin:figure", one of built_in_model_names().
Result<Model> built_in_model(const std::string& name);

}  // namespace sinew
