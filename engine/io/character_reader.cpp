#include "engine/io/character_reader.h"

#include <cctype>
#include <set>

#include "engine/io/keyed_reader.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

fs::path read_model(const JsonValue& value, const fs::path& folder) {
  const std::string written =
      value.text("the path of a model (.glb, .gltf), or a built-in one such as \"builtin:woman\"");
  if (is_built_in_model(written)) value.word(built_in_model_names());
  return resolved_path(written, folder);
}

ClipChoice read_clip(const JsonValue& value) {
  constexpr int highest_index = 1'000'000;
  if (value.is_number()) return value.integer(0, highest_index);
  const std::string name = value.text("a clip's name or index, or \"none\"");
  return name == "none" ? ClipChoice(NoClip{}) : ClipChoice(name);
}

/// With a folder or with an extension that begins with a letter ("run.bvh", not "walk.01") it is a file's name.
bool is_motion_path(const std::string& written) {
  const std::string extension = fs::path(written).extension().string();
  return written.find('/') != std::string::npos ||
         (extension.size() > 1 && std::isalpha(static_cast<unsigned char>(extension[1])));
}

MotionChoice read_motion_choice(const JsonValue& value, const fs::path& folder) {
  const std::string written = value.text("the path of a motion file, or the name of a clip in the library");
  return is_motion_path(written) ? MotionChoice(MotionFile{resolved_path(written, folder), ""})
                                 : MotionChoice(LibraryClip{written});
}

/// A name alone, or an object with "file" or "clip".
MotionUse read_motion(const JsonValue& value, const fs::path& folder) {
  static const std::vector<std::string> known{"file", "clip", "start", "speed", "weight", "keys"};
  MotionUse use;
  if (!value.is_object()) {
    use.source = read_motion_choice(value, folder);
    return use;
  }
  if (!value.expect_object(known)) return use;
  const auto file = value.find("file"), clip = value.find("clip");
  const std::string name = clip ? clip->text("a clip's name") : std::string();
  if (file) {
    use.source = MotionFile{resolved_path(file->text("the path of a motion file"), folder), name};
  } else {
    use.source = LibraryClip{name};
    if (!clip) value.error_expected("an object with \"file\", or with \"clip\" of the library");
  }
  if (const auto start = value.find("start")) use.start = read_key_frame(*start);
  if (const auto speed = value.find("speed")) use.speed = speed->number({.low = 0, .high = 1000, .above_low = true});
  if (const auto weight = value.find("weight")) use.weight = read_keyed_number(*weight, {0, 1});
  if (const auto keys = value.find("keys")) use.keys = static_cast<KeyBlend>(keys->word(key_blend_names()));
  return use;
}

std::string read_landmarks_key(const JsonValue& value, const fs::path& folder) {
  const std::string written = value.text("the path of a landmark file, or \"auto\"");
  return written == "auto" ? written : resolved_path(written, folder).string();
}

int read_count(const JsonValue& value) {
  constexpr int highest_count = 1'000'000;
  const int count = value.integer(1, highest_count);
  if (count > 1) value.error(fmt::format("crowds do not exist yet, expected 1, found {}", count));
  return count;
}

std::vector<MuscleSpec> read_muscles(const JsonValue& value) {
  std::vector<MuscleSpec> muscles;
  std::set<std::string> names;
  if (!value.expect_list(0, value.size(), "a list of muscles")) return muscles;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const JsonValue item = value.item(i);
    const MuscleSpec muscle = read_muscle(item);
    if (!muscle.name && !(muscle.preset && muscle.side)) continue;
    const std::string name = muscle_name(muscle);
    if (!names.insert(name).second)
      item.find("name").value_or(item).error(
          fmt::format("a second muscle \"{}\" in this character, expected another \"name\"", name));
    muscles.push_back(muscle);
  }
  return muscles;
}

/// Any key is a joint's name, so that one which begins as a note does is a note only where its value is a text.
std::map<std::string, Keyed<Vec3>> read_joint_keys(const JsonValue& value) {
  std::map<std::string, Keyed<Vec3>> keys;
  if (!value.is_object()) value.error_expected("an object: joint name to keys [frame, [x, y, z]]");
  for (const std::string& joint : value.keys()) {
    const JsonValue joint_keys = *value.find(joint);
    if (is_json_note(joint) && joint_keys.is_text()) continue;
    keys.emplace(joint, read_vec3_keys(joint_keys));
  }
  return keys;
}

double read_strength(const JsonValue& value) { return value.number({0, 1}); }

constexpr std::string_view expression_key_shape = "[frame, name, strength]";
constexpr std::size_t expression_key_width = 3;

Keyed<ExpressionWeight> read_expressions(const JsonValue& value) {
  return read_keys<ExpressionWeight>(value, expression_key_shape, expression_key_width, [](const JsonValue& key) {
    const auto expression = static_cast<Expression>(key.item(1).word(expression_names()));
    return ExpressionWeight{expression, read_strength(key.item(2))};
  });
}

std::vector<EmotionCue> read_emotion(const JsonValue& value) {
  std::vector<EmotionCue> cues;
  if (!value.expect_list(0, value.size(), fmt::format("a list of {}", expression_key_shape))) return cues;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const JsonValue cue = value.item(i);
    if (!cue.expect_list(expression_key_width, expression_key_width, expression_key_shape)) continue;
    const double frame = read_key_frame(cue.item(0));
    if (!cues.empty()) expect_rising(cue, cues.back().frame, frame);
    const auto emotion = static_cast<Expression>(cue.item(1).word(expression_names()));
    cues.push_back({frame, emotion, read_strength(cue.item(2))});
  }
  return cues;
}

std::map<std::string, Keyed<std::vector<double>>> read_regions(const JsonValue& value) {
  std::map<std::string, Keyed<std::vector<double>>> regions;
  std::vector<std::string> known;
  for (const FaceRegion& region : face_regions()) known.push_back(region.name);
  if (!value.expect_object(known)) return regions;
  for (const FaceRegion& region : face_regions())
    if (const auto keys = value.find(region.name))
      regions.emplace(region.name, read_keys<std::vector<double>>(
                                       *keys, fmt::format("[frame, {}]", region.shape), 2, [&](const JsonValue& key) {
                                         return key.item(1).numbers(region.numbers, region.shape);
                                       }));
  return regions;
}

}  // namespace

fs::path resolved_path(const std::string& written, const fs::path& folder) {
  if (is_built_in_model(written)) return written;
  return (folder / written).lexically_normal();
}

Character read_character(const JsonValue& value, const fs::path& folder) {
  static const std::vector<std::string> known{"model",   "clip", "motion",      "position", "turn",    "count",
                                              "muscles", "keys", "expressions", "regions",  "emotion", "landmarks"};
  Character character;
  if (!value.expect_object(known)) return character;
  if (const auto model =
          value.require("model", "the path of a model (.glb, .gltf), or a built-in one such as \"builtin:woman\""))
    character.model = read_model(*model, folder);
  if (const auto clip = value.find("clip")) character.clip = read_clip(*clip);
  if (const auto motion = value.find("motion")) character.motion = read_motion(*motion, folder);
  if (const auto position = value.find("position")) character.position = read_keyed_vec3(*position);
  if (const auto turn = value.find("turn")) character.turn = read_keyed_number(*turn);
  if (const auto count = value.find("count")) character.count = read_count(*count);
  if (const auto muscles = value.find("muscles")) character.muscles = read_muscles(*muscles);
  if (const auto keys = value.find("keys")) character.keys = read_joint_keys(*keys);
  if (const auto landmarks = value.find("landmarks")) character.landmarks = read_landmarks_key(*landmarks, folder);
  if (const auto expressions = value.find("expressions")) character.expressions = read_expressions(*expressions);
  if (const auto regions = value.find("regions")) character.regions = read_regions(*regions);
  if (const auto emotion = value.find("emotion")) character.emotion = read_emotion(*emotion);
  return character;
}

}  // namespace sinew
