#include "engine/core/fresh_output.h"

#include <filesystem>

#include "engine/core/files.h"

namespace sinew {

Result<void> check_fresh_output(const std::string& output, std::span<const std::string> inputs) {
  for (const std::string& input : inputs) {
    std::error_code none;
    if (!input.empty() && std::filesystem::equivalent(input, output, none))
      return failure(ErrorKind::cannot_write, "{}: is read by this very command; write to another file", output);
  }
  return check_writable(output);
}

}  // namespace sinew
