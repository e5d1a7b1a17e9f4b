/// The schema that editors use and the reader that the program uses must agree.

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "engine/io/scene_file.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const fs::path scenes = fs::path(SINEW_SOURCE_DIR) / "scenes";

json read_json(const fs::path& file) {
  std::ifstream in(file);
  return json::parse(in, nullptr, true, true);
}

class SceneSchema : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const json document = read_json(scenes / "scene.schema.json");
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema());
  }

  static bool accepts(const json& scene) {
    // Weak types would let the text "1" pass for the number.
    valijson::Validator validator(valijson::Validator::kStrongTypes);
    return validator.validate(schema(), valijson::adapters::NlohmannJsonAdapter(scene), nullptr);
  }

 private:
  static valijson::Schema& schema() {
    static valijson::Schema one;
    return one;
  }
};

/// A whole scene around the members of its one character.
std::string with_character(const std::string& members) {
  return R"({"sinew": 1, "characters": [{"model": "a.glb", )" + members + "}]}";
}
std::string with_muscle(const std::string& muscle) { return with_character(R"("muscles": [)" + muscle + "]"); }
std::string with_preset(const std::string& members) {
  return with_muscle(R"({"preset": "biceps", "side": "left", )" + members + "}");
}
std::string with_top(const std::string& members) {
  return R"({"sinew": 1, "characters": [{"model": "a.glb"}], )" + members + "}";
}

const std::string whole_muscle =
    R"({"name": "m", "bone": "a", "child": "b", "facing": [0, 0, 1], "from": 0, "to": 1, "spread": 60, "peak": 0.1,
        "sigma": [0.1, 0.1], "reference_angle": 40)";

TEST_F(SceneSchema, AcceptsWhatTheReaderAccepts) {
  for (const std::string& good : std::vector<std::string>{
           with_character(R"("clip": "Walk")"),
           with_character(R"("clip": 0)"),
           with_character(R"("clip": "none", "motion": "walk", "count": 1)"),
           with_character(R"("motion": {"file": "a.bvh"})"),
           with_character(R"("motion": {"clip": "laugh", "start": -3.5, "speed": 2, "weight": 0.5, "keys": "add"})"),
           with_character(R"("motion": {"file": "a.glb", "clip": "Run", "weight": [[0, 0], [9, 1]], "_why": "fast"})"),
           with_character(R"("motion": {"file": "a", "weight": {"ease": "smooth", "keys": [[0, 0], [9, 1]]}})"),
           with_character(R"("position": [1, 2.5, -3], "turn": 45)"),
           with_character(R"("position": [[0, [1, 2, 3]], [1.5, [1, 2, 3]]], "turn": [[-4, 45]])"),
           with_character(R"("position": {"ease": "step", "keys": [[0, [1, 2, 3]]]}, "turn": {"keys": [[0, 0]]})"),
           with_character(R"("keys": {"leftHand": [[0, [1, 2, 3]]], "_a": [[0, [1, 2, 3]]], "_b": "a note"})"),
           with_character(R"("keys": {"leftHand": {"ease": "smooth", "keys": [[0, [1, 2, 3]]]}})"),
           with_character(R"("expressions": [[0, "neutral", 1], [1, "disgust", 0]], "emotion": [[3, "laugh", 0.5]])"),
           with_character(R"("expressions": {"ease": "linear", "keys": [[0, "neutral", 1]]}, "emotion": [])"),
           with_character(R"("expressions": [[0, "neutral", 1], {"expression": "blink", "start": 2, "until": 3}])"),
           with_character(R"("expressions": [{"expression": "laugh", "start": 12, "until": 40, "stop": 44, "fade": 0,
                                              "strength": 1.5, "ease": "smooth", "_": "a note"}])"),
           with_character(R"("expressions": {"ease": "cubic", "keys": [[0, "fear", 2], [9, "anger", 1]]})"),
           with_character(R"("head": {})"),
           with_character(
               R"("head": {"age": "child", "skull": "round", "measures": {"mouth_width": 0.4}, "level": 3})"),
           with_character(R"("head": {"age": [[0, "adult"], [48, 1]], "skull": {"round": 0.5, "_": "a note"}})"),
           with_character(R"("head": {"age": {"ease": "smooth", "keys": [[0, 0.25]]}})"),
           with_character(R"("head": {"file": "head.json"})"),
           with_muscle(R"({"preset": "calf", "side": "right"})"),
           with_muscle(R"({"preset": "forearm_flexors", "side": "left"})"),
           with_muscle(whole_muscle + "}"),
           with_muscle(whole_muscle + R"(, "before": "c", "except": ["d", "e"]})"),
           with_muscle(whole_muscle + R"(, "driver": "c", "tip": "d", "rest_angle": 170})"),
           with_preset(R"("name": "big", "bone": "x", "child": "y", "from": -1, "to": 2, "peak": -1, "spread": 180)"),
           with_preset(R"("_why": "a note", "comment": 1)"),
           with_top(R"("fps": 1000, "frames": [0, 0], "library": "x.db", "$schema": "s", "_": 1)"),
           with_top(R"("camera": {"view": "top", "orbit": [[0, 0], [9, 360]], "target": [0, 1, 0], "distance": 3})"),
           with_top(R"("camera": {"projection": "orthographic", "distance": [[0, 1]], "target": [[0, [0, 0, 0]]]}, "look": {})"),
           with_top(R"("look": {"shading": "depth", "background": "#FFF"})"),
           with_top(R"("look": {"background": "Transparent"})"),
           with_top(R"("look": {"overlay": ["skeleton", "wire-all"], "compare": "bulge", "compare_as": "inset",
                                "zoom": "leftHand"})"),
           with_top(R"("look": {"overlay": [], "plot": "angle", "sheet": [20, 20], "captions": ["a", "b"]})"),
           R"({"sinew": 1, "characters": [{"model": "builtin:woman"}]})",
           R"({"sinew": 1, "characters": [{"model": "builtin:arm"}]})"}) {
    const auto scene = parse_scene(good, "good.json", "");
    EXPECT_TRUE(scene) << good << "\n" << scene.error().message;
    EXPECT_TRUE(accepts(json::parse(good))) << good;
  }
}

TEST_F(SceneSchema, AcceptsTheScenesThatLieBesideIt) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(scenes)) {
    if (entry.path().extension() != ".json" || entry.path().filename() == "scene.schema.json") continue;
    const auto scene = read_scene(entry.path());
    EXPECT_TRUE(scene) << scene.error().message;
    EXPECT_TRUE(accepts(read_json(entry.path()))) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 1u);
}

TEST_F(SceneSchema, RefusesWhatTheReaderRefuses) {
  struct Case {
    std::string scene, pointer;
  };
  const std::string first = "/characters/0";
  const std::string muscle = first + "/muscles/0";
  for (const auto& [bad, pointer] : std::vector<Case>{
           {"3", "the document"},
           {R"({"characters": [{"model": "a"}]})", "/sinew"},
           {R"({"sinew": 2, "characters": [{"model": "a"}]})", "/sinew"},
           {R"({"sinew": 0, "characters": [{"model": "a"}]})", "/sinew"},
           {R"({"sinew": "1", "characters": [{"model": "a"}]})", "/sinew"},
           {R"({"sinew": 1})", "/characters"},
           {R"({"sinew": 1, "characters": []})", "/characters"},
           {R"({"sinew": 1, "characters": {}})", "/characters"},
           {R"({"sinew": 1, "characters": ["a.glb"]})", first},
           {R"({"sinew": 1, "characters": [{}]})", first + "/model"},
           {R"({"sinew": 1, "characters": [{"model": ""}]})", first + "/model"},
           {R"({"sinew": 1, "characters": [{"model": 3}]})", first + "/model"},
           {R"({"sinew": 1, "characters": [{"model": "builtin:leg"}]})", first + "/model"},
           {with_top(R"("fsp": 24)"), "/fsp"},
           {with_top(R"("fps": 0)"), "/fps"},
           {with_top(R"("fps": 1001)"), "/fps"},
           {with_top(R"("fps": "24")"), "/fps"},
           {with_top(R"("frames": 47)"), "/frames"},
           {with_top(R"("frames": [0])"), "/frames"},
           {with_top(R"("frames": [-1, 3])"), "/frames/0"},
           {with_top(R"("frames": [0, 2.5])"), "/frames/1"},
           {with_top(R"("library": false)"), "/library"},
           {with_top(R"("camera": [])"), "/camera"},
           {with_top(R"("camera": {"veiw": "front"})"), "/camera/veiw"},
           {with_top(R"("camera": {"view": "behind"})"), "/camera/view"},
           {with_top(R"("camera": {"orbit": "90"})"), "/camera/orbit"},
           {with_top(R"("camera": {"projection": "ortho"})"), "/camera/projection"},
           {with_top(R"("camera": {"target": [0, 1]})"), "/camera/target"},
           {with_top(R"("camera": {"distance": 0})"), "/camera/distance"},
      {with_top(R"("camera": {"elevation": 91})"), "/camera/elevation"},
           {with_top(R"("camera": {"distance": [[0, 1], [1, -1]]})"), "/camera/distance/1/1"},
           {with_top(R"("look": {"shading": "shiny"})"), "/look/shading"},
           {with_top(R"("look": {"background": "pink"})"), "/look/background"},
           {with_top(R"("look": {"background": "#12345"})"), "/look/background"},
           {with_top(R"("look": {"colour": "#fff"})"), "/look/colour"},
           {with_top(R"("look": {"overlay": "skeleton"})"), "/look/overlay"},
           {with_top(R"("look": {"overlay": ["skeletn"]})"), "/look/overlay/0"},
           {with_top(R"("look": {"overlay": ["box", "axes", "box"]})"), "/look/overlay/2"},
           {with_top(R"("look": {"compare": "other.json"})"), "/look/compare"},
           {with_top(R"("look": {"compare_as": "outset"})"), "/look/compare_as"},
           {with_top(R"("look": {"zoom": ""})"), "/look/zoom"},
           {with_top(R"("look": {"plot": true})"), "/look/plot"},
           {with_top(R"("look": {"sheet": [4]})"), "/look/sheet"},
           {with_top(R"("look": {"sheet": [0, 4]})"), "/look/sheet/0"},
           {with_top(R"("look": {"captions": []})"), "/look/captions"},
           {with_character(R"("clip": -1)"), first + "/clip"},
           {with_character(R"("clip": 1.5)"), first + "/clip"},
           {with_character(R"("clip": null)"), first + "/clip"},
           {with_character(R"("motion": 3)"), first + "/motion"},
           {with_character(R"("motion": {"start": 1})"), first + "/motion"},
           {with_character(R"("motion": {"file": "a", "speed": 0})"), first + "/motion/speed"},
           {with_character(R"("motion": {"file": "a", "weight": 2})"), first + "/motion/weight"},
           {with_character(R"("motion": {"file": "a", "keys": "over"})"), first + "/motion/keys"},
           {with_character(R"("motion": {"file": "a", "fast": 1})"), first + "/motion/fast"},
           {with_character(R"("position": 0)"), first + "/position"},
           {with_character(R"("position": [0, 0])"), first + "/position"},
           {with_character(R"("position": [0, 0, "1"])"), first + "/position/2"},
           {with_character(R"("position": [[0, [0, 0]]])"), first + "/position/0/1"},
           {with_character(R"("turn": "left")"), first + "/turn"},
           {with_character(R"("turn": [])"), first + "/turn"},
           {with_character(R"("turn": [[0, 1, 2]])"), first + "/turn/0"},
           {with_character(R"("turn": [["0", 1]])"), first + "/turn/0/0"},
           {with_character(R"("turn": [[1e8, 1]])"), first + "/turn/0/0"},
           {with_character(R"("turn": {"ease": "smooth"})"), first + "/turn/keys"},
           {with_character(R"("turn": {"ease": "bouncy", "keys": [[0, 1]]})"), first + "/turn/ease"},
           {with_character(R"("turn": {"esae": "smooth", "keys": [[0, 1]]})"), first + "/turn/esae"},
           {with_character(R"("count": 0)"), first + "/count"},
           {with_character(R"("count": 2)"), first + "/count"},
           {with_character(R"("colour": "red")"), first + "/colour"},
           {with_character(R"("keys": [])"), first + "/keys"},
           {with_character(R"("keys": {"leftHand": []})"), first + "/keys/leftHand"},
           {with_character(R"("keys": {"leftHand": [0, 90, 0]})"), first + "/keys/leftHand/0"},
           {with_character(R"("keys": {"leftHand": "a note?"})"), first + "/keys/leftHand"},
           {with_character(R"("keys": {"a/b~c": [[0, [0, 90]]]})"), first + "/keys/a~1b~0c/0/1"},
           {with_character(R"("keys": {"_joint": [[0, 90]]})"), first + "/keys/_joint/0/1"},
           {with_character(R"("expressions": [[0, "joy", 1]])"), first + "/expressions/0/1"},
           {with_character(R"("expressions": [[0, "laugh"]])"), first + "/expressions/0"},
           {with_character(R"("expressions": [[0, "laugh", 2.5]])"), first + "/expressions/0/2"},
           {with_character(R"("expressions": [{"start": 1, "until": 2}])"), first + "/expressions/0/expression"},
           {with_character(R"("expressions": [{"expression": "laugh", "until": 2}])"), first + "/expressions/0/start"},
           {with_character(R"("expressions": [{"expression": "laugh", "start": 1, "until": 2, "fade": -1}])"),
            first + "/expressions/0/fade"},
           {with_character(R"("expressions": [{"expression": "laugh", "start": 1, "until": 2, "end": 3}])"),
            first + "/expressions/0/end"},
           {with_character(R"("head": "child")"), first + "/head"},
           {with_character(R"("head": {"age": "old"})"), first + "/head/age"},
           {with_character(R"("head": {"age": 1.5})"), first + "/head/age"},
           {with_character(R"("head": {"age": [[0, "adult"], [9, "elder"]]})"), first + "/head/age/1/1"},
           {with_character(R"("head": {"age": "child", "file": "a.json"})"), first + "/head/age"},
           {with_character(R"("head": {"skull": {"round": 2}})"), first + "/head/skull/round"},
           {with_character(R"("head": {"measures": {"mouth_width": "wide"}})"), first + "/head/measures/mouth_width"},
           {with_character(R"("head": {"level": 5})"), first + "/head/level"},
           {with_character(R"("head": {"hair": "red"})"), first + "/head/hair"},
           {with_character(R"("expressions": [])"), first + "/expressions"},
           {with_character(R"("emotion": [[0, "angry", 1]])"), first + "/emotion/0/1"},
           {with_character(R"("emotion": [[0, "anger", -1]])"), first + "/emotion/0/2"},
           {with_character(R"("emotion": {})"), first + "/emotion"},
           {with_character(R"("regions": {"chin": [[0, [1]]]})"), first + "/regions/chin"},
           {with_character(R"("muscles": {})"), first + "/muscles"},
           {with_muscle("3"), muscle},
           {with_muscle("{}"), muscle + "/name"},
           {with_muscle(R"({"preset": "biceps"})"), muscle + "/side"},
           {with_muscle(R"({"preset": "bisceps", "side": "left"})"), muscle + "/preset"},
           {with_muscle(R"({"preset": "biceps", "side": "both"})"), muscle + "/side"},
           {with_muscle(whole_muscle + R"(, "side": "left"})"), muscle + "/side"},
           {with_preset(R"("sprad": 60)"), muscle + "/sprad"},
           {with_preset(R"("name": "")"), muscle + "/name"},
           {with_preset(R"("driver": 7)"), muscle + "/driver"},
           {with_preset(R"("before": 7)"), muscle + "/before"},
           {with_preset(R"("except": "neck")"), muscle + "/except"},
           {with_preset(R"("except": ["neck", 7])"), muscle + "/except/1"},
           {with_preset(R"("facing": [0, 1])"), muscle + "/facing"},
           {with_preset(R"("from": "a")"), muscle + "/from"},
           {with_preset(R"("from": -1.1)"), muscle + "/from"},
           {with_preset(R"("to": 2.1)"), muscle + "/to"},
           {with_preset(R"("spread": 181)"), muscle + "/spread"},
           {with_preset(R"("peak": "high")"), muscle + "/peak"},
           {with_preset(R"("sigma": 0.1)"), muscle + "/sigma"},
           {with_preset(R"("sigma": [0.1, 0])"), muscle + "/sigma/1"},
           {with_preset(R"("rest_angle": -1)"), muscle + "/rest_angle"},
           {with_preset(R"("reference_angle": 200)"), muscle + "/reference_angle"}}) {
    const auto scene = parse_scene(bad, "bad.json", "");
    ASSERT_FALSE(scene) << bad;
    const std::string start = "bad.json: " + pointer + ": ";
    EXPECT_EQ(scene.error().message.substr(0, start.size()), start) << scene.error().message;
    EXPECT_FALSE(accepts(json::parse(bad))) << bad;
  }
}

TEST_F(SceneSchema, MissesWhatTheReaderMissesInAMuscleWithoutPreset) {
  const json whole = json::parse(whole_muscle + "}");
  for (const auto& member : whole.items()) {
    json muscle = whole;
    muscle.erase(member.key());
    const json scene = {{"sinew", 1}, {"characters", {{{"model", "a.glb"}, {"muscles", {muscle}}}}}};
    const auto read = parse_scene(scene.dump(), "bad.json", "");
    ASSERT_FALSE(read) << member.key();
    EXPECT_NE(read.error().message.find("/characters/0/muscles/0/" + member.key() + ": missing"), std::string::npos)
        << read.error().message;
    EXPECT_FALSE(accepts(scene)) << member.key();
  }
}

TEST_F(SceneSchema, KnowsEveryRegionAndHowManyNumbersItTakes) {
  for (const FaceRegion& region : face_regions())
    for (const std::size_t numbers : {region.numbers, region.numbers + 1, region.numbers - 1}) {
      const json keys = {{0, json(std::vector<double>(numbers, 0.5))}};
      const json scene = {{"sinew", 1}, {"characters", {{{"model", "a.glb"}, {"regions", {{region.name, keys}}}}}}};
      const auto read = parse_scene(scene.dump(), "region.json", "");
      const bool right = numbers == region.numbers;
      EXPECT_EQ(read.has_value(), right) << scene;
      EXPECT_EQ(accepts(scene), right) << scene;
      const std::string message = read ? "" : read.error().message;
      EXPECT_EQ(message.find("/regions/" + region.name + "/0/1: ") != std::string::npos, !right) << message;
    }
}

TEST_F(SceneSchema, AcceptsWhatTheWriterWritesAndTheScenesBesideIt) {
  for (const fs::directory_entry& entry : fs::directory_iterator(scenes)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".json" || name.ends_with(".schema.json")) continue;
    EXPECT_TRUE(accepts(read_json(entry.path()))) << name;
    const auto scene = read_scene(entry.path());
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_TRUE(accepts(json::parse(scene_text(*scene, scenes)))) << name;
  }
}

}  // namespace
}  // namespace sinew
