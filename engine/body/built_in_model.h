#pragma once
/// Models that need no file, by the names that scenes and command lines know them by.

#include <optional>
#include <string_view>

#include "engine/body/figure.h"
#include "engine/core/result.h"
#include "engine/model/model.h"

namespace sinew {

/// "builtin:arm" (arm.h); "builtin:figure", the figure with its default options; and "builtin:skeleton",
/// "builtin:woman", "builtin:poser", its presets (figure.h); "builtin:head", an adult's (face/drawn_head.h). The same
/// name gives the same model to the bit. Fails as bad_input for another name, with the nearest known one.
Result<Model> built_in_model(std::string_view name);

/// What a built-in figure is made from; nothing for other names.
std::optional<BodyOptions> built_in_figure(std::string_view name);

}  // namespace sinew
