/// Motions in scenes, and what info says of their files.

#include "tests/support/motion_samples.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

/// A body that lifts its left arm from a T pose to straight up within ten frames of 1/24 s.
std::string arm_lift() {
  std::string text = bvh_body();
  text += "MOTION\nFrames: 11\nFrame Time: 0.041666666666666664\n";
  for (int frame = 0; frame <= 10; ++frame) {
    // Hips, spine, neck, head, then the left arm.
    text += "0 90 0  0 0 0  0 0 0  0 0 0  0 0 0  " + std::to_string(9 * frame) + " 0 0";
    for (int joint = 0; joint < 11; ++joint) text += " 0 0 0";
    text += "\n";
  }
  return text;
}

class MotionScene : public ProgramTest {
 protected:
  void scene(const std::string& name, const std::string& rest) const {
    write(name, R"({"sinew": 1, "characters": [{"model": "builtin:figure", )" + rest + "}]}");
  }
  Bytes exported(const std::string& scene, const std::string& frame, const Arguments& more = {}) const {
    Arguments all{"export", scene, "--by", "cpu", "--frame", frame, "-o", "x.ply"};
    all.insert(all.end(), more.begin(), more.end());
    const ProgramResult result = run(all);
    EXPECT_EQ(result.exit_code, 0) << result;
    return read("x.ply");
  }
};

TEST_F(MotionScene, StartSpeedAndWeightPlaceAMotionInTime) {
  write("lift.bvh", arm_lift());
  scene("plain.json", R"("motion": "lift.bvh")");
  scene("late.json", R"("motion": {"file": "lift.bvh", "start": 20, "speed": 0.5})");
  scene("none.json", R"("motion": {"file": "lift.bvh", "weight": 0})");
  scene("rest.json", R"("turn": 0)");
  scene("faded.json", R"("motion": {"file": "lift.bvh", "weight": [[0, 0], [10, 1]]})");
  EXPECT_EQ(json({"info", "plain.json"})["frames"], nlohmann::json({0, 10}));
  EXPECT_EQ(json({"info", "late.json"})["frames"], nlohmann::json({0, 40}));
  const Bytes first = exported("plain.json", "0"), middle = exported("plain.json", "5"),
              last = exported("plain.json", "10");
  EXPECT_NE(first, last);
  EXPECT_NE(middle, last);
  EXPECT_EQ(exported("late.json", "3"), first);    // held before it begins
  EXPECT_EQ(exported("late.json", "30"), middle);  // half its speed
  EXPECT_EQ(exported("plain.json", "99"), last);
  EXPECT_EQ(exported("none.json", "7"), exported("rest.json", "7"));
  EXPECT_EQ(exported("faded.json", "0"), exported("rest.json", "0"));
  EXPECT_EQ(exported("faded.json", "10"), last);
}

TEST_F(MotionScene, KeysReplaceTheMotionOrTurnItFurther) {
  write("lift.bvh", arm_lift());
  const std::string keys = R"(, "keys": {"leftUpperArm": [[0, [0, 0, 0]]]})";
  scene("plain.json", R"("motion": "lift.bvh")");
  scene("replaced.json", R"("motion": "lift.bvh")" + keys);
  scene("added.json", R"("motion": {"file": "lift.bvh", "keys": "add"})" + keys);
  EXPECT_EQ(exported("added.json", "10"), exported("plain.json", "10"));
  EXPECT_EQ(exported("replaced.json", "10"), exported("plain.json", "10", {"--pose", "leftUpperArm=0,0,0"}));
  EXPECT_NE(exported("replaced.json", "10"), exported("plain.json", "10"));
}

TEST_F(MotionScene, InfoDescribesAMotionFile) {
  write("lift.bvh", arm_lift());
  const auto info = json({"info", "lift.bvh"});
  EXPECT_EQ(info["frames"], 11);
  EXPECT_EQ(info["joints"], 16);
  EXPECT_NEAR(info["duration"], 10.0 / 24.0, 1e-6);
  EXPECT_EQ(info["humanoid"]["leftUpperArm"], "LeftArm");
  EXPECT_EQ(info["problems"], nlohmann::json::array());
  EXPECT_NEAR(info["metres_per_unit"], 0.01, 0.001);
}

TEST_F(MotionScene, BadMotionsAreRefusedWithTheirPlace) {
  const auto refused = [&](const std::string& motion, const std::string& part) {
    scene("bad.json", R"("motion": )" + motion);
    const ProgramResult result = run({"info", "bad.json"});
    EXPECT_EQ(result.exit_code, 3) << result;
    EXPECT_NE(result.err.find(part), std::string::npos) << result;
  };
  write("cut.bvh", arm_lift().substr(0, 300));
  refused(R"("gone.bvh")", "/characters/0/motion: ");
  refused(R"("cut.bvh")", "cut.bvh:");
  refused(R"({"file": "cut.bvh", "speed": 0})", "/characters/0/motion/speed");
  refused(R"({"start": 3})", "/characters/0/motion");
  refused(R"("laugh")", "/characters/0/motion: ");
}

}  // namespace
}  // namespace sinew::test
