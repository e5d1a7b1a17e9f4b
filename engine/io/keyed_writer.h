#pragma once
/// Values over time as JSON: the way back from keyed_reader.h.

#include <filesystem>
#include <map>
#include <span>

#include "engine/io/json_writer.h"
#include "engine/model/scene_words.h"

namespace sinew {

using nlohmann::ordered_json;

template <class Enum>
const std::string& word(Enum value, std::span<const std::string> words) {
  return words[static_cast<std::size_t>(value)];
}

inline ordered_json to_json(double x) { return json_number(x); }
inline ordered_json to_json(const std::string& text) { return text; }
inline ordered_json to_json(const Vec2& v) { return ordered_json::array({json_number(v.x), json_number(v.y)}); }
inline ordered_json to_json(const Vec3& v) {
  return ordered_json::array({json_number(v.x), json_number(v.y), json_number(v.z)});
}
inline ordered_json to_json(const std::vector<double>& numbers) {
  ordered_json list = ordered_json::array();
  for (const double x : numbers) list.push_back(json_number(x));
  return list;
}

template <class T>
ordered_json key_to_json(const Key<T>& key) {
  return ordered_json::array({json_number(key.frame), to_json(key.value)});
}

inline ordered_json key_to_json(const Key<ExpressionWeight>& key) {
  return ordered_json::array(
      {json_number(key.frame), word(key.value.expression, expression_names()), json_number(key.value.strength)});
}

template <class T>
ordered_json keys_to_json(const Keyed<T>& keyed) {
  ordered_json list = ordered_json::array();
  for (const Key<T>& key : keyed.keys) list.push_back(key_to_json(key));
  if (keyed.ease == Ease::linear) return list;
  return {{"ease", word(keyed.ease, ease_names())}, {"keys", std::move(list)}};
}

/// A single value where one says it all, else keys.
template <class T>
ordered_json keyed_to_json(const Keyed<T>& keyed) {
  return keyed == Keyed<T>::constant(keyed.keys.front().value) ? to_json(keyed.keys.front().value)
                                                               : keys_to_json(keyed);
}

template <class T>
ordered_json map_to_json(const std::map<std::string, Keyed<T>>& map) {
  ordered_json object = ordered_json::object();
  for (const auto& [name, keyed] : map) object[name] = keys_to_json(keyed);
  return object;
}

/// Relative to `folder` where a way there can be told without asking the disk, else absolute, else as it is.
std::string path_text(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace sinew
