/// What a scene's look asks for is what the options of the same names do, and built-in models stand where files could.

#include "tests/support/program.h"

namespace sinew::test {
namespace {

class SceneLook : public ProgramTest {
 protected:
  /// The picture of a bent arm with this look, as JSON, and these options.
  std::vector<unsigned char> render(const std::string& look, const Arguments& options = {}) const {
    write("arm.json", R"({"sinew": 1, "frames": [0, 3], "characters": [{"model": "builtin:arm",
        "muscles": [{"preset": "biceps", "side": "left"}],
        "keys": {"leftLowerArm": [[0, [0, -90, 0]], [3, [0, -120, 0]]]}}], "look": )" +
                          look + "}");
    Arguments words{"render", "arm.json", "--size", "400x240", "-o", path("look.png"), "--quiet"};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramResult result = run(words);
    EXPECT_EQ(result.exit_code, 0) << result;
    return picture("look.png").rgba;
  }
};

TEST_F(SceneLook, KeysAndOptionsAreTheSame) {
  struct Pair {
    std::string look;
    Arguments options;
  };
  const auto plain = render("{}");
  for (const auto& [look, options] : std::vector<Pair>{
           {R"({"overlay": ["skeleton", "muscles"]})", {"--overlay", "skeleton,muscles"}},
           {R"({"overlay": ["bones"]})", {"--overlay", "bones"}},
           {R"({"overlay": ["arrows"]})", {"--overlay", "arrows"}},
           {R"({"overlay": ["projection"]})", {"--overlay", "projection"}},
           {R"({"compare": "bulge"})", {"--compare", "bulge"}},
           {R"({"compare": "bulge", "compare_as": "inset"})", {"--compare", "bulge", "--compare-as", "inset"}},
           {R"({"overlay": ["bones"], "compare": "overlay"})", {"--overlay", "bones", "--compare", "overlay"}},
           {R"({"zoom": "leftLowerArm"})", {"--zoom", "leftLowerArm"}},
           {R"({"zoom": "biceps_left"})", {"--zoom", "biceps_left"}},
           {R"({"plot": "angle"})", {"--plot", "angle"}},
           {R"({"plot": "profile"})", {"--plot", "profile"}},
           {R"({"sheet": [2, 2]})", {"--sheet", "2x2"}}}) {
    const auto by_look = render(look);
    EXPECT_EQ(by_look, render("{}", options)) << look;
    EXPECT_NE(by_look, plain) << look;
  }
}

TEST_F(SceneLook, OptionsTakeTheScenesWishesAway) {
  const auto plain = render("{}");
  EXPECT_EQ(plain, render(R"({"overlay": ["skeleton", "wire"]})", {"--overlay", "none"}));
  EXPECT_EQ(plain, render(R"({"compare": "bulge"})", {"--compare", "none"}));
  EXPECT_EQ(plain, render(R"({"zoom": "leftHand"})", {"--zoom", "none"}));
  EXPECT_EQ(plain, render(R"({"plot": "angle"})", {"--plot", "none"}));
  EXPECT_EQ(plain, render(R"({"sheet": [2, 2]})", {"--turntable", "1"}));
}

TEST_F(SceneLook, CaptionsStandInPlaceOfFrameNumbers) {
  EXPECT_NE(render(R"({"sheet": [2, 2], "captions": ["one", "two"]})"), render(R"({"sheet": [2, 2]})"));
}

TEST_F(SceneLook, WhatIsNotThereIsNamed) {
  write("man.json", R"({"sinew": 1, "characters": [{"model": "builtin:figure"}], "look": {"plot": "angle"}})");
  const ProgramResult no_muscle = run({"render", "man.json", "-o", "x.png"});
  EXPECT_EQ(no_muscle.exit_code, 3);
  EXPECT_NE(no_muscle.err.find("has no muscle to plot"), std::string::npos) << no_muscle;
  const ProgramResult no_overlay = run({"render", "builtin:arm", "--compare", "overlay", "-o", "x.png"});
  EXPECT_EQ(no_overlay.exit_code, 3);
  EXPECT_NE(no_overlay.err.find("no overlay is drawn"), std::string::npos) << no_overlay;
  const ProgramResult no_model = run({"render", "builtin:wooman", "-o", "x.png"});
  EXPECT_EQ(no_model.exit_code, 3);
  EXPECT_NE(no_model.err.find("did you mean \"builtin:woman\"?"), std::string::npos) << no_model;
  EXPECT_EQ(run({"render", "builtin:arm", "--plot", "angel", "-o", "x.png"}).exit_code, 2);
  EXPECT_EQ(run({"render", "builtin:arm", "--compare-as", "panel", "-o", "x.png"}).exit_code, 2);
  EXPECT_FALSE(names().contains("x.png"));
}

TEST_F(SceneLook, ABuiltInFigureIsTheOneThatTheCommandWrites) {
  ASSERT_EQ(run({"figure", "--like", "woman", "-o", "woman.glb"}).exit_code, 0);
  const auto rendered = [&](const std::string& model) {
    const ProgramResult result = run({"render", model, "--size", "160x90", "-o", path("a.png"), "--quiet"});
    EXPECT_EQ(result.exit_code, 0) << result;
    return picture("a.png");
  };
  const DecodedPng built_in = rendered("builtin:woman"), from_file = rendered("woman.glb");
  // A file holds single precision: here and there a pixel's edge or a level of its colour.
  ASSERT_EQ(built_in.rgba.size(), from_file.rgba.size());
  std::size_t far_off = 0;
  for (std::size_t i = 0; i < built_in.rgba.size(); ++i)
    far_off += std::abs(int(built_in.rgba[i]) - int(from_file.rgba[i])) > 3 ? 1 : 0;
  EXPECT_LT(far_off, built_in.rgba.size() / 500);
}

}  // namespace
}  // namespace sinew::test
