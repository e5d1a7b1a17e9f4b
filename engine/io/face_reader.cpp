#include "engine/io/face_reader.h"

#include "engine/io/character_reader.h"
#include "engine/io/keyed_reader.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

double read_strength(const JsonValue& value) { return value.number({0, most_expression_strength}); }

constexpr std::string_view expression_key_shape = "[frame, name, strength]";
constexpr std::size_t expression_key_width = 3;

ExpressionWeight read_expression(const JsonValue& key) {
  const auto expression = static_cast<Expression>(key.item(1).word(expression_names()));
  return {expression, read_strength(key.item(2))};
}

ExpressionCue read_cue(const JsonValue& value) {
  static const std::vector<std::string> known{"expression", "start", "until", "stop", "fade", "strength", "ease"};
  ExpressionCue cue;
  if (!value.expect_object(known)) return cue;
  if (const auto name = value.require("expression", "an expression's name"))
    cue.expression = name->text("an expression's name");
  if (const auto start = value.require("start", "the frame from which it comes")) cue.start = read_key_frame(*start);
  cue.until = cue.start;
  if (const auto until = value.require("until", "the frame up to which it stays")) {
    cue.until = read_key_frame(*until);
    if (cue.until < cue.start)
      until->error(fmt::format("expected {} or more, the start, found {}", cue.start, cue.until));
  }
  if (const auto stop = value.find("stop")) {
    cue.stop = read_key_frame(*stop);
    if (*cue.stop < cue.until)
      stop->error(fmt::format("expected {} or more, up to which it stays, found {}", cue.until, *cue.stop));
  }
  if (const auto fade = value.find("fade")) cue.fade = fade->number({0, double{last_possible_frame}});
  if (const auto strength = value.find("strength")) cue.strength = read_strength(*strength);
  if (const auto ease = value.find("ease")) cue.ease = static_cast<Ease>(ease->word(ease_names()));
  return cue;
}

/// Keys and cues in one list, which stands in an object where the keys have an ease.
void read_expressions(const JsonValue& value, Character& character) {
  static const std::vector<std::string> known{"ease", "keys"};
  const std::string shape = fmt::format("a list of keys {} and cues", expression_key_shape);
  Keyed<ExpressionWeight> keyed;
  std::optional<JsonValue> list = value;
  if (value.is_object()) {
    value.expect_object(known);
    if (const auto ease = value.find("ease")) keyed.ease = static_cast<Ease>(ease->word(ease_names()));
    list = value.require("keys", shape);
  }
  if (!list || !list->expect_list(1, list->size(), shape)) return;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const JsonValue item = list->item(i);
    if (item.is_object()) {
      character.cues.push_back(read_cue(item));
      continue;
    }
    if (!item.expect_list(expression_key_width, expression_key_width,
                          fmt::format("a key {}, or a cue", expression_key_shape)))
      continue;
    const double frame = read_key_frame(item.item(0));
    if (!keyed.keys.empty()) expect_rising(item, keyed.keys.back().frame, frame);
    keyed.keys.push_back({frame, read_expression(item)});
  }
  if (!keyed.keys.empty()) character.expressions = std::move(keyed);
}

double read_age(const JsonValue& value) {
  if (value.is_number()) return value.number({0, 1});
  return double(value.word(age_names())) / double(age_names().size() - 1);
}

/// An outline's name, or an object: name to number.
std::map<std::string, double> read_amounts(const JsonValue& value, const NumberRange& range) {
  std::map<std::string, double> amounts;
  if (!value.is_object()) value.error_expected("an object: name to number");
  for (const std::string& name : value.keys()) {
    const JsonValue amount = *value.find(name);
    if (!is_json_note(name)) amounts[name] = amount.number(range);
  }
  return amounts;
}

HeadSpec read_head(const JsonValue& value, const fs::path& folder) {
  static const std::vector<std::string> known{"age", "skull", "measures", "level", "file"};
  HeadSpec head;
  if (!value.expect_object(known)) return head;
  const auto age = value.find("age"), file = value.find("file");
  if (age && is_written_as_keys(*age))
    head.age = read_keys<double>(*age, "[frame, age]", 2, [](const JsonValue& key) { return read_age(key.item(1)); });
  else if (age)
    head.age = Keyed<double>::constant(read_age(*age));
  if (file) head.file = resolved_path(file->text("the path of a head's measures"), folder);
  if (age && file) age->error("beside \"file\", which has its measures already");
  if (const auto skull = value.find("skull")) {
    if (skull->is_text())
      head.skull[skull->text("an outline")] = 1.0;
    else
      head.skull = read_amounts(*skull, {0, 1});
  }
  if (const auto measures = value.find("measures")) head.measures = read_amounts(*measures, {});
  if (const auto level = value.find("level")) head.level = level->integer(0, most_head_level);
  return head;
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

void read_face(const JsonValue& value, const fs::path& folder, Character& character) {
  if (const auto head = value.find("head")) character.head = read_head(*head, folder);
  if (const auto expressions = value.find("expressions")) read_expressions(*expressions, character);
  if (const auto regions = value.find("regions")) character.regions = read_regions(*regions);
  if (const auto emotion = value.find("emotion")) character.emotion = read_emotion(*emotion);
}

}  // namespace sinew
