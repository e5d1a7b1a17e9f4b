#include "tests/support/golden.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ostream>

namespace sinew::test {

namespace fs = std::filesystem;

namespace {

bool updating() {
  const char* update = std::getenv("SINEW_UPDATE_GOLDENS");
  return update != nullptr && std::string(update) == "1";
}

}  // namespace

std::ostream& operator<<(std::ostream& stream, const GoldenPicture& golden) { return stream << golden.name; }

fs::path golden_file(const std::string& name) { return fs::path(SINEW_SOURCE_DIR) / "tests/golden" / (name + ".png"); }

Arguments render_words(const Arguments& more, const fs::path& output) {
  Arguments all{"render", "--size", "480x270"};
  all.insert(all.end(), more.begin(), more.end());
  // Only what is drawn stands out from a background of one colour.
  if (std::ranges::find(more, "--floor") == more.end()) all.insert(all.end(), {"--floor", "off"});
  all.insert(all.end(), {"-o", output.string()});
  return all;
}

namespace {

std::vector<std::string> stems(const fs::path& folder, const char* ending) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ending) names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

fs::path scene_folder(const std::string& folder) { return fs::path(SINEW_SOURCE_DIR) / "scenes" / folder; }

}  // namespace

std::vector<std::string> scenes_of(const std::string& folder) { return stems(scene_folder(folder), ".json"); }

std::vector<std::string> pictures_of(const std::string& folder) {
  return stems(golden_file(folder + "/").parent_path(), ".png");
}

Arguments scene_words(const std::string& folder, const std::string& scene, const Arguments& more) {
  Arguments words{(scene_folder(folder) / (scene + ".json")).string(), "--samples", "4"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Drawn drawn(const DecodedPng& png, bool transparent) {
  std::size_t pixels = 0;
  std::set<std::array<unsigned char, 3>> colours;
  for (std::size_t i = 0; i < png.rgba.size(); i += 4) {
    const std::array<unsigned char, 3> colour{png.rgba[i], png.rgba[i + 1], png.rgba[i + 2]};
    if (transparent ? png.rgba[i + 3] == 0 : colour == std::array<unsigned char, 3>{0xd8, 0xd8, 0xd8}) continue;
    ++pixels;
    colours.insert(colour);
  }
  return {double(pixels) / (double(png.width) * png.height), colours.size()};
}

void expect_something_drawn(const fs::path& file, const GoldenPicture& golden) {
  const auto bytes = read_file(file);
  ASSERT_TRUE(bytes) << bytes.error().message;
  const auto png = decode_png(*bytes);
  ASSERT_TRUE(png) << file << ": " << png.error().message;
  EXPECT_EQ(png->width, 480) << file;
  EXPECT_EQ(png->height, 270) << file;
  const Drawn found = drawn(*png, std::ranges::find(golden.arguments, "transparent") != golden.arguments.end());
  EXPECT_GE(found.covered, least_covered) << file;
  EXPECT_LE(found.covered, golden.covered) << file;
  EXPECT_GE(found.colours, golden.colours) << file;
}

Judgement GoldenTest::judge(const fs::path& a, const fs::path& b, const GoldenPicture& limits,
                            const fs::path& difference) const {
  return {run({"compare", a.string(), b.string(), "--tolerance", std::to_string(limits.tolerance), "--pixels",
               fmt::format("{}", limits.pixels), "--diff", difference.string()}),
          run({"compare", a.string(), b.string(), "--metric", "flip", "--threshold", fmt::format("{}", limits.flip)})};
}

void GoldenTest::expect_is_what_it_was(const GoldenPicture& golden) const {
  const fs::path kept = golden_file(golden.name);
  if (updating()) {
    fs::create_directories(kept.parent_path());
    const ProgramResult rendered = run(render_words(golden.arguments, kept));
    ASSERT_EQ(rendered.exit_code, 0) << rendered;
    GTEST_SKIP() << "SKIPPED: SINEW_UPDATE_GOLDENS is 1, so " << kept << " was rendered anew and not compared";
  }
  // Beside the test's own folder, so that they can be looked at afterwards.
  const fs::path shown = fs::temp_directory_path() / fmt::format("sinew-golden-{}", getuid());
  const fs::path now = shown / (golden.name + ".png"), difference = shown / (golden.name + "-difference.png");
  fs::create_directories(now.parent_path());
  const ProgramResult rendered = run(render_words(golden.arguments, now));
  ASSERT_EQ(rendered.exit_code, 0) << rendered;
  ASSERT_TRUE(fs::exists(kept)) << kept << " is missing. Look at " << now
                                << "; if it is right, keep it and the others that are missing: tools/update_goldens.sh";
  expect_something_drawn(kept, golden);
  expect_something_drawn(now, golden);
  const Judgement judged = judge(kept, now, golden, difference);
  EXPECT_TRUE(judged.same()) << kept << " and " << now << " differ, see " << difference
                             << ". If the change is wanted: tools/update_goldens.sh" << judged.pixels << judged.flip;
}

void GoldenTest::expect_told_apart(const Arguments& original, const Arguments& changed,
                                   const GoldenPicture& limits) const {
  for (const auto& [name, words] : {std::pair{"original.png", original}, {"changed.png", changed}}) {
    const ProgramResult rendered = run(render_words(words, path(name)));
    ASSERT_EQ(rendered.exit_code, 0) << rendered;
  }
  const Judgement judged = judge(path("original.png"), path("changed.png"), limits, path("difference.png"));
  EXPECT_TRUE(judged.different()) << fmt::format("{}", fmt::join(changed, " ")) << " passes" << judged.pixels
                                  << judged.flip;
}

}  // namespace sinew::test
