/// Pictures of the embedded scene against those that were looked at and kept in tests/golden, by `sinew compare`.

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <ostream>

#include "tests/support/program.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

/// Of the whole picture, that what is drawn covers. An empty picture has 0, a black or filled one 1.
constexpr double least_covered = 0.03, most_covered = 0.2;

struct GoldenPicture {
  std::string name;
  Arguments arguments;
  /// Levels of 255 by which a channel may differ, in all but this share of the pixels. Shading is computed in single
  /// precision and rounded to eight bits, which drivers do differently by a level or two; and a pixel through which the
  /// silhouette passes may fall on its other side, so that all of its colour changes: 130 of these 129,600 pixels.
  int tolerance = 3;
  double pixels = 0.001;
  /// Mean FLIP: what is left where every drawn pixel, one in thirteen, is off by one level.
  double flip = 0.002;
  /// Colours of what is drawn, at least: light, texture and smooth normals make hundreds. A silhouette has one.
  std::size_t colours = 300;
  /// Of the whole picture, that what is drawn covers at most: the arm takes 0.04 to 0.1 in these views.
  double covered = most_covered;
};

/// The floor is seen where it is shaded: soft shadows are a good deal wider than what throws them.
GoldenPicture on_floor(std::string name, Arguments arguments) {
  arguments.insert(arguments.end(), {"--floor", "on"});
  return {.name = std::move(name), .arguments = std::move(arguments), .covered = 0.6};
}

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
    {"shading_weights", {"--frame", "40", "--shading", "weights", "--joint", "leftLowerArm"}},
    // An arm is not deep: three dozen greys.
    {.name = "shading_depth", .arguments = {"--frame", "40", "--shading", "depth"}, .colours = 20},
    // Four samples a pixel put silhouettes between two colours, where a sample that flips changes a quarter of the
    // difference; the share stays as it is, since no more pixels are touched.
    {"smooth_edges", {"--frame", "40", "--samples", "4"}},
    {"transparent", {"--frame", "40", "--background", "transparent"}},
    {"without_shadows", {"--frame", "40", "--shadows", "off"}},
    on_floor("floor", {"--frame", "40"}),
    on_floor("floor_from_above", {"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "--view", "three-quarter"}),
    on_floor("floor_without_shadows", {"--frame", "40", "--shadows", "off"}),
    // Lines are drawn with soft edges, whose shares of a pixel are rounded to 255ths before they are blended.
    {"wire", {"--frame", "40", "--overlay", "wire"}},
    {"wire_all", {"--frame", "40", "--overlay", "wire-all"}},
};

fs::path golden_file(const std::string& name) { return fs::path(SINEW_SOURCE_DIR) / "tests/golden" / (name + ".png"); }

Arguments render_words(const Arguments& more, const fs::path& output) {
  Arguments all{"render", "--size", "480x270"};
  all.insert(all.end(), more.begin(), more.end());
  // Only what is drawn stands out from a background of one colour.
  if (std::ranges::find(more, "--floor") == more.end()) all.insert(all.end(), {"--floor", "off"});
  all.insert(all.end(), {"-o", output.string()});
  return all;
}

/// What is not background: how much of the picture, and in how many colours.
struct Drawn {
  double covered = 0.0;
  std::size_t colours = 0;
};

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

/// Whether two pictures are told apart by the limits.
struct Judgement {
  ProgramResult pixels, flip;
  bool same() const { return pixels.exit_code == 0 && flip.exit_code == 0; }
  bool different() const { return pixels.exit_code == 1 || flip.exit_code == 1; }
};

bool updating() {
  const char* update = std::getenv("SINEW_UPDATE_GOLDENS");
  return update != nullptr && std::string(update) == "1";
}

class GoldenTest : public ProgramTest {
 protected:
  Judgement judge(const fs::path& a, const fs::path& b, const GoldenPicture& limits, const fs::path& difference) const {
    return {
        run({"compare", a.string(), b.string(), "--tolerance", std::to_string(limits.tolerance), "--pixels",
             fmt::format("{}", limits.pixels), "--diff", difference.string()}),
        run({"compare", a.string(), b.string(), "--metric", "flip", "--threshold", fmt::format("{}", limits.flip)})};
  }
};

class Golden : public GoldenTest, public testing::WithParamInterface<GoldenPicture> {};

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
  expect_something_drawn(kept, golden);
  expect_something_drawn(now, golden);
  const Judgement judged = judge(kept, now, golden, difference);
  EXPECT_TRUE(judged.same()) << kept << " and " << now << " differ, see " << difference
                             << ". If the change is wanted: tools/update_goldens.sh" << judged.pixels << judged.flip;
}

INSTANTIATE_TEST_SUITE_P(Embedded, Golden, testing::ValuesIn(goldens),
                         [](const auto& test) { return test.param.name; });

class GoldenFolder : public GoldenTest {};

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
    {{"--frame", "40"}, {"--frame", "40", "--shadows", "off"}},
    {{"--frame", "40", "--floor", "on"}, {"--frame", "40", "--floor", "on", "--shadows", "off"}},
    {{"--frame", "40", "--overlay", "wire"}, {"--frame", "40", "--overlay", "wire-all"}},
    {{"--frame", "47"}, {"--frame", "47", "--background", "transparent"}},
    {{"--frame", "24"}, {"--frame", "23"}},
    // How high the muscle stands is what this shading shows; light on the skin hides a fifth of it.
    {{"--frame", "47", "--shading", "bulge"}, {"--frame", "47", "--shading", "bulge", "--strength", "0.8"}},
};

TEST_F(GoldenFolder, ToleranceTellsMutantsApart) {
  for (const Mutant& mutant : mutants) {
    for (const auto& [name, words] : {std::pair{"original.png", mutant.original}, {"changed.png", mutant.changed}}) {
      const ProgramResult rendered = run(render_words(words, path(name)));
      ASSERT_EQ(rendered.exit_code, 0) << rendered;
    }
    const Judgement judged = judge(path("original.png"), path("changed.png"), {}, path("difference.png"));
    EXPECT_TRUE(judged.different()) << fmt::format("{}", fmt::join(mutant.changed, " ")) << " passes" << judged.pixels
                                    << judged.flip;
  }
}

/// The arm's file with every normal turned round.
void flip_normals(Bytes& glb) {
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, &glb[at], 4);
    return std::size_t{value};
  };
  const std::size_t json_size = word(12), data = 20 + json_size + 8;
  const auto json = nlohmann::json::parse(glb.begin() + 20, glb.begin() + 20 + static_cast<std::ptrdiff_t>(json_size));
  for (const auto& mesh : json.at("meshes"))
    for (const auto& primitive : mesh.at("primitives")) {
      const auto& accessor = json.at("accessors").at(primitive.at("attributes").at("NORMAL").get<std::size_t>());
      const auto& view = json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
      const std::size_t first =
          data + view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
      const std::size_t stride = view.value("byteStride", std::size_t{12});
      for (std::size_t i = 0; i < accessor.at("count").get<std::size_t>(); ++i)
        // The sign is the highest bit of each of the three little-endian floats.
        for (std::size_t c = 0; c < 3; ++c) glb[first + i * stride + 4 * c + 3] ^= 0x80;
    }
}

TEST_F(GoldenFolder, NormalsTurnedRoundAreTold) {
  arm();
  Bytes glb = read("arm.glb");
  flip_normals(glb);
  ASSERT_TRUE(write_file(path("turned.glb"), glb));
  for (const char* name : {"arm", "turned"}) {
    const ProgramResult rendered = run(
        render_words({std::string(name) + ".glb", "--pose", "leftLowerArm=0,-90,0"}, path(std::string(name) + ".png")));
    ASSERT_EQ(rendered.exit_code, 0) << rendered;
  }
  const Judgement judged = judge(path("arm.png"), path("turned.png"), {}, path("difference.png"));
  EXPECT_EQ(judged.pixels.exit_code, 1) << judged.pixels;
  EXPECT_EQ(judged.flip.exit_code, 1) << judged.flip;
}

TEST_F(GoldenFolder, ACameraThatMovedAPixelIsTold) {
  for (const auto& [name, x] : {std::pair{"still", 0.35}, {"moved", 0.3525}}) {
    // 1.3 away at 30 degrees high, 270 pixels are 0.697: the target moves by one.
    write(std::string(name) + ".json", fmt::format(R"({{"sinew": 1, "characters": [{{"model": "builtin:arm"}}],
                          "camera": {{"view": "front", "target": [{}, 0, 0], "distance": 1.3}}}})",
                                                   x));
    const ProgramResult rendered =
        run(render_words({std::string(name) + ".json", "--frame", "0"}, path(std::string(name) + ".png")));
    ASSERT_EQ(rendered.exit_code, 0) << rendered;
  }
  const Judgement judged = judge(path("still.png"), path("moved.png"), {}, path("difference.png"));
  EXPECT_EQ(judged.pixels.exit_code, 1) << judged.pixels;
  EXPECT_EQ(judged.flip.exit_code, 1) << judged.flip;
}

TEST_F(GoldenFolder, WhatIsEmptyOrFilledIsTold) {
  // No camera that looks past the arm, no failed draw and no picture of one colour can become a golden one.
  const auto painted = [](unsigned char value) {
    DecodedPng png;
    png.width = 480;
    png.height = 270;
    png.rgba.assign(std::size_t{480} * 270 * 4, value);
    return png;
  };
  EXPECT_LT(drawn(painted(0xd8), false).covered, least_covered);
  EXPECT_LT(drawn(painted(0), true).covered, least_covered);
  EXPECT_GT(drawn(painted(0), false).covered, most_covered);
  EXPECT_LT(drawn(painted(0), false).colours, 2u);
}

}  // namespace
}  // namespace sinew::test
