/// Golden pictures of what the thesis on faces claims: one a scene of scenes/face.

#include "tests/support/golden.h"

namespace sinew::test {
namespace {

const std::string folder = "face";

GoldenPicture golden_of(const std::string& scene) {
  // Sheets are white between their pictures. A face is all soft edges of lids, lips and irises, four samples a pixel.
  return {.name = folder + "/" + scene, .arguments = scene_words(folder, scene), .covered = 0.95};
}

class FaceGolden : public GoldenTest, public testing::WithParamInterface<std::string> {};

TEST_P(FaceGolden, IsWhatItWas) { expect_is_what_it_was(golden_of(GetParam())); }

INSTANTIATE_TEST_SUITE_P(Scenes, FaceGolden, testing::ValuesIn(scenes_of(folder)),
                         [](const auto& test) { return "Claim" + test.param; });

class FaceGoldenFolder : public GoldenTest {};

TEST_F(FaceGoldenFolder, HasAPictureOfEverySceneAndNoOther) { EXPECT_EQ(pictures_of(folder), scenes_of(folder)); }

/// What each claim is about must be what its picture is judged by.
TEST_F(FaceGoldenFolder, WhatAFaceShowsIsTold) {
  struct Mutant {
    const char *scene, *was, *is;
  };
  for (const auto& [scene, was, is] :
       {Mutant{"1_skulls", "\"narrow\"", "{\"narrow\": 0.8}"},
        Mutant{"3_expressions", "[8, \"doubt\", 1]", "[8, \"doubt\", 0.8]"},
        Mutant{"4_film_strip", "\"blink\"", "\"neutral\""}, Mutant{"5_ages", "\"infant\"] ]", "0.9] ]"}}) {
    const auto bytes =
        read_file(std::filesystem::path(SINEW_SOURCE_DIR) / "scenes/face" / (std::string(scene) + ".json"));
    ASSERT_TRUE(bytes);
    std::string text(bytes->begin(), bytes->end());
    const std::size_t at = text.find(was);
    ASSERT_NE(at, std::string::npos) << scene;
    text.replace(at, std::string(was).size(), is);
    write("changed.json", text);
    const Arguments original = scene_words(folder, scene);
    Arguments changed = original;
    changed.front() = path("changed.json");
    expect_told_apart(original, changed, golden_of(scene));
  }
}

}  // namespace
}  // namespace sinew::test
