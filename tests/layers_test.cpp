/// The layers include each other in one direction only; Vulkan stays in its rooms; files stay small enough to read.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

/// From the top down. A layer may include itself and what stands after it.
const std::vector<std::string> layers = {"tools",  "view", "app",    "render", "gpu", "body",  "face",
                                         "motion", "fit",  "deform", "rig",    "io",  "model", "core"};

constexpr std::size_t most_lines = 500;

struct SourceFile {
  std::string path;  ///< from the project's root, with slashes
  std::vector<std::string> lines;
};

std::vector<std::string> lines_of(std::istream& in) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

SourceFile made_up(const std::string& path, const std::string& text) {
  std::istringstream in(text);
  return {path, lines_of(in)};
}

std::vector<SourceFile> sources_in(const std::vector<std::string>& folders) {
  const fs::path root = SINEW_SOURCE_DIR;
  const std::vector<std::string> endings = {".h", ".cpp", ".comp", ".vert", ".frag"};
  std::vector<SourceFile> files;
  for (const std::string& folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (std::find(endings.begin(), endings.end(), entry.path().extension().string()) == endings.end()) continue;
      std::ifstream in(entry.path());
      EXPECT_TRUE(in) << entry.path();
      files.push_back({entry.path().lexically_relative(root).generic_string(), lines_of(in)});
    }
  return files;
}

/// What a line includes: "engine/core/math.h" of `#include "engine/core/math.h"`, `vector` of `#include <vector>`.
std::optional<std::string> included_by(const std::string& line) {
  std::size_t at = line.find_first_not_of(" \t");
  if (at == std::string::npos || line[at] != '#') return std::nullopt;
  at = line.find_first_not_of(" \t", at + 1);
  constexpr std::string_view word = "include";
  if (at == std::string::npos || line.compare(at, word.size(), word) != 0) return std::nullopt;
  const std::size_t begin = line.find_first_of("\"<", at), end = line.find_first_of("\">", begin + 1);
  if (begin == std::string::npos || end == std::string::npos) return std::nullopt;
  return line.substr(begin + 1, end - begin - 1);
}

/// The layer's place in the list, or nothing for a path that belongs to none.
std::optional<std::size_t> layer_of(const std::string& path) {
  std::istringstream parts(path);
  std::string first, second;
  std::getline(parts, first, '/');
  std::getline(parts, second, '/');
  const auto found = std::find(layers.begin(), layers.end(), first == "engine" ? second : first);
  if (found == layers.end() || (first != "engine" && first != "tools")) return std::nullopt;
  return static_cast<std::size_t>(found - layers.begin());
}

bool is_ours(const std::string& include) { return include.starts_with("engine/") || include.starts_with("tools/"); }

/// A sentence about each include that goes up or to no layer.
std::vector<std::string> wrong_includes(const SourceFile& file) {
  std::vector<std::string> wrong;
  const auto from = layer_of(file.path);
  if (!from) wrong.push_back(file.path + " lies in no layer");
  for (std::size_t i = 0; from && i < file.lines.size(); ++i) {
    const auto include = included_by(file.lines[i]);
    if (!include || !is_ours(*include)) continue;
    const auto to = layer_of(*include);
    if (!to || *to < *from)
      wrong.push_back(file.path + ":" + std::to_string(i + 1) + " in " + layers[*from] + " includes " + *include +
                      (to ? ", which is above it" : ", which lies in no layer"));
  }
  return wrong;
}

bool may_know_vulkan(const std::string& path) {
  return path.starts_with("engine/gpu/") || path.starts_with("engine/render/") || path.starts_with("engine/view/");
}

bool is_vulkan(const std::string& include) {
  return include.starts_with("vulkan/") || include.starts_with("vk_") || include == "volk.h";
}

std::vector<std::string> vulkan_includes(const SourceFile& file) {
  std::vector<std::string> found;
  for (const std::string& line : file.lines)
    if (const auto include = included_by(line); include && is_vulkan(*include))
      found.push_back(file.path + ": " + line);
  return found;
}

TEST(Layers, IncludesGoDown) {
  const std::vector<SourceFile> files = sources_in({"engine", "tools"});
  EXPECT_GT(files.size(), 100u) << "the sources were not found in " << SINEW_SOURCE_DIR;
  std::size_t ours = 0;
  for (const SourceFile& file : files) {
    for (const std::string& wrong : wrong_includes(file)) ADD_FAILURE() << wrong;
    for (const std::string& line : file.lines) ours += is_ours(included_by(line).value_or(""));
  }
  EXPECT_GT(ours, 300u);
}

TEST(Layers, AnIncludeThatGoesUpIsFound) {
  const auto wrong = [](const char* path, const char* text) { return wrong_includes(made_up(path, text)).size(); };
  EXPECT_EQ(wrong("engine/core/math.h", "#include \"engine/model/model.h\"\n"), 1u);
  EXPECT_EQ(
      wrong("engine/rig/pose.cpp", "  #  include \"engine/deform/ssd.h\"  // why\n#include \"engine/gpu/device.h\""),
      2u);
  EXPECT_EQ(wrong("engine/app/frame.h", "#include \"tools/command.h\""), 1u);
  EXPECT_EQ(wrong("engine/gpu/device.h", "#include \"engine/nowhere/x.h\""), 1u);
  EXPECT_EQ(wrong("engine/nowhere/x.h", ""), 1u);
  EXPECT_EQ(wrong("engine/deform/ssd.h",
                  "#include \"engine/deform/rigid.h\"\n#include \"engine/core/math.h\"\n#include <gpu>"),
            0u);
  EXPECT_EQ(wrong("tools/main.cpp", "#include \"engine/app/frame.h\"\n#include \"tools/command.h\""), 0u);
  EXPECT_EQ(wrong("engine/core/math.h", "// #include \"engine/app/frame.h\""), 0u);
}

TEST(Layers, VulkanStaysInGpuAndRender) {
  std::size_t inside = 0;
  for (const SourceFile& file : sources_in({"engine", "tools"})) {
    const std::vector<std::string> found = vulkan_includes(file);
    inside += found.size();
    if (may_know_vulkan(file.path)) continue;
    for (const std::string& include : found) ADD_FAILURE() << include;
  }
  EXPECT_GT(inside, 0u) << "somebody must include Vulkan";
  EXPECT_EQ(vulkan_includes(made_up("engine/app/x.h", "#include <vulkan/vulkan_raii.hpp>\n#include \"vk_mem_alloc.h\""))
                .size(),
            2u);
  EXPECT_TRUE(may_know_vulkan("engine/gpu/device.h") && may_know_vulkan("engine/render/renderer.h"));
  EXPECT_FALSE(may_know_vulkan("engine/app/frame.h") || may_know_vulkan("tools/gpu/x.h"));
}

TEST(Layers, FilesAreShortEnoughToRead) {
  const std::vector<SourceFile> files = sources_in({"engine", "tools", "shaders", "tests"});
  EXPECT_GT(files.size(), 150u);
  for (const SourceFile& file : files) EXPECT_LT(file.lines.size(), most_lines) << file.path;
}

}  // namespace
}  // namespace sinew::test
