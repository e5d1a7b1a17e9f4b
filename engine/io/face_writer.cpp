#include "engine/io/face_writer.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

ordered_json cue_to_json(const ExpressionCue& cue) {
  const ExpressionCue defaults;
  ordered_json object{
      {"expression", cue.expression}, {"start", json_number(cue.start)}, {"until", json_number(cue.until)}};
  if (cue.stop) object["stop"] = json_number(*cue.stop);
  if (cue.fade != defaults.fade) object["fade"] = json_number(cue.fade);
  if (cue.strength != defaults.strength) object["strength"] = json_number(cue.strength);
  if (cue.ease != defaults.ease) object["ease"] = word(cue.ease, ease_names());
  return object;
}

ordered_json head_to_json(const HeadSpec& head, const fs::path& folder) {
  const HeadSpec defaults;
  ordered_json object = ordered_json::object();
  if (head.age != defaults.age) object["age"] = keyed_to_json(head.age);
  for (const auto& [name, weight] : head.skull) object["skull"][name] = json_number(weight);
  for (const auto& [name, value] : head.measures) object["measures"][name] = json_number(value);
  if (head.level) object["level"] = *head.level;
  if (!head.file.empty()) object["file"] = path_text(head.file, folder);
  return object;
}

ordered_json emotion_to_json(const std::vector<EmotionCue>& cues) {
  ordered_json list = ordered_json::array();
  for (const EmotionCue& cue : cues)
    list.push_back({json_number(cue.frame), word(cue.emotion, expression_names()), json_number(cue.strength)});
  return list;
}

}  // namespace

void write_face(const Character& character, const fs::path& folder, ordered_json& object) {
  if (character.head) object["head"] = head_to_json(*character.head, folder);
  ordered_json list = ordered_json::array();
  const Keyed<ExpressionWeight> keyed = character.expressions.value_or(Keyed<ExpressionWeight>{});
  for (const Key<ExpressionWeight>& key : keyed.keys) list.push_back(key_to_json(key));
  for (const ExpressionCue& cue : character.cues) list.push_back(cue_to_json(cue));
  if (keyed.ease != Ease::linear) list = {{"ease", word(keyed.ease, ease_names())}, {"keys", std::move(list)}};
  if (!list.empty()) object["expressions"] = std::move(list);
  if (!character.regions.empty()) object["regions"] = map_to_json(character.regions);
  if (!character.emotion.empty()) object["emotion"] = emotion_to_json(character.emotion);
}

}  // namespace sinew
