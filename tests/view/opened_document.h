#pragma once
/// Documents for tests, opened without a window.

#include <gtest/gtest.h>

#include "engine/view/document.h"

namespace sinew::test {

inline Document opened(const std::string& scene = "builtin:arm") {
  SceneOptions options;
  options.scene = scene;
  auto stage = open_stage(options);
  EXPECT_TRUE(stage) << stage.error().message;
  auto document = Document::create(std::move(*stage), options);
  EXPECT_TRUE(document) << document.error().message;
  return std::move(*document);
}

}  // namespace sinew::test
