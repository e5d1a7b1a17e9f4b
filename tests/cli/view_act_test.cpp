/// Faces, joints, limbs, overlays and muscles, edited in a real window. Places are those of a window of 1280x720.

#include "tests/support/view_window.h"

namespace sinew::test {
namespace {

class ViewAct : public View {
 protected:
  /// Opens a model as a scene file of its own, and does what is to be done in the window.
  template <class Act>
  nlohmann::json after(const std::string& model, Act acted, const std::string& more = "") {
    write("scene.json",
          R"({"sinew": 1, "characters": [{"model": ")" + model + '"' + (more.empty() ? "" : ", ") + more + "}]}");
    RunningProgram program({"view", "scene.json", "--size", "1280x720", "--validate"}, in_window());
    wait_for_window();
    acted();
    act("key ctrl+s");
    std::this_thread::sleep_for(1s);
    act("key ctrl+q");
    const ProgramResult result = program.finish();
    EXPECT_EQ(result.exit_code, 0) << result;
    return nlohmann::json::parse(read_text("scene.json"));
  }
  std::string read_text(const std::string& name) const {
    const Bytes bytes = read(name);
    return {bytes.begin(), bytes.end()};
  }
  /// Makes room for the muscles' rows.
  void close_look_and_deformer() const {
    click(150, 122);
    click(150, 149);
  }
  /// The photo beside the scene is what render makes of it.
  void expect_photo_is_rendered() {
    ASSERT_TRUE(appears("scene_0000.png"));
    ASSERT_EQ(run({"render", "scene.json", "--frame", "0", "--size", "1280x720", "-o", "again.png"}).exit_code, 0);
    EXPECT_EQ(picture("scene_0000.png").rgba, picture("again.png").rgba);
  }
};

TEST_F(ViewAct, AFaceIsPulledAndGrowsYounger) {
  const nlohmann::json scene = after("builtin:head", [&] {
    click(1051, 18);                  // Face
    drag(1130, 262, 1130, 284);       // the chin
    drag(994, 384, 1048, 384);        // smile
    drag(994, 534, 1123, 534);        // age
    std::this_thread::sleep_for(8s);  // the head is drawn beside the window
    act("key p");
    std::this_thread::sleep_for(3s);
  });
  const nlohmann::json& character = scene.at("characters").at(0);
  EXPECT_TRUE(character.at("regions").contains("jaw")) << character.dump(2);
  EXPECT_NE(character.at("expressions").dump().find("smile"), std::string::npos) << character.dump(2);
  EXPECT_TRUE(character.at("head").contains("age")) << character.dump(2);
  expect_photo_is_rendered();
}

TEST_F(ViewAct, AJointIsPickedAndTurnedByItsRing) {
  const nlohmann::json scene = after("builtin:woman", [&] {
    click(747, 211);           // the left elbow
    drag(714, 206, 674, 206);  // the front of its y ring
  });
  const nlohmann::json& keys = scene.at("characters").at(0).at("keys");
  ASSERT_EQ(keys.size(), 1u) << keys;
  const nlohmann::json turned = keys.at("l_elbow").at(0).at(1);
  EXPECT_EQ(turned.at(0), 0.0);
  EXPECT_NEAR(turned.at(1).get<double>(), -30.0, 8.0) << "40 pixels of 76";
  EXPECT_EQ(turned.at(2), 0.0);
}

TEST_F(ViewAct, AHandIsPulledAndUndone) {
  const nlohmann::json scene = after("builtin:woman", [&] {
    click(1055, 54);           // reach
    drag(483, 265, 593, 291);  // the right wrist
    act("key p");
    std::this_thread::sleep_for(3s);
    act("key ctrl+s");
    std::this_thread::sleep_for(1s);
    std::filesystem::copy_file(path("scene.json"), path("pulled.json"));
    act("key ctrl+z");
    std::this_thread::sleep_for(500ms);
  });
  EXPECT_FALSE(scene.at("characters").at(0).contains("keys")) << "one undo takes all of it back";
  const nlohmann::json pulled = nlohmann::json::parse(read_text("pulled.json")).at("characters").at(0).at("keys");
  EXPECT_TRUE(pulled.contains("r_shoulder") && pulled.contains("r_elbow")) << pulled;
  std::filesystem::copy_file(path("pulled.json"), path("scene.json"),
                             std::filesystem::copy_options::overwrite_existing);
  expect_photo_is_rendered();
}

TEST_F(ViewAct, OverlaysAreThoseOfRender) {
  const nlohmann::json scene = after("builtin:woman", [&] {
    click(27, 205);   // skeleton
    click(220, 205);  // muscles
    click(27, 230);   // wire
    act("key p");
    std::this_thread::sleep_for(3s);
  });
  EXPECT_EQ(scene.at("look").at("overlay"), (nlohmann::json{"skeleton", "muscles", "wire"}));
  expect_photo_is_rendered();
}

TEST_F(ViewAct, AComparisonIsDividedInTheWindow) {
  const nlohmann::json scene = after("builtin:woman", [&] {
    click(200, 308);           // compare
    click(60, 378);            // deformer
    drag(640, 400, 800, 400);  // the line between the sides does not turn the camera
    act("key p");
    std::this_thread::sleep_for(4s);
  });
  EXPECT_EQ(scene.at("look").at("compare"), "deformer");
  EXPECT_FALSE(scene.contains("camera") && scene.at("camera").contains("distance")) << scene.at("camera");
  expect_photo_is_rendered();
}

TEST_F(ViewAct, AMusclesPeakIsDragged) {
  const nlohmann::json scene = after(
      "builtin:woman",
      [&] {
        close_look_and_deformer();
        click(28, 203);           // the muscle opens, its region shows
        drag(97, 371, 147, 371);  // peak
      },
      R"("muscles": [{"preset": "biceps", "side": "left", "peak": 0.01}])");
  EXPECT_GT(scene.at("characters").at(0).at("muscles").at(0).at("peak").get<double>(), 0.0105);
}

TEST_F(ViewAct, AMuscleIsSwitchedOffAndOthersAreAdded) {
  const nlohmann::json scene = after(
      "builtin:woman",
      [&] {
        close_look_and_deformer();
        click(274, 203);  // the muscle's switch
        click(220, 233);  // all that fit
        act("key p");
        std::this_thread::sleep_for(3s);
      },
      R"("muscles": [{"preset": "biceps", "side": "left"}])");
  const nlohmann::json& muscles = scene.at("characters").at(0).at("muscles");
  ASSERT_EQ(muscles.size(), 16u) << muscles;
  EXPECT_EQ(muscles.at(0).at("on"), false);
  EXPECT_FALSE(muscles.at(1).contains("on"));
  expect_photo_is_rendered();
}

TEST_F(ViewAct, AFaceOfMorphTargetsShowsExpressions) {
  json({"head", "--level", "1", "-o", "head.glb"});
  const nlohmann::json scene = after("head.glb", [&] {
    click(1051, 18);            // Face
    drag(994, 112, 1056, 112);  // smile
    act("key p");
    std::this_thread::sleep_for(3s);
  });
  EXPECT_NE(scene.at("characters").at(0).at("expressions").dump().find("smile"), std::string::npos) << scene.dump(2);
  expect_photo_is_rendered();
}

}  // namespace
}  // namespace sinew::test
