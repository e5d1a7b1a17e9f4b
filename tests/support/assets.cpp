#include "tests/support/assets.h"

#include <cstdlib>
#include <string_view>

namespace sinew::test {

std::optional<std::filesystem::path> assets() {
  const char* folder = std::getenv("SINEW_ASSETS");
  std::error_code error;
  if (folder == nullptr || !std::filesystem::is_directory(std::filesystem::path(folder) / "characters", error))
    return std::nullopt;
  return std::filesystem::path(folder);
}

bool assets_required() {
  const char* required = std::getenv("SINEW_REQUIRE_ASSETS");
  return required != nullptr && std::string_view(required) == "1";
}

}  // namespace sinew::test
