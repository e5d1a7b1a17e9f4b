/// Pictures: which files, the same every time, and known by their recipe.

#include <algorithm>
#include <array>

#include "tests/support/program.h"

namespace sinew::test {
namespace {

class Render : public ProgramTest {
 protected:
  /// The text chunk that says what a picture was made of.
  std::string recipe(const std::string& name) const {
    std::string found;
    for (const PngText& text : picture(name).texts)
      if (text.keyword == "sinew-recipe") {
        EXPECT_EQ(found, "") << name << " has two recipes";
        found = text.text;
      }
    EXPECT_NE(found, "") << name << " has no recipe";
    return found;
  }

  /// Renders frame 30 of the arm or of what the words begin with, small; the file's name is returned.
  std::string render(const std::string& name, const Arguments& more, const ProgramOptions& options = {}) const {
    Arguments all{"render", "-o", name};
    if (more.empty() || more[0].starts_with("-")) all.insert(all.begin() + 1, arm_scene);
    if (std::ranges::find(more, "--size") == more.end()) all.insert(all.end(), {"--size", "160x90"});
    if (std::ranges::find(more, "--frame") == more.end()) all.insert(all.end(), {"--frame", "30"});
    all.insert(all.end(), more.begin(), more.end());
    const ProgramResult result = run(all, options);
    EXPECT_EQ(result.exit_code, 0) << result;
    return name;
  }
};

TEST_F(Render, FramesGoToTheFilesOfThePattern) {
  const auto files = [&](const Arguments& more) {
    const auto before = names();
    Arguments all{"render", arm_scene, "--size", "32x18"};
    all.insert(all.end(), more.begin(), more.end());
    const ProgramResult result = run(all);
    EXPECT_EQ(result.exit_code, 0) << result;
    std::set<std::string> made;
    std::ranges::set_difference(names(), before, std::inserter(made, made.end()));
    for (const std::string& name : made) std::filesystem::remove(path(name));
    return made;
  };
  using Names = std::set<std::string>;
  EXPECT_EQ(files({"--frames", "0-2", "-o", "x_####.png"}), (Names{"x_0000.png", "x_0001.png", "x_0002.png"}));
  EXPECT_EQ(files({"--frames", "0-20:10", "-o", "x_##.png"}), (Names{"x_00.png", "x_10.png", "x_20.png"}));
  EXPECT_EQ(files({"--frames", "1,3,7-9", "-o", "x_##.png"}),
            (Names{"x_01.png", "x_03.png", "x_07.png", "x_08.png", "x_09.png"}));
  EXPECT_EQ(files({"--frames", "99,100", "-o", "##.png"}), (Names{"99.png", "100.png"}));
  EXPECT_EQ(files({"--frame", "7", "-o", "take #3.png"}), (Names{"take #3.png"})) << "a single # is a letter";
  EXPECT_EQ(files({"--frames", "2,2,2", "-o", "x_##.png"}), (Names{"x_02.png"}));
  EXPECT_EQ(files({"--frame", "7", "-o", "x_###.png"}), (Names{"x_007.png"}));
  EXPECT_EQ(files({"--frame", "7", "-o", "x.png"}), (Names{"x.png"}));
  EXPECT_EQ(files({"--frames", "7", "-o", "x.png"}), (Names{"x.png"}));
  EXPECT_EQ(files({"-o", "X.PNG"}), (Names{"X.PNG"}));
  EXPECT_EQ(files({"-o", "x_##.png"}).size(), 48u) << "without a frame named, a pattern takes the whole range";
}

TEST_F(Render, OneNameWithoutAFrameIsTheFirstOfTheRange) {
  const auto report = json({"render", arm_scene, "--size", "32x18", "-o", "x.png"});
  ASSERT_EQ(report["frames"].size(), 1u);
  EXPECT_EQ(report["frames"][0]["frame"], 0);
}

TEST_F(Render, TheSameFrameIsTheSameFile) {
  EXPECT_EQ(read(render("a.png", {})), read(render("b.png", {})));
  EXPECT_EQ(read("a.png"), read(render("a.png", {}))) << "written over itself";
  EXPECT_NE(read("a.png"), read(render("c.png", {"--frame", "31"})));
}

TEST_F(Render, AFrameDoesNotDependOnTheFramesBefore) {
  ASSERT_EQ(run({"render", arm_scene, "--size", "160x90", "--frames", "0-30:15", "-o", "x_##.png"}).exit_code, 0);
  EXPECT_EQ(read("x_30.png"), read(render("alone.png", {})));
}

TEST_F(Render, TheNumberOfThreadsChangesNothing) {
  const Bytes one = read(render("one.png", {}, {.environment = {{"LP_NUM_THREADS", "1"}}}));
  EXPECT_EQ(one, read(render("two.png", {}, {.environment = {{"LP_NUM_THREADS", "2"}}})));
  EXPECT_EQ(one, read(render("all.png", {}, {.environment = {{"LP_NUM_THREADS", std::nullopt}}})));
}

TEST_F(Render, LocaleChangesNothing) {
  EXPECT_EQ(read(render("c.png", {}, {.environment = {{"LC_ALL", "C"}}})),
            read(render("d.png", {}, {.environment = {{"LC_ALL", "de_DE.UTF-8"}}})));
}

TEST_F(Render, TheRecipeIsThatOfThePictureAndNotOfItsPlace) {
  const std::string first = recipe(render("a.png", {}));
  EXPECT_EQ(first.size(), 64u) << first;
  std::filesystem::create_directory(path("folder"));
  EXPECT_EQ(recipe(render("folder/other name.png", {})), first);
  EXPECT_EQ(recipe(render("b.png", {"--device", "0"})), first);
  EXPECT_EQ(recipe(render("c.png", {"--quiet"})), first);
  EXPECT_EQ(recipe(render("d.png", {}, {.environment = {{"LP_NUM_THREADS", "1"}}})), first);
  ASSERT_EQ(run({"render", arm_scene, "--size", "160x90", "--frames", "29-30", "-o", "x_##.png"}).exit_code, 0);
  EXPECT_EQ(recipe("x_30.png"), first) << "of the same frame in a sequence";
}

TEST_F(Render, TheRecipeFollowsTheModelAndNotItsName) {
  arm();
  std::filesystem::create_directory(path("folder"));
  std::filesystem::copy_file(path("arm.glb"), path("folder/copy.glb"));
  EXPECT_EQ(recipe(render("a.png", {"arm.glb"})), recipe(render("b.png", {"folder/copy.glb"})));
}

TEST_F(Render, TheRecipeChangesWithWhatIsShown) {
  const std::vector<Arguments> changes{{},
                                       {"--frame", "31"},
                                       {"--size", "160x91"},
                                       {"--samples", "4"},
                                       {"--pose", "leftLowerArm=0,-10,0"},
                                       {"--pose", "leftLowerArm=0,-11,0"},
                                       {"--bulge", "off"},
                                       {"--bulge", "paper"},
                                       {"--deformer", "rigid"},
                                       {"--strength", "0.5"},
                                       {"--fps", "12"},
                                       {"--view", "top"},
                                       {"--orbit", "10"},
                                       {"--shading", "clay"},
                                       {"--background", "#123456"},
                                       {"--background", "transparent"},
                                       {arm()}};
  std::map<std::string, std::size_t> seen;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const auto [place, is_new] = seen.emplace(recipe(render("x.png", changes[i])), i);
    EXPECT_TRUE(is_new) << "change " << i << " has the recipe of change " << place->second;
  }
}

TEST_F(Render, SizeIsThatOfThePicture) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{17, 301}, std::pair{1000, 3}}) {
    const DecodedPng png = picture(render("x.png", {"--size", fmt::format("{}x{}", width, height)}));
    EXPECT_EQ(png.width, width);
    EXPECT_EQ(png.height, height);
  }
}

TEST_F(Render, BackgroundIsTheColour) {
  const DecodedPng png = picture(render("x.png", {"--background", "#123456"}));
  for (std::size_t corner : {0, 159, 89 * 160, 90 * 160 - 1}) {
    const auto* pixel = &png.rgba[4 * corner];
    EXPECT_EQ((std::array{pixel[0], pixel[1], pixel[2], pixel[3]}),
              (std::array<unsigned char, 4>{0x12, 0x34, 0x56, 255}));
  }
}

TEST_F(Render, TransparentIsOutsideAndOnlyThere) {
  // A floor would shade the other two: only a transparent picture has none unless it is asked for.
  const DecodedPng clear = picture(render("clear.png", {"--background", "transparent"}));
  const DecodedPng solid = picture(render("solid.png", {"--background", "#00ff00", "--floor", "off"}));
  const DecodedPng black = picture(render("black.png", {"--background", "black", "--floor", "off"}));
  std::size_t outside = 0;
  for (std::size_t i = 0; i < clear.rgba.size(); i += 4) {
    const auto same = [&](const DecodedPng& png, std::array<unsigned char, 3> colour) {
      return std::equal(colour.begin(), colour.end(), &png.rgba[i]);
    };
    EXPECT_TRUE(clear.rgba[i + 3] == 0 || clear.rgba[i + 3] == 255) << "one sample is in or out";
    const bool out = clear.rgba[i + 3] == 0;
    outside += out;
    EXPECT_EQ(out, same(solid, {0, 255, 0}) && same(black, {0, 0, 0})) << "pixel " << i / 4;
  }
  EXPECT_GT(outside, clear.rgba.size() / 4 / 3);
  EXPECT_LT(outside, clear.rgba.size() / 4);
}

TEST_F(Render, TransparentFloorIsShadeAlone) {
  // In the rest pose nothing is below the floor.
  const Arguments rest{"builtin:arm", "--frame", "0", "--background", "transparent", "--floor"};
  const auto drawn = [&](const char* floor) {
    Arguments words = rest;
    words.push_back(floor);
    return picture(render(std::string(floor) + ".png", words));
  };
  const DecodedPng clear = drawn("off"), floor = drawn("on");
  std::size_t shaded = 0;
  for (std::size_t i = 0; i < clear.rgba.size(); i += 4) {
    if (clear.rgba[i + 3] != 0) {
      EXPECT_TRUE(std::equal(&clear.rgba[i], &clear.rgba[i] + 4, &floor.rgba[i])) << "pixel " << i / 4;
    } else if (floor.rgba[i + 3] != 0) {
      ++shaded;
      EXPECT_EQ(floor.rgba[i] + floor.rgba[i + 1] + floor.rgba[i + 2], 0) << "pixel " << i / 4;
      EXPECT_LT(floor.rgba[i + 3], 255) << "pixel " << i / 4;
    }
  }
  EXPECT_GT(shaded, clear.rgba.size() / 4 / 100);
}

TEST_F(Render, ShadingsDiffer) {
  std::set<Bytes> pictures;
  for (const char* shading : {"lit", "flat", "clay", "normals", "bulge", "depth"})
    pictures.insert(picture(render("x.png", {"--shading", shading})).rgba);
  EXPECT_EQ(pictures.size(), 6u);
}

}  // namespace
}  // namespace sinew::test
