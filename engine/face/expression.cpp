#include "engine/face/expression.h"

#include <algorithm>
#include <cassert>

#include <nlohmann/json.hpp>

#include "embedded/expression_table.h"
#include "engine/core/text.h"

namespace sinew {
namespace {

using Json = nlohmann::ordered_json;
using C = FaceChannel;

/// A word of the file and the channels that its numbers set; `mirrored` ones with the opposite sign on the right.
struct Pair {
  const char* word;
  struct Number {
    C left, right;
    bool mirrored;
  };
  std::vector<Number> numbers;
};

const std::vector<Pair>& pairs() {
  static const std::vector<Pair> all = {
      {"brows",
       {{C::brow_left_right, C::brow_right_right, true},
        {C::brow_left_up, C::brow_right_up, false},
        {C::brow_left_turn, C::brow_right_turn, true}}},
      {"upperLids", {{C::upper_lid_left, C::upper_lid_right, false}}},
      {"lowerLids", {{C::lower_lid_left, C::lower_lid_right, false}}},
      {"eyes", {{C::eye_left_yaw, C::eye_right_yaw, false}, {C::eye_left_pitch, C::eye_right_pitch, false}}},
      {"corners",
       {{C::corner_left_right, C::corner_right_right, true}, {C::corner_left_up, C::corner_right_up, false}}},
      {"cheeks", {{C::cheek_left_up, C::cheek_right_up, false}}}};
  return all;
}

/// The channels of a region, in the order of its numbers.
std::vector<std::size_t> channels_of(std::string_view region) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < face_channels; ++i)
    if (region == face_channel_names()[i].region) out.push_back(i);
  return out;
}

std::vector<double> numbers_of(const Json& value) {
  return value.is_array() ? value.get<std::vector<double>>() : std::vector<double>{value.get<double>()};
}

FaceChannels moves_of(const Json& moves) {
  FaceChannels out{};
  for (const auto& [word, value] : moves.items()) {
    const std::vector<double> numbers = numbers_of(value);
    const auto pair = std::ranges::find_if(pairs(), [&](const Pair& p) { return word == p.word; });
    if (pair == pairs().end()) {
      const std::vector<std::size_t> region = channels_of(word);
      assert(region.size() == numbers.size());
      for (std::size_t i = 0; i < numbers.size(); ++i) out[region[i]] += numbers[i];
      continue;
    }
    assert(pair->numbers.size() == numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      channel(out, pair->numbers[i].left) += numbers[i];
      channel(out, pair->numbers[i].right) += pair->numbers[i].mirrored ? -numbers[i] : numbers[i];
    }
  }
  return out;
}

template <class Word>
Word word_of(const Json& expression, const char* key, std::initializer_list<std::pair<const char*, Word>> words) {
  const std::string text = expression.value(key, words.begin()->first);
  for (const auto& [word, value] : words)
    if (text == word) return value;
  assert(false);
  return {};
}

FacePreset read_expression(const std::string& name, const Json& json) {
  FacePreset out;
  out.name = name;
  out.moves = moves_of(json.value("moves", Json::object()));
  out.beyond = moves_of(json.value("beyond", Json::object()));
  out.from = moves_of(json.value("from", Json::object()));
  using K = ExpressionKind;
  using O = ExpressionOverride;
  out.kind =
      word_of<K>(json, "kind", {{"emotion", K::emotion}, {"mouth", K::mouth}, {"blink", K::blink}, {"look", K::look}});
  const auto override_of = [&](const char* key) {
    return word_of<O>(json, key, {{"none", O::none}, {"block", O::block}, {"blend", O::blend}});
  };
  out.mouth = override_of("mouth");
  out.blink = override_of("blink");
  out.look = override_of("look");
  out.half =
      word_of<FaceHalf>(json, "half", {{"both", FaceHalf::both}, {"left", FaceHalf::left}, {"right", FaceHalf::right}});
  return out;
}

/// The document is part of the library: that it is well formed is for its test to hold, not for users to hear.
const Json& document() {
  static const Json parsed = Json::parse(expression_table);
  return parsed;
}

std::vector<FacePreset> read_list(const char* list) {
  std::vector<FacePreset> out;
  const Json& all = document()[list];
  for (const auto& [name, json] : all.items())
    out.push_back(read_expression(name, json.contains("same") ? all[json["same"].get<std::string>()] : json));
  return out;
}

/// What is left of a kind beside the others' overrides, 0 to 1.
double left_over(std::span<const WeighedExpression> shown, ExpressionOverride FacePreset::*rule) {
  double left = 1.0;
  for (const WeighedExpression& w : shown) {
    if (w.strength <= 0.0) continue;
    if (w.expression->*rule == ExpressionOverride::block) return 0.0;
    if (w.expression->*rule == ExpressionOverride::blend) left = std::min(left, 1.0 - std::min(1.0, w.strength));
  }
  return left;
}

}  // namespace

FaceChannels FacePreset::channels(bool strict) const {
  FaceChannels out = moves;
  if (!strict)
    for (std::size_t i = 0; i < face_channels; ++i) out[i] += beyond[i];
  return out;
}

std::span<const FacePreset> expressions() {
  static const std::vector<FacePreset> all = read_list("expressions");
  return all;
}

std::span<const FacePreset> arkit_shapes() {
  static const std::vector<FacePreset> all = read_list("arkit");
  return all;
}

Result<const FacePreset*> find_expression(std::string_view name) {
  std::vector<std::string> names;
  for (const auto list : {expressions(), arkit_shapes()})
    for (const FacePreset& e : list) {
      if (e.name == name) return &e;
      names.push_back(e.name);
    }
  std::vector<std::string> shown;
  for (const FacePreset& e : expressions()) shown.push_back(e.name);
  return bad_input("no expression \"{}\"{}; there are {}, and ARKit's", name, did_you_mean(name, names),
                   fmt::join(shown, ", "));
}

std::vector<WeighedExpression> overridden(std::span<const WeighedExpression> shown) {
  const double blink = left_over(shown, &FacePreset::blink), mouth = left_over(shown, &FacePreset::mouth),
               look = left_over(shown, &FacePreset::look);
  std::vector<WeighedExpression> out(shown.begin(), shown.end());
  for (WeighedExpression& w : out) {
    const ExpressionKind kind = w.expression->kind;
    w.strength *= kind == ExpressionKind::blink   ? blink
                  : kind == ExpressionKind::mouth ? mouth
                  : kind == ExpressionKind::look  ? look
                                                  : 1.0;
  }
  return out;
}

FaceChannels mix_expressions(std::span<const WeighedExpression> shown, bool strict) {
  FaceChannels out{};
  for (const WeighedExpression& w : overridden(shown)) {
    const FaceChannels moves = w.expression->channels(strict);
    for (std::size_t i = 0; i < face_channels; ++i) out[i] += w.strength * moves[i];
  }
  return out;
}

FaceChannels for_head(const FaceRig& face, FaceChannels channels) {
  const auto scale = [&](std::initializer_list<C> list, double factor) {
    for (const C c : list) channel(channels, c) *= factor;
  };
  scale(
      {C::brow_left_right, C::brow_left_up, C::brow_right_right, C::brow_right_up, C::cheek_left_up, C::cheek_right_up},
      face.eye_scale);
  scale({C::upper_lip_up, C::lower_lip_up, C::corner_left_right, C::corner_left_up, C::corner_right_right,
         C::corner_right_up},
        face.mouth_scale);
  scale({C::jaw_drop}, face.jaw_scale);
  return channels;
}

Result<void> add_region(std::string_view text, FaceChannels& channels) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos)
    return failure(ErrorKind::usage, "--region {}: expected NAME=NUMBER or NAME=NUMBER,NUMBER...", text);
  const std::string_view name = text.substr(0, equals);
  const std::vector<std::size_t> region = channels_of(name);
  if (region.empty()) {
    std::vector<std::string> names;
    for (const FaceChannelName& n : face_channel_names())
      if (names.empty() || names.back() != n.region) names.emplace_back(n.region);
    return bad_input("--region {}: no region \"{}\"{}; there are {}", text, name, did_you_mean(name, names),
                     fmt::join(names, ", "));
  }
  const std::vector<std::string> words = split(text.substr(equals + 1), ',');
  if (words.size() != region.size())
    return bad_input("--region {}: {} has {} number(s), found {}", text, name, region.size(), words.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto number = parse_number(words[i]);
    if (!number) return failure(ErrorKind::usage, "--region {}: \"{}\" is no number", text, words[i]);
    channels[region[i]] += *number;
  }
  return {};
}

}  // namespace sinew
