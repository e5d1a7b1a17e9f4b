/// Broken and unusual files: each ends soon, in a result or in a reason, and never by a signal.

#include "tests/support/assets.h"
#include "tests/support/gltf_corpus.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

class BadInput : public ProgramTest {
 protected:
  static constexpr double longest_seconds = 10.0;
  static constexpr double largest_mib = 2048.0;

  /// Gives every file to `info` and to `render`; the results of `info`, in the files' order.
  std::vector<ProgramResult> sweep(const std::vector<std::string>& files) const {
    std::vector<Arguments> infos, renders;
    for (std::size_t i = 0; i < files.size(); ++i) {
      infos.push_back({"info", files[i], "--json"});
      renders.push_back({"render", files[i], "--size", "32x18", "-o", fmt::format("{}.png", i)});
    }
    const ProgramOptions limits{.time_limit = std::chrono::milliseconds(static_cast<int>(1000 * longest_seconds))};
    const auto described = run_all(infos, limits), rendered = run_all(renders, limits);
    for (std::size_t i = 0; i < files.size(); ++i) {
      expect_result_or_reason(described[i]);
      expect_result_or_reason(rendered[i]);
      EXPECT_EQ(described[i].exit_code, rendered[i].exit_code)
          << "info and render do not agree on whether the file can be used" << described[i] << rendered[i];
      EXPECT_EQ(fs::exists(path(fmt::format("{}.png", i))), rendered[i].exit_code == 0) << rendered[i];
    }
    return described;
  }

  static void expect_result_or_reason(const ProgramResult& result) {
    EXPECT_FALSE(result.timed_out) << result;
    EXPECT_EQ(result.signal, 0) << result;
    EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 3) << result;
    if (result.exit_code == 3) {
      EXPECT_NE(result.err, "") << result;
    }
    EXPECT_LT(result.peak_memory_mib, largest_mib) << result;
  }
};

/// What a folder holds that could be taken for a model, a mesh or a scene.
std::vector<std::string> inputs(const fs::path& folder) {
  std::vector<std::string> files;
  for (const fs::path& file : gltf_files(folder)) files.push_back(file.string());
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string(), ending = entry.path().extension().string();
    if (ending == ".obj" || (ending == ".json" && !name.ends_with(".report.json")))
      files.push_back(entry.path().string());
  }
  return files;
}

TEST_F(BadInput, FilesOfOtherProgramsTests) {
  SINEW_ASSETS_OR_SKIP(assets);
  std::vector<std::string> files;
  for (const std::string& file : inputs(assets / "bad"))
    if (file.find("/gltf_validator/") == std::string::npos) files.push_back(file);
  EXPECT_GT(files.size(), 20u);
  sweep(files);
}

TEST_F(BadInput, UnusualFilesAreUsed) {
  SINEW_ASSETS_OR_SKIP(assets);
  std::vector<std::string> files;
  for (const fs::path& file : gltf_files(assets / "edge")) files.push_back(file.string());
  EXPECT_GT(files.size(), 5u);
  for (const ProgramResult& result : sweep(files)) EXPECT_EQ(result.exit_code, 0) << result;
}

/// The validator's cases, in two halves so that each test stays short.
std::vector<fs::path> validator_cases(const fs::path& assets, std::size_t half) {
  std::vector<fs::path> cases;
  std::size_t number = 0;
  for (const fs::path& file : gltf_files(assets / "bad/gltf_validator"))
    if (number++ % 2 == half) cases.push_back(file);
  return cases;
}

void expect_errors_told(const fs::path& file, const ProgramResult& result) {
  if (result.exit_code != 0 || !json_of(result)["problems"].empty()) return;
  for (const std::string& code : validator_errors(file))
    EXPECT_FALSE(allowance(code, file.string()).empty()) << "passes without a word: " << code << result;
}

TEST_F(BadInput, ValidatorCasesFirstHalf) {
  SINEW_ASSETS_OR_SKIP(assets);
  const auto cases = validator_cases(assets, 0);
  EXPECT_GT(cases.size(), 75u);
  const auto results = sweep({cases.begin(), cases.end()});
  for (std::size_t i = 0; i < cases.size(); ++i) expect_errors_told(cases[i], results[i]);
}

TEST_F(BadInput, ValidatorCasesSecondHalf) {
  SINEW_ASSETS_OR_SKIP(assets);
  const auto cases = validator_cases(assets, 1);
  EXPECT_GT(cases.size(), 75u);
  const auto results = sweep({cases.begin(), cases.end()});
  for (std::size_t i = 0; i < cases.size(); ++i) expect_errors_told(cases[i], results[i]);
}

TEST_F(BadInput, DeepAndEndlessText) {
  const std::string opening(1 << 20, '[');
  write("deep.json", R"({"sinew": 1, "characters": )" + opening);
  write("deep.gltf", R"({"asset": )" + opening);
  write("long.gltf", R"({"asset": {"version": ")" + std::string(1 << 22, '2'));
  write("zeros.glb", std::string(1 << 22, '\0'));
  for (const ProgramResult& result : sweep({"deep.json", "deep.gltf", "long.gltf", "zeros.glb"}))
    EXPECT_EQ(result.exit_code, 3) << result;
}

TEST_F(BadInput, CutShort) {
  arm();
  const Bytes whole = read("arm.glb");
  std::vector<std::string> files;
  for (int part = 0; part < 16; ++part) {
    files.push_back(fmt::format("cut{}.glb", part));
    const std::size_t size = whole.size() * static_cast<std::size_t>(part) / 16;
    ASSERT_TRUE(write_file(path(files.back()), std::span(whole).first(size)));
  }
  for (const ProgramResult& result : sweep(files)) EXPECT_EQ(result.exit_code, 3) << result;
}

TEST_F(BadInput, ScenesThatAskForTooMuch) {
  arm();
  const std::vector<std::string> wishes{R"("frames": [0, 10000000])",
                                        R"("frames": [0, 99999999999999999999])",
                                        R"("frames": [-5, 3])",
                                        R"("fps": 1e-300)",
                                        R"("fps": 1e300)",
                                        R"("camera": {"distance": 1e308})",
                                        R"("camera": {"target": [1e308, 1e308, 1e308]})"};
  std::vector<std::string> files;
  for (const std::string& wish : wishes) {
    files.push_back(fmt::format("{}.json", files.size()));
    write(files.back(), R"({"sinew": 1, "characters": [{"model": "arm.glb"}], )" + wish + "}");
  }
  sweep(files);
}

TEST_F(BadInput, ASceneThatNamesItselfAsItsModel) {
  write("self.json", R"({"sinew": 1, "characters": [{"model": "self.json"}]})");
  EXPECT_EQ(sweep({"self.json"})[0].exit_code, 3);
}

TEST_F(BadInput, PicturesThatAreNone) {
  ASSERT_EQ(run({"render", arm_scene, "--size", "64x64", "-o", "whole.png"}).exit_code, 0);
  const Bytes whole = read("whole.png");
  for (std::size_t size : {std::size_t{0}, std::size_t{7}, std::size_t{20}, whole.size() / 2, whole.size() - 1}) {
    ASSERT_TRUE(write_file(path("cut.png"), std::span(whole).first(size)));
    const ProgramResult result = run({"compare", "whole.png", "cut.png"});
    EXPECT_EQ(result.exit_code, 3) << size << " bytes" << result;
    EXPECT_NE(result.err.find("cut.png"), std::string::npos) << result;
  }
}

}  // namespace
}  // namespace sinew::test
