#pragma once
/// Public characters and broken files that are not part of the project; CI has them, a user may not.

#include <filesystem>
#include <optional>

#include <gtest/gtest.h>

namespace sinew::test {

/// The folder that SINEW_ASSETS names, if it is there.
std::optional<std::filesystem::path> assets();

/// True where SINEW_REQUIRE_ASSETS is 1: then a test that lacks the assets, or anything else that comes from outside the
/// project, fails instead of being skipped.
bool assets_required();

}  // namespace sinew::test

/// Declares `name` as the assets' folder, or leaves the test: SKIPPED loudly, or failed where they are required.
#define SINEW_ASSETS_OR_SKIP(name)                                                                         \
  const auto name##_found = ::sinew::test::assets();                                                       \
  if (!name##_found) {                                                                                     \
    if (::sinew::test::assets_required())                                                                  \
      FAIL() << "SINEW_REQUIRE_ASSETS is 1, but SINEW_ASSETS does not name a folder with test characters"; \
    GTEST_SKIP() << "SKIPPED: needs real characters; set SINEW_ASSETS to their folder to run this test";   \
  }                                                                                                        \
  const std::filesystem::path name = *name##_found
