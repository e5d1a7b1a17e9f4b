/// Pictures of the embedded scene against those that were looked at and kept in tests/golden, by `sinew compare`.

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>

#include "tests/support/program.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

struct GoldenPicture {
  std::string name;
  Arguments arguments;
  /// Levels of 255 by which a channel may differ, in all but this share of the pixels. Shading is computed in single
  /// precision and rounded to eight bits, which drivers do differently by a level or two; and a pixel through which the
  /// silhouette passes may fall on its other side, so that all of its colour changes: 130 of these 129,600 pixels.
  int tolerance = 3;
  double pixels = 0.001;
};

/// For the name of a test that fails.
std::ostream& operator<<(std::ostream& stream, const GoldenPicture& golden) { return stream << golden.name; }

const std::vector<GoldenPicture> goldens{
    {"straight", {"--frame", "0"}},
    {"half_way", {"--frame", "24"}},
    {"curled", {"--frame", "47"}},
    {"curled_without_bulge", {"--frame", "47", "--bulge", "off"}},
    {"curled_paper", {"--frame", "47", "--bulge", "paper"}},
    {"curled_rigid", {"--frame", "47", "--deformer", "rigid"}},
    // The scene says where its camera stands; here the program frames the arm.
    {"view_front", {"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "--view", "front"}},
    {"view_back", {"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "--view", "back"}},
    {"view_top", {"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "--view", "top"}},
    {"view_left", {"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "--view", "left"}},
    {"view_three_quarter", {"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "--view", "three-quarter"}},
    {"orbit", {"--frame", "30", "--orbit", "20"}},
    {"twisted", {"--frame", "0", "--pose", "leftLowerArm=60,-70,0"}},
    {"shading_flat", {"--frame", "40", "--shading", "flat"}},
    {"shading_clay", {"--frame", "40", "--shading", "clay"}},
    {"shading_normals", {"--frame", "40", "--shading", "normals"}},
    {"shading_bulge", {"--frame", "40", "--shading", "bulge"}},
    {"shading_depth", {"--frame", "40", "--shading", "depth"}},
    // Four samples a pixel put silhouettes between two colours, where a sample that flips changes a quarter of the
    // difference; the share stays as it is, since no more pixels are touched.
    {"smooth_edges", {"--frame", "40", "--samples", "4"}},
    {"transparent", {"--frame", "40", "--background", "transparent"}},
};

fs::path golden_file(const std::string& name) { return fs::path(SINEW_SOURCE_DIR) / "tests/golden" / (name + ".png"); }

Arguments render_words(const Arguments& more, const fs::path& output) {
  Arguments all{"render", "--size", "480x270"};
  all.insert(all.end(), more.begin(), more.end());
  all.insert(all.end(), {"-o", output.string()});
  return all;
}

bool updating() {
  const char* update = std::getenv("SINEW_UPDATE_GOLDENS");
  return update != nullptr && std::string(update) == "1";
}

class Golden : public ProgramTest, public testing::WithParamInterface<GoldenPicture> {};

TEST_P(Golden, IsWhatItWas) {
  const GoldenPicture& golden = GetParam();
  const fs::path kept = golden_file(golden.name);
  if (updating()) {
    fs::create_directories(kept.parent_path());
    const ProgramResult rendered = run(render_words(golden.arguments, kept));
    ASSERT_EQ(rendered.exit_code, 0) << rendered;
    GTEST_SKIP() << "SKIPPED: SINEW_UPDATE_GOLDENS is 1, so " << kept << " was rendered anew and not compared";
  }
  // Beside the test's own folder, so that they can be looked at afterwards.
  const fs::path shown = fs::temp_directory_path() / fmt::format("sinew-golden-{}", getuid());
  fs::create_directories(shown);
  const fs::path now = shown / (golden.name + ".png"), difference = shown / (golden.name + "-difference.png");
  const ProgramResult rendered = run(render_words(golden.arguments, now));
  ASSERT_EQ(rendered.exit_code, 0) << rendered;
  ASSERT_TRUE(fs::exists(kept)) << kept << " is missing. Look at " << now
                                << "; if it is right, keep it and the others that are missing: tools/update_goldens.sh";
  const ProgramResult compared =
      run({"compare", kept.string(), now.string(), "--tolerance", std::to_string(golden.tolerance), "--pixels",
           fmt::format("{}", golden.pixels), "--diff", difference.string()});
  EXPECT_EQ(compared.exit_code, 0) << kept << " and " << now << " differ, see " << difference
                                   << ". If the change is wanted: tools/update_goldens.sh" << compared;
}

INSTANTIATE_TEST_SUITE_P(Embedded, Golden, testing::ValuesIn(goldens),
                         [](const auto& test) { return test.param.name; });

class GoldenFolder : public ProgramTest {};

TEST_F(GoldenFolder, HoldsNothingElse) {
  std::set<std::string> expected, found;
  for (const GoldenPicture& golden : goldens) EXPECT_TRUE(expected.insert(golden.name + ".png").second) << golden.name;
  const fs::path folder = golden_file("").parent_path();
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder)) found.insert(entry.path().filename().string());
  EXPECT_TRUE(std::ranges::includes(expected, found)) << "a picture in " << folder << " belongs to no test";
}

/// A change that must not pass for what it was made of: were the tolerances above too wide, it would.
struct Mutant {
  Arguments original, changed;
};

const std::vector<Mutant> mutants{
    {{"--frame", "47"}, {"--frame", "47", "--bulge", "off"}},
    {{"--frame", "47"}, {"--frame", "47", "--deformer", "rigid"}},
    {{"--frame", "47"}, {"--frame", "47", "--pose", "leftLowerArm=0,-128,0"}},
    {{"--frame", "47"}, {"--frame", "47", "--orbit", "5"}},
    {{"--frame", "47"}, {"--frame", "47", "--view", "top"}},
    {{"--frame", "47"}, {"--frame", "47", "--shading", "normals"}},
    {{"--frame", "47"}, {"--frame", "47", "--shading", "clay"}},
    {{"--frame", "47"}, {"--frame", "47", "--background", "#d0d0d0"}},
    {{"--frame", "47"}, {"--frame", "47", "--background", "transparent"}},
    {{"--frame", "24"}, {"--frame", "23"}},
    // How high the muscle stands is what this shading shows; light on the skin hides a fifth of it.
    {{"--frame", "47", "--shading", "bulge"}, {"--frame", "47", "--shading", "bulge", "--strength", "0.8"}},
};

TEST_F(GoldenFolder, ToleranceTellsMutantsApart) {
  const GoldenPicture limits{};
  for (const Mutant& mutant : mutants) {
    for (const auto& [name, words] : {std::pair{"original.png", mutant.original}, {"changed.png", mutant.changed}}) {
      const ProgramResult rendered = run(render_words(words, path(name)));
      ASSERT_EQ(rendered.exit_code, 0) << rendered;
    }
    const ProgramResult result = run({"compare", "original.png", "changed.png", "--tolerance",
                                      std::to_string(limits.tolerance), "--pixels", fmt::format("{}", limits.pixels)});
    EXPECT_EQ(result.exit_code, 1) << fmt::format("{}", fmt::join(mutant.changed, " ")) << " passes" << result;
  }
}

}  // namespace
}  // namespace sinew::test
