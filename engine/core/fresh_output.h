#pragma once
/// Files that a command is about to write.

#include <span>
#include <string>

#include "engine/core/result.h"

namespace sinew {

/// Fails as cannot_write where `output` is one of the inputs (empty names are none) or cannot be written.
Result<void> check_fresh_output(const std::string& output, std::span<const std::string> inputs);

}  // namespace sinew
