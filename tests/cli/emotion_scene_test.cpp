/// Emotions in scenes: which clip, when, how much.

#include "tests/support/motion_samples.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

/// A body that bows: the spine turns about x by the given degrees, one a frame of 1/24 s.
std::string bow(const std::vector<int>& degrees) {
  std::string text = bvh_body();
  text += fmt::format("MOTION\nFrames: {}\nFrame Time: 0.041666666666666664\n", degrees.size());
  for (const int angle : degrees) {
    text += fmt::format("0 90 0 0 0 0 0 {} 0", angle);
    for (int joint = 0; joint < 14; ++joint) text += " 0 0 0";
    text += "\n";
  }
  return text;
}

/// Up to 40 degrees at frame 7 of 14 and back.
std::vector<int> nod() { return {0, 2, 6, 14, 24, 34, 38, 40, 38, 34, 24, 14, 6, 2, 0}; }

class EmotionScene : public ProgramTest {
 protected:
  void import(const std::string& name, const std::vector<int>& degrees, const Arguments& more) const {
    write(name + ".bvh", bow(degrees));
    Arguments all{"motion", "import", name + ".bvh", "--library", "m.db"};
    all.insert(all.end(), more.begin(), more.end());
    const ProgramResult result = run(all);
    EXPECT_EQ(result.exit_code, 0) << result;
  }
  void scene(const std::string& name, const std::string& rest) const {
    write(name, R"({"sinew": 1, "library": "m.db", "characters": [{"model": "builtin:figure", )" + rest + "}]}");
  }
  Bytes exported(const std::string& scene, const std::string& frame) const {
    const ProgramResult result = run({"export", scene, "--by", "cpu", "--frame", frame, "-o", "x.ply"});
    EXPECT_EQ(result.exit_code, 0) << result;
    return read("x.ply");
  }
};

TEST_F(EmotionScene, TheClipsApexFallsOnTheFrame) {
  import("bow", nod(), {"--emotion", "sadness"});
  scene("cue.json", R"("emotion": [[40, "sadness", 1]])");
  scene("placed.json", R"("motion": {"clip": "bow", "start": 33})");
  scene("rest.json", R"("turn": 0)");
  scene("half.json", R"("emotion": [[40, "sadness", 0.5]])");
  EXPECT_EQ(exported("cue.json", "40"), exported("placed.json", "40"));
  EXPECT_NE(exported("cue.json", "40"), exported("placed.json", "39"));
  // Blended in before and out after: 0.3 s, not over the apex.
  EXPECT_EQ(exported("cue.json", "30"), exported("rest.json", "30"));
  EXPECT_EQ(exported("cue.json", "50"), exported("rest.json", "50"));
  EXPECT_NE(exported("cue.json", "38"), exported("placed.json", "34"));
  EXPECT_NE(exported("half.json", "40"), exported("cue.json", "40"));
  EXPECT_NE(exported("half.json", "40"), exported("rest.json", "40"));
  EXPECT_EQ(json({"info", "cue.json"})["frames"], nlohmann::json({0, 48}));
}

TEST_F(EmotionScene, OfSeveralClipsTheFirstByNameAndTagsLast) {
  import("b", nod(), {"--emotion", "fear"});
  import("a", {0, 10, 0}, {"--tag", "fear"});
  scene("cue.json", R"("emotion": [[40, "fear", 1]])");
  scene("b.json", R"("motion": {"clip": "b", "start": 33})");
  EXPECT_EQ(exported("cue.json", "40"), exported("b.json", "40"));
  import("aa", {0, -30, 0}, {"--emotion", "fear"});
  scene("aa.json", R"("motion": {"clip": "aa", "start": 39})");
  EXPECT_EQ(exported("cue.json", "40"), exported("aa.json", "40"));
  // An apex that is set.
  EXPECT_EQ(run({"motion", "edit", "aa", "--apex", "0", "--library", "m.db"}).exit_code, 0);
  scene("later.json", R"("motion": {"clip": "aa", "start": 40})");
  EXPECT_EQ(exported("cue.json", "40"), exported("later.json", "40"));
}

TEST_F(EmotionScene, SaysWhichEmotionsThereAre) {
  scene("cue.json", R"("emotion": [[10, "laugh", 1], [40, "fear", 1]])");
  ProgramResult result = run({"info", "cue.json"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("/characters/0/emotion: "), std::string::npos) << result;
  EXPECT_NE(result.err.find("m.db"), std::string::npos) << result;
  import("laughing", nod(), {"--emotion", "laugh"});
  result = run({"info", "cue.json"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("/characters/0/emotion/1: "), std::string::npos) << result;
  EXPECT_NE(result.err.find("no clip shows \"fear\"; there are clips for laugh"), std::string::npos) << result;
}

}  // namespace
}  // namespace sinew::test
