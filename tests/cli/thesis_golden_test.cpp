/// Golden pictures of the thesis' figures: one a scene of scenes/thesis.

#include <algorithm>

#include "tests/support/golden.h"

namespace sinew::test {
namespace {

const std::string folder = "thesis";

Arguments figure_words(const std::string& scene, const Arguments& more = {}) {
  Arguments words = scene_words(folder, scene, {"--floor", "on"});
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

GoldenPicture golden_of(const std::string& scene) {
  // A near view of an arm, or panels with white between them, leave a fifth of the picture to the background. The
  // figures have more outline than the arm, but four samples a pixel: what falls on the other side of it changes a
  // pixel by a quarter, so the share of pixels stays.
  return {.name = folder + "/" + scene, .arguments = figure_words(scene), .covered = 0.95};
}

class ThesisGolden : public GoldenTest, public testing::WithParamInterface<std::string> {};

TEST_P(ThesisGolden, IsWhatItWas) { expect_is_what_it_was(golden_of(GetParam())); }

INSTANTIATE_TEST_SUITE_P(Scenes, ThesisGolden, testing::ValuesIn(scenes_of(folder)),
                         [](const auto& test) { return "Figure" + test.param; });

class ThesisGoldenFolder : public GoldenTest {};

TEST_F(ThesisGoldenFolder, HasAPictureOfEverySceneAndNoOther) { EXPECT_EQ(pictures_of(folder), scenes_of(folder)); }

/// Figures 4.2 to 4.12 in every number, and what chapter 3 explains.
TEST_F(ThesisGoldenFolder, EveryFigureHasAScene) {
  const std::vector<std::string> names = scenes_of(folder);
  for (const char* figure : {"3_06", "3_10", "3_14", "3_15", "3_16", "3_17", "4_01", "4_02", "4_03", "4_04", "4_05",
                             "4_06", "4_07", "4_08", "4_09", "4_10", "4_11", "4_12"})
    EXPECT_EQ(std::ranges::count_if(names, [&](const std::string& name) { return name.starts_with(figure); }), 1)
        << figure;
}

/// What each figure is there to show must be what its picture is judged by.
TEST_F(ThesisGoldenFolder, WhatAFigureShowsIsTold) {
  struct Mutant {
    std::string scene;
    Arguments changed;
  };
  for (const auto& [scene, changed] :
       std::vector<Mutant>{// Where a comparison shows the bulge anyway, muscles without strength take it away.
                           {"4_03_elbow_150_bulge", {"--strength", "0"}},
                           {"4_05_elbow_100_bulge", {"--strength", "0"}},
                           {"4_07_elbow_55_bulge", {"--strength", "0"}},
                           {"4_07_elbow_55_bulge", {"--compare-as", "panels"}},
                           {"4_07_elbow_55_bulge", {"--zoom", "none"}},
                           {"4_08_calf", {"--strength", "0"}},
                           {"4_10_double_biceps", {"--bulge", "off"}},
                           {"4_02_elbow_150_skeleton", {"--overlay", "skeleton"}},
                           {"3_10_rigid_and_smooth", {"--compare", "none"}},
                           {"3_14_normals_of_the_region", {"--overlay", "muscles"}},
                           {"3_15_projection_plane", {"--overlay", "none"}},
                           {"3_16_gaussian", {"--strength", "0.9"}},
                           {"3_16_gaussian", {"--plot", "none"}},
                           {"3_17_bulge_by_angle", {"--plot", "profile"}}})
    expect_told_apart(figure_words(scene), figure_words(scene, changed), golden_of(scene));
}

}  // namespace
}  // namespace sinew::test
