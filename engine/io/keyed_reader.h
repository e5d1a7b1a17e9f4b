#pragma once
/// Values over time in JSON: one value for all frames, or a list of keys [frame, value], or
/// {"ease": "smooth", "keys": [...]} where the way between the keys is not linear.

#include <string_view>

#include <fmt/format.h>

#include "engine/core/frame_range.h"
#include "engine/io/json_reader.h"
#include "engine/model/keyed.h"
#include "engine/model/scene_words.h"

namespace sinew {

/// A key's frame: any number between - and + last_possible_frame.
inline double read_key_frame(const JsonValue& value) {
  return value.number({-double{last_possible_frame}, double{last_possible_frame}});
}

/// Says so where a key does not come after the one before it.
inline void expect_rising(const JsonValue& key, double previous_frame, double frame) {
  if (frame <= previous_frame)
    key.item(0).error(fmt::format("expected a frame above {}, the one before, found {}", previous_frame, frame));
}

/// The keys in a list or in an object with "ease". `shape` is a key in words, "[frame, [x, y, z]]", of `width` items;
/// `read` makes the value from the whole key. At least one key.
template <class T, class Read>
Keyed<T> read_keys(const JsonValue& value, std::string_view shape, std::size_t width, Read read) {
  Keyed<T> keyed;
  std::optional<JsonValue> list = value;
  if (value.is_object()) {
    static const std::vector<std::string> known{"ease", "keys"};
    value.expect_object(known);
    if (const auto ease = value.find("ease")) keyed.ease = static_cast<Ease>(ease->word(ease_names()));
    list = value.require("keys", fmt::format("a list of keys {}", shape));
  }
  if (!list || !list->expect_list(1, list->size(), fmt::format("a list of keys {}", shape)))
    return Keyed<T>::constant(T{});
  for (std::size_t i = 0; i < list->size(); ++i) {
    const JsonValue key = list->item(i);
    if (!key.expect_list(width, width, fmt::format("a key {}", shape))) continue;
    const double frame = read_key_frame(key.item(0));
    if (!keyed.keys.empty()) expect_rising(key, keyed.keys.back().frame, frame);
    keyed.keys.push_back({frame, read(key)});
  }
  return keyed;
}

/// True where the value is written as keys and not as one number or one list of numbers.
inline bool is_written_as_keys(const JsonValue& value) {
  return value.is_object() || (value.is_list() && value.size() > 0 && value.item(0).is_list());
}

/// A number for all frames, or keys.
inline Keyed<double> read_keyed_number(const JsonValue& value, const NumberRange& range = {}) {
  if (value.is_list() || value.is_object())
    return read_keys<double>(value, "[frame, number]", 2,
                             [&](const JsonValue& key) { return key.item(1).number(range); });
  return Keyed<double>::constant(value.number(range));
}

inline Keyed<Vec3> read_vec3_keys(const JsonValue& value) {
  return read_keys<Vec3>(value, "[frame, [x, y, z]]", 2,
                         [](const JsonValue& key) { return key.item(1).vec3("three numbers [x, y, z]"); });
}

/// Three numbers for all frames, or keys.
inline Keyed<Vec3> read_keyed_vec3(const JsonValue& value) {
  if (is_written_as_keys(value)) return read_vec3_keys(value);
  return Keyed<Vec3>::constant(value.vec3("three numbers [x, y, z], or keys [frame, [x, y, z]]"));
}

}  // namespace sinew
