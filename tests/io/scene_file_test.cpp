#include "engine/io/scene_file.h"

#include <sstream>

#include <gtest/gtest.h>

#include "engine/model/scene_words.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

const fs::path scenes = fs::path(SINEW_SOURCE_DIR) / "scenes";

/// A scene with most of what there is.
const std::string example = R"({ "sinew": 1, "fps": 24, "frames": [0, 47],
  "characters": [ {
      "model": "arm.glb", "clip": "Walk", "position": [0, 0, 0], "turn": 0, "count": 1,
      "muscles": [ { "preset": "biceps", "side": "left" },
                   { "name": "calf_r", "bone": "rightLowerLeg", "child": "rightFoot", "driver": "rightFoot",
                     "tip": "rightToes",
                     "facing": [0, 0, -1], "from": 0.1, "to": 0.6, "spread": 60,
                     "peak": 0.012, "sigma": [0.06, 0.03], "rest_angle": 120, "reference_angle": 160 } ],
      "keys": { "leftLowerArm": [ [0, [0, 0, 0]], [24, [0, -120, 0]] ] },
      "expressions": [ [0, "neutral", 1], [12, "laugh", 1] ],
      "regions": { "jaw": [ [0, [0]], [12, [0.4]] ] } } ],
  "camera": { "view": "front", "orbit": 0 }, "look": { "shading": "lit", "background": "#d8d8d8" } })";

/// Everything that a scene can say, in its less usual forms.
const std::string everything = R"({ "sinew": 1, "fps": 29.97, "frames": [10, 10], "library": "/data/motions.db",
  "characters": [
    { "model": "builtin:arm", "clip": 2, "motion": "wave",
      "position": [[0, [0, 0, 0]], [10.5, [0.1, -2, 1e-7]]],
      "turn": {"ease": "step", "keys": [[-3, 0], [0, 90]]},
      "muscles": [ { "preset": "calf", "side": "right", "peak": -0.01, "sigma": [0.1, 0.2], "rest_angle": 115 } ],
      "keys": { "_joint/with~signs": [[0, [1, 2, 3]]],
                "leftHand": {"ease": "smooth", "keys": [[0, [0, 0, 0]], [5, [0, 0, 30]]]} },
      "head": {"age": {"ease": "cubic", "keys": [[0, "child"], [48, 0.1]]}, "skull": "round",
               "measures": {"mouth_width": 0.41}, "level": 1},
      "expressions": {"ease": "smooth", "keys": [[0, "doubt", 0.5], {"expression": "blink", "start": 3, "until": 4,
                      "stop": 5, "fade": 1, "strength": 0.9, "ease": "step"}]},
      "regions": { "browLeft": [[0, [0.1, 0.2, 10]]], "eyeRight": {"ease": "step", "keys": [[0, [10, -5]]]} },
      "emotion": [[12, "laugh", 1], [40, "fear", 0.25]] },
    { "model": "../models/man.glb", "clip": "none", "motion": "run.bvh", "turn": -45, "position": [1, 2, 3] } ],
  "camera": { "view": "three-quarter", "projection": "orthographic", "orbit": [[0, 0], [47, 360]], "target": [0, 1, 0], "distance": 2.5 },
  "look": { "shading": "weights", "joint": "elbow", "shadows": false, "floor": true,
            "background": "transparent", "overlay": ["muscles", "axes"], "compare": "overlay",
            "compare_as": "inset", "zoom": "biceps_left", "plot": "profile", "sheet": [2, 3],
            "captions": ["one", "two"] } })";

Scene parsed(const std::string& text, const fs::path& folder = "/scenes") {
  auto scene = parse_scene(text, "test.json", folder);
  if (!scene) {
    ADD_FAILURE() << scene.error().message;
    return {};
  }
  return *scene;
}

std::string error_of(const std::string& text) {
  const auto scene = parse_scene(text, "test.json", "/scenes");
  if (scene) return "no error";
  EXPECT_EQ(scene.error().kind, ErrorKind::bad_input);
  return scene.error().message;
}

std::string error_of_character(const std::string& members) {
  return error_of(R"({"sinew": 1, "characters": [{"model": "a.glb", )" + members + "}]}");
}

void expect_starts_with(const std::string& message, const std::string& start) {
  EXPECT_EQ(message.substr(0, start.size()), start) << message;
}

std::vector<unsigned char> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

TEST(SceneFile, ReadsTheExampleOfTheManual) {
  const Scene scene = parsed(example);
  EXPECT_EQ(scene.fps, 24);
  EXPECT_EQ(scene.frames, (FrameSpan{0, 47}));
  ASSERT_EQ(scene.characters.size(), 1u);
  const Character& character = scene.characters[0];
  EXPECT_EQ(character.model, "/scenes/arm.glb");
  EXPECT_EQ(std::get<std::string>(*character.clip), "Walk");
  ASSERT_EQ(character.muscles.size(), 2u);
  EXPECT_EQ(muscle_name(character.muscles[0]), "biceps_left");
  EXPECT_EQ(character.muscles[0].peak, std::nullopt);
  const MuscleSpec& calf = character.muscles[1];
  EXPECT_EQ(calf.preset, std::nullopt);
  EXPECT_EQ(calf.name, "calf_r");
  EXPECT_EQ(calf.bone, "rightLowerLeg");
  EXPECT_EQ(calf.child, "rightFoot");
  EXPECT_EQ(calf.driver, "rightFoot");
  EXPECT_EQ(calf.tip, "rightToes");
  EXPECT_EQ(calf.facing, Vec3(0, 0, -1));
  EXPECT_EQ(calf.from, 0.1);
  EXPECT_EQ(calf.to, 0.6);
  EXPECT_EQ(calf.spread, 60);
  EXPECT_EQ(calf.peak, 0.012);
  EXPECT_EQ(calf.sigma, Vec2(0.06, 0.03));
  EXPECT_EQ(calf.rest_angle, 120);
  EXPECT_EQ(calf.reference_angle, 160);
  EXPECT_EQ(character.keys.at("leftLowerArm").value_at(12), Vec3(0, -60, 0));
  EXPECT_EQ(character.expressions->keys[1].value.expression, Expression::laugh);
  EXPECT_DOUBLE_EQ(character.regions.at("jaw").value_at(6).at(0), 0.2);
  EXPECT_EQ(scene.camera.view, View::front);
  EXPECT_EQ(scene.look.background, (Colour{0xd8, 0xd8, 0xd8}));
}

TEST(SceneFile, ReadsWhatIsLessUsual) {
  const Scene scene = parsed(everything);
  const Character& arm = scene.characters.at(0);
  EXPECT_EQ(arm.model, "builtin:arm");
  EXPECT_EQ(std::get<int>(*arm.clip), 2);
  EXPECT_EQ(std::get<LibraryClip>(arm.motion->source).name, "wave");
  EXPECT_EQ(arm.turn.value_at(-0.5), 0);
  EXPECT_EQ(arm.turn.value_at(0), 90);
  EXPECT_TRUE(arm.keys.contains("_joint/with~signs"));
  EXPECT_EQ(arm.head->age, (Keyed<double>{{{0, 0.75}, {48, 0.1}}, Ease::cubic}));
  EXPECT_EQ(arm.head->skull.at("round"), 1.0);
  EXPECT_EQ(arm.head->measures.at("mouth_width"), 0.41);
  EXPECT_EQ(arm.head->level, 1);
  EXPECT_EQ(arm.expressions->ease, Ease::smooth);
  EXPECT_EQ(arm.cues.at(0), (ExpressionCue{"blink", 3, 4, 5, 1, 0.9, Ease::step}));
  EXPECT_EQ(arm.emotion.at(1), (EmotionCue{40, Expression::fear, 0.25}));
  const Character& man = scene.characters.at(1);
  EXPECT_EQ(man.model, "/models/man.glb");
  EXPECT_TRUE(std::holds_alternative<NoClip>(*man.clip));
  EXPECT_EQ(std::get<MotionFile>(man.motion->source).path, "/scenes/run.bvh");
  EXPECT_EQ(man.turn, Keyed<double>::constant(-45));
  EXPECT_EQ(scene.library, "/data/motions.db");
  EXPECT_EQ(scene.camera.orbit.value_at(23.5), 180);
  EXPECT_EQ(scene.camera.projection, Projection::orthographic);
  EXPECT_EQ(scene.look.shading, Shading::weights);
  EXPECT_EQ(scene.look.joint, "elbow");
  EXPECT_FALSE(scene.look.shadows);
  EXPECT_EQ(scene.look.floor, true);
  EXPECT_EQ(scene.look.background.alpha, 0);
  EXPECT_EQ(scene.look.overlay, (std::vector{Overlay::muscles, Overlay::axes}));
  EXPECT_EQ(scene.look.compare, CompareWith::overlay);
  EXPECT_EQ(scene.look.compare_as, ComparisonPlace::inset);
  EXPECT_EQ(scene.look.zoom, "biceps_left");
  EXPECT_EQ(scene.look.plot, MusclePlot::profile);
  EXPECT_EQ(scene.look.sheet, (Grid{2, 3}));
  EXPECT_EQ(scene.look.captions, (std::vector<std::string>{"one", "two"}));
}

TEST(SceneFile, WeightsNeedAJoint) {
  const auto scene = parse_scene(R"({"sinew": 1, "characters": [{"model": "a.glb"}], "look": {"shading": "weights"}})",
                                 "x.json", "/scenes");
  ASSERT_FALSE(scene);
  EXPECT_NE(scene.error().message.find("/look"), std::string::npos) << scene.error().message;
  EXPECT_NE(scene.error().message.find("joint"), std::string::npos) << scene.error().message;
}

TEST(SceneFile, LeavesDefaultsWhereNothingIsSaid) {
  const Scene scene = parsed(R"({"sinew": 1, "characters": [{"model": "a.glb"}]})", "");
  Scene expected;
  expected.characters.resize(1);
  expected.characters[0].model = "a.glb";
  EXPECT_EQ(scene, expected);
}

TEST(SceneFile, AllowsCommentsAndNotes) {
  const Scene scene = parsed(R"(// a scene
    {"$schema": "scene.schema.json", "_": [1], "comment": "x", "sinew": 1, /* here */
     "characters": [{"model": "a.glb", "_todo": 1, "keys": {"_why": "because", "_joint": [[0, [0, 0, 0]]]}}]})");
  EXPECT_EQ(scene.characters.at(0).keys.size(), 1u);
}

TEST(SceneFile, ComesBackAsItWasWritten) {
  for (const std::string& text : {example, everything}) {
    const Scene scene = parsed(text);
    for (const fs::path folder : {"/scenes", "/scenes/deeper", "/elsewhere", "/"}) {
      const std::string written = scene_text(scene, folder);
      EXPECT_EQ(parsed(written, folder), scene) << written;
      EXPECT_EQ(scene_text(parsed(written, folder), folder), written);
    }
  }
}

TEST(SceneFile, AMotionSaysWhenAndHowItPlays) {
  const Scene scene = parsed(R"({"sinew": 1, "characters": [
    {"model": "a.glb", "motion": {"file": "walk", "clip": "Run", "start": 12.5, "speed": 2,
                                  "weight": {"ease": "smooth", "keys": [[0, 0], [9, 1]]}, "keys": "add"}},
    {"model": "a.glb", "motion": {"clip": "a/b.c"}}]})");
  const MotionUse& use = *scene.characters[0].motion;
  EXPECT_EQ(std::get<MotionFile>(use.source), (MotionFile{"/scenes/walk", "Run"}));
  EXPECT_EQ(use.start, 12.5);
  EXPECT_EQ(use.speed, 2.0);
  EXPECT_EQ(use.weight.value_at(4.5), 0.5);
  EXPECT_EQ(use.keys, KeyBlend::add);
  EXPECT_EQ(std::get<LibraryClip>(scene.characters[1].motion->source).name, "a/b.c");
  EXPECT_EQ(parsed(scene_text(scene, "/scenes")), scene);
}

TEST(SceneFile, AMuscleMayBeOff) {
  const std::string calf = R"({"preset": "calf", "side": "left")";
  const auto scene = [&](const std::string& rest) {
    return R"({"sinew": 1, "characters": [{"model": "a", "muscles": [)" + calf + rest + "}]}]}";
  };
  const Scene off = parsed(scene(R"(, "on": false)"));
  EXPECT_FALSE(off.characters[0].muscles[0].on);
  EXPECT_TRUE(parsed(scene("")).characters[0].muscles[0].on);
  EXPECT_EQ(parsed(scene(R"(, "on": true)")), parsed(scene("")));
  EXPECT_EQ(parsed(scene_text(off, "/scenes")), off);
  EXPECT_EQ(error_of(scene(R"(, "on": 0)")), "test.json: /characters/0/muscles/0/on: expected true or false, found 0");
}

TEST(SceneFile, WritesPathsRelativeToItsFolder) {
  Scene scene;
  scene.characters.resize(1);
  scene.characters[0].model = "models/a.glb";
  scene.characters[0].motion = MotionUse{.source = MotionFile{"models/walk", ""}};
  const std::string beside = scene_text(scene, "models");
  EXPECT_NE(beside.find(R"("model": "a.glb")"), std::string::npos) << beside;
  EXPECT_NE(beside.find(R"("motion": "./walk")"), std::string::npos) << beside;
  EXPECT_EQ(parsed(beside, "models"), scene);
  EXPECT_EQ(parsed(scene_text(scene, ""), ""), scene);
  EXPECT_NE(scene_text(scene, fs::current_path() / "models").find(R"("model": "a.glb")"), std::string::npos);
}

TEST(SceneFile, WritesLinesThatPeopleCanRead) {
  const std::string text = scene_text(parsed(everything), "/scenes");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
  EXPECT_NE(text.find("\"frames\": [10, 10],\n"), std::string::npos) << text;
}

TEST(SceneFile, ArmIsOneThatBends) {
  const auto curl = read_scene(scenes / "arm.json");
  ASSERT_TRUE(curl) << curl.error().message;
  EXPECT_EQ(curl->frames, (FrameSpan{0, 47}));
  const Character& arm = curl->characters.at(0);
  EXPECT_EQ(arm.model, "builtin:arm");
  EXPECT_EQ(muscle_name(arm.muscles.at(0)), "biceps_left");
  const auto& elbow = arm.keys.at("leftLowerArm");
  EXPECT_EQ(elbow.value_at(0), Vec3(0));
  EXPECT_EQ(elbow.value_at(47), Vec3(0, -130, 0));
  EXPECT_DOUBLE_EQ(elbow.value_at(23.5).y, -65);
}

TEST(SceneFile, SaysWhereTheTextIsNoJson) {
  expect_starts_with(error_of("{\"sinew\": 1,\n  \"fps\": tru }"), "test.json: line 2, column 13: syntax error");
  const std::string comma = error_of("{\"sinew\": 1,\n}");
  expect_starts_with(comma, "test.json: line 2, column 1: ");
  EXPECT_NE(comma.find("a comma too many"), std::string::npos) << comma;
  expect_starts_with(error_of(""), "test.json: line 1, column 1: ");
  expect_starts_with(error_of("{\"sinew\": 1e999}"), "test.json: line 1, column 15: number overflow");
  expect_starts_with(error_of("{} x"), "test.json: line 1, column 4: ");
  expect_starts_with(error_of("{\"\xff\": 1}"), "test.json: line 1, column 3: ");
  expect_starts_with(error_of(R"({"sinew": 1, "characters": [{"model": "a", "model": "b"}]})"),
                     "test.json: /characters/0/model: the key stands twice");
}

TEST(SceneFile, SurvivesHugeDocuments) {
  const std::string deep = "{\"sinew\": " + std::string(2'000'000, '[');
  EXPECT_NE(error_of(deep).find("nested deeper than 64 levels"), std::string::npos) << error_of(deep);
  EXPECT_FALSE(looks_like_scene(bytes_of(deep.substr(10))));
  const std::string large(std::size_t{100} << 20, ' ');
  EXPECT_NE(error_of(large).find("expected at most 64 MiB"), std::string::npos);
  std::string many = "[0";
  for (int i = 0; i < 9'000'000; ++i) many += ",0";
  EXPECT_NE(error_of(many + "]").find("more than 8000000 values"), std::string::npos);
}

TEST(SceneFile, NamesAFileThatIsMissing) {
  const auto scene = read_scene("no/such/scene.json");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().kind, ErrorKind::bad_input);
  EXPECT_NE(scene.error().message.find("no/such/scene.json"), std::string::npos);
}

// What a schema cannot say; scene_schema_test.cpp has the rest.
TEST(SceneFile, FindsWhatDoesNotFitTogether) {
  const auto refused = [](const std::string& members, const std::string& message) {
    expect_starts_with(error_of_character(members), "test.json: /characters/0/" + message);
  };
  refused(R"("keys": {"a/b": [[5, [0, 0, 0]], [5, [0, 0, 0]]]})", "keys/a~1b/1/0: expected a frame above 5");
  refused(R"("turn": [[0, 1], [-1, 1]])", "turn/1/0: expected a frame above 0");
  refused(R"("expressions": [{"expression": "fear", "start": 9, "until": 8}])", "expressions/0/until: expected 9");
  refused(R"("expressions": [{"expression": "fear", "start": 1, "until": 8, "stop": 7}])",
          "expressions/0/stop: expected 8");
  refused(R"("expressions": [[9, "fear", 1], {"expression": "fear", "start": 1, "until": 8}, [9, "fear", 1]])",
          "expressions/2/0: expected a frame above 9");
  refused(R"("emotion": [[9, "fear", 1], [8, "fear", 1]])", "emotion/1/0: expected a frame above 9");
  refused(R"("muscles": [{"preset": "calf", "side": "left"}, {"preset": "calf", "side": "left"}])",
          "muscles/1: a second muscle \"calf_left\"");
  refused(R"("muscles": [{"preset": "calf", "side": "left"},
                          {"preset": "calf", "side": "right", "name": "calf_left"}])",
          "muscles/1/name: a second muscle \"calf_left\"");
  refused(R"("muscles": [{"preset": "calf", "side": "left", "from": 0.5, "to": 0.5}])",
          "muscles/0/to: expected more than \"from\" (0.5)");
  refused(R"("muscles": [{"preset": "calf", "side": "left", "rest_angle": 90, "reference_angle": 90}])",
          "muscles/0/reference_angle: expected an angle other than");
  refused(R"("muscles": [{"preset": "calf", "side": "left", "facing": [0, 0, 0]}])",
          "muscles/0/facing: expected a direction");
  refused(R"("muscles": [{"preset": "calf", "side": "left", "bone": "a", "child": "a"}])",
          "muscles/0/child: expected another joint");
  expect_starts_with(error_of(R"({"sinew": 1, "frames": [9, 3], "characters": [{"model": "a"}]})"),
                     "test.json: /frames: expected first <= last, found [9, 3]");
}

TEST(SceneFile, SaysWhatWouldBeRight) {
  EXPECT_EQ(error_of_character(R"("muscles": [{"preset": "calf", "side": "left", "from": "a"}])"),
            "test.json: /characters/0/muscles/0/from: expected a number from -1 to 2, found \"a\"");
  EXPECT_EQ(error_of_character(R"("mussels": [])"),
            "test.json: /characters/0/mussels: unknown key (did you mean \"muscles\"?)");
  EXPECT_EQ(error_of_character(R"("expressions": [[0, "lagh", 1]])"),
            "test.json: /characters/0/expressions/0/1: expected one of neutral, smile, laugh, anger, surprise, shout, "
            "fear, sadness, doubt, disgust, found \"lagh\" (did you mean \"laugh\"?)");
  EXPECT_EQ(error_of_character(R"("count": 3)"),
            "test.json: /characters/0/count: crowds do not exist yet, expected 1, found 3");
  EXPECT_EQ(error_of(R"({"sinew": 2, "charakters": []})"),
            "test.json: /sinew: written for a later version (2), expected 1");
  EXPECT_EQ(error_of("[]"), "test.json: the document: expected an object with \"sinew\": 1, found a list of 0");
}

TEST(LooksLikeScene, TellsScenesFromModels) {
  const auto looks = [](const std::string& text) { return looks_like_scene(bytes_of(text)); };
  EXPECT_TRUE(looks(example));
  EXPECT_TRUE(looks("\xef\xbb\xbf // a comment\n {\"_\": {\"asset\": []}, \"sinew\": 7, broken"));
  EXPECT_TRUE(looks(R"({"characters": []})"));
  EXPECT_FALSE(looks(R"({"asset": {"version": "2.0"}, "sinew": 1})"));
  EXPECT_FALSE(looks(R"({"nodes": [{"sinew": 1}]})"));
  EXPECT_FALSE(looks(R"(["sinew"])"));
  EXPECT_FALSE(looks("\"sinew\""));
  EXPECT_FALSE(looks(std::string("glTF\2\0\0\0", 8)));
  EXPECT_FALSE(looks(""));
}

TEST(SceneWords, ReadColours) {
  EXPECT_EQ(parse_colour("#fA0"), (Colour{0xff, 0xaa, 0}));
  EXPECT_EQ(parse_colour("#010203"), (Colour{1, 2, 3}));
  EXPECT_EQ(parse_colour("White"), (Colour{255, 255, 255}));
  EXPECT_EQ(parse_colour("transparent")->alpha, 0);
  for (const char* bad : {"", "#", "#12", "#12345g", "#1234567", "d8d8d8", "pink"}) EXPECT_FALSE(parse_colour(bad));
  EXPECT_EQ(colour_text({1, 2, 255}), "#0102ff");
}

TEST(Keyed, HoldsItsEndsAndEasesBetween) {
  Keyed<double> value{{{10, 1}, {20, 3}}, Ease::linear};
  EXPECT_EQ(value.value_at(-1e9), 1);
  EXPECT_EQ(value.value_at(10), 1);
  EXPECT_EQ(value.value_at(12.5), 1.5);
  EXPECT_EQ(value.value_at(20), 3);
  EXPECT_EQ(value.value_at(1e9), 3);
  value.ease = Ease::smooth;
  EXPECT_DOUBLE_EQ(value.value_at(12.5), 1 + 2 * 0.15625);
  EXPECT_EQ(value.value_at(15), 2);
  value.ease = Ease::step;
  EXPECT_EQ(value.value_at(19.999), 1);
  EXPECT_EQ(value.value_at(20), 3);
  EXPECT_EQ(Keyed<Vec3>::constant({1, 2, 3}).value_at(7), Vec3(1, 2, 3));
}

TEST(Keyed, ACubicIsSmoothThroughItsKeysAndStaysAmongTheirValues) {
  const Keyed<double> value{{{0, 0}, {4, 1}, {10, 9}, {12, 9.5}, {20, 2}}, Ease::cubic};
  for (const auto& key : value.keys) EXPECT_DOUBLE_EQ(value.value_at(key.frame), key.value);
  constexpr double h = 1e-5;
  for (const double frame : {4.0, 10.0, 12.0})
    EXPECT_NEAR(value.value_at(frame) - value.value_at(frame - h), value.value_at(frame + h) - value.value_at(frame),
                1e-8)
        << frame;
  for (std::size_t k = 0; k + 1 < value.keys.size(); ++k)
    for (double t = 0; t <= 1; t += 0.05) {
      const auto &a = value.keys[k], &b = value.keys[k + 1];
      const double v = value.value_at(std::lerp(a.frame, b.frame, t));
      EXPECT_GE(v, std::min(a.value, b.value) - 1e-12);
      EXPECT_LE(v, std::max(a.value, b.value) + 1e-12);
    }
  // Keys on a straight line make it, but for the rest at both ends.
  const Keyed<Vec3> line{{{0, Vec3(0)}, {1, Vec3(1, 2, 3)}, {2, Vec3(2, 4, 6)}, {3, Vec3(3, 6, 9)}}, Ease::cubic};
  EXPECT_NEAR(glm::distance(line.value_at(1.3), 1.3 * Vec3(1, 2, 3)), 0.0, 1e-12);
}

}  // namespace
}  // namespace sinew
