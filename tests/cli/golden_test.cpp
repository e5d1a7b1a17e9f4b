/// Golden pictures of the arm.

#include <algorithm>

#include "tests/support/glb.h"
#include "tests/support/golden.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

/// The floor is seen where it is shaded: soft shadows are a good deal wider than what throws them.
GoldenPicture on_floor(std::string name, Arguments arguments) {
  arguments.insert(arguments.end(), {"--floor", "on"});
  return {.name = std::move(name), .arguments = std::move(arguments), .covered = 0.6};
}

const std::vector<GoldenPicture> goldens{
    // The embedded scene.
    {"embedded", {std::string(SINEW_SOURCE_DIR) + "/scenes/curl.json", "--frame", "47"}},
    {"straight", {arm_scene, "--frame", "0"}},
    {"half_way", {arm_scene, "--frame", "24"}},
    {"curled", {arm_scene, "--frame", "47"}},
    {"curled_without_bulge", {arm_scene, "--frame", "47", "--bulge", "off"}},
    {"curled_paper", {arm_scene, "--frame", "47", "--bulge", "paper"}},
    {"curled_rigid", {arm_scene, "--frame", "47", "--deformer", "rigid"}},
    // The scene says where its camera stands; here the program frames the arm.
    {"view_front", {"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "--view", "front"}},
    {"view_back", {"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "--view", "back"}},
    {"view_top", {"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "--view", "top"}},
    {"view_left", {"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "--view", "left"}},
    {"view_three_quarter", {"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "--view", "three-quarter"}},
    {"orbit", {arm_scene, "--frame", "30", "--orbit", "20"}},
    {"twisted", {arm_scene, "--frame", "0", "--pose", "leftLowerArm=60,-70,0"}},
    {"shading_flat", {arm_scene, "--frame", "40", "--shading", "flat"}},
    {"shading_clay", {arm_scene, "--frame", "40", "--shading", "clay"}},
    {"shading_normals", {arm_scene, "--frame", "40", "--shading", "normals"}},
    {"shading_bulge", {arm_scene, "--frame", "40", "--shading", "bulge"}},
    {"shading_weights", {arm_scene, "--frame", "40", "--shading", "weights", "--joint", "leftLowerArm"}},
    // An arm is not deep: three dozen greys.
    {.name = "shading_depth", .arguments = {arm_scene, "--frame", "40", "--shading", "depth"}, .colours = 20},
    // Four samples a pixel put silhouettes between two colours, where a sample that flips changes a quarter of the
    // difference; the share stays as it is, since no more pixels are touched.
    {"smooth_edges", {arm_scene, "--frame", "40", "--samples", "4"}},
    {"transparent", {arm_scene, "--frame", "40", "--background", "transparent"}},
    {"without_shadows", {arm_scene, "--frame", "40", "--shadows", "off"}},
    on_floor("floor", {arm_scene, "--frame", "40"}),
    on_floor("floor_from_above", {"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "--view", "three-quarter"}),
    on_floor("floor_without_shadows", {arm_scene, "--frame", "40", "--shadows", "off"}),
    // Lines are drawn with soft edges, whose shares of a pixel are rounded to 255ths before they are blended.
    {"wire", {arm_scene, "--frame", "40", "--overlay", "wire"}},
    {"wire_all", {arm_scene, "--frame", "40", "--overlay", "wire-all"}},
};

class Golden : public GoldenTest, public testing::WithParamInterface<GoldenPicture> {};

TEST_P(Golden, IsWhatItWas) { expect_is_what_it_was(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Embedded, Golden, testing::ValuesIn(goldens),
                         [](const auto& test) { return test.param.name; });

class GoldenFolder : public GoldenTest {};

TEST_F(GoldenFolder, HoldsNothingElse) {
  std::set<std::string> expected, found;
  for (const GoldenPicture& golden : goldens) EXPECT_TRUE(expected.insert(golden.name + ".png").second) << golden.name;
  const fs::path folder = golden_file("").parent_path();
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.is_regular_file()) found.insert(entry.path().filename().string());
  EXPECT_TRUE(std::ranges::includes(expected, found)) << "a picture in " << folder << " belongs to no test";
}

/// See GoldenTest::expect_told_apart.
struct Mutant {
  Arguments original, changed;
};

const std::vector<Mutant> mutants{
    {{arm_scene, "--frame", "47"}, {arm_scene, "--frame", "47", "--bulge", "off"}},
    {{arm_scene, "--frame", "47"}, {arm_scene, "--frame", "47", "--deformer", "rigid"}},
    {{arm_scene, "--frame", "47"}, {arm_scene, "--frame", "47", "--pose", "leftLowerArm=0,-128,0"}},
    {{arm_scene, "--frame", "47"}, {arm_scene, "--frame", "47", "--orbit", "5"}},
    {{arm_scene, "--frame", "47"}, {arm_scene, "--frame", "47", "--view", "top"}},
    {{arm_scene, "--frame", "47"}, {arm_scene, "--frame", "47", "--shading", "normals"}},
    {{arm_scene, "--frame", "47"}, {arm_scene, "--frame", "47", "--shading", "clay"}},
    {{arm_scene, "--frame", "47"}, {arm_scene, "--frame", "47", "--background", "#d0d0d0"}},
    {{arm_scene, "--frame", "40"}, {arm_scene, "--frame", "40", "--shadows", "off"}},
    {{arm_scene, "--frame", "40", "--floor", "on"}, {arm_scene, "--frame", "40", "--floor", "on", "--shadows", "off"}},
    {{arm_scene, "--frame", "40", "--overlay", "wire"}, {arm_scene, "--frame", "40", "--overlay", "wire-all"}},
    {{arm_scene, "--frame", "47"}, {arm_scene, "--frame", "47", "--background", "transparent"}},
    {{arm_scene, "--frame", "24"}, {arm_scene, "--frame", "23"}},
    // How high the muscle stands is what this shading shows; light on the skin hides a fifth of it.
    {{arm_scene, "--frame", "47", "--shading", "bulge"},
     {arm_scene, "--frame", "47", "--shading", "bulge", "--strength", "0.8"}},
};

TEST_F(GoldenFolder, ToleranceTellsMutantsApart) {
  for (const Mutant& mutant : mutants) expect_told_apart(mutant.original, mutant.changed, {});
}

/// The arm's file with every normal turned round.
void flip_normals(Bytes& glb) {
  const std::size_t data = 20 + glb_word(glb, 12) + 8;
  const nlohmann::json json = glb_json(glb);
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
  EXPECT_GT(drawn(painted(0), false).covered, GoldenPicture{}.covered);
  EXPECT_LT(drawn(painted(0), false).colours, 2u);
}

}  // namespace
}  // namespace sinew::test
