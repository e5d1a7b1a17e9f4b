#include "engine/io/json_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/ranges.h>

#include "engine/core/text.h"

namespace sinew {
namespace {

using nlohmann::json;

/// At most about `longest` bytes of UTF-8, never cut inside a character.
std::string shortened(std::string text, std::size_t longest) {
  if (text.size() <= longest) return text;
  while (longest > 0 && (static_cast<unsigned char>(text[longest]) & 0xc0) == 0x80) --longest;
  return text.substr(0, longest) + "...";
}

std::string quoted(const std::string& text) {
  constexpr std::size_t longest = 40;
  return json(shortened(text, longest)).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string description(const json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return fmt::format("a list of {}", value.size());
  if (value.is_string()) return quoted(value.get_ref<const std::string&>());
  return value.dump();
}

}  // namespace

bool is_json_note(std::string_view key) {
  return key.starts_with("_") || key.starts_with("comment") || key == "$schema";
}

void JsonReport::add(std::string_view pointer, std::string_view what) {
  if (error_) return;
  constexpr std::size_t longest = 240;
  const std::string place = pointer.empty() ? "the document" : shortened(std::string(pointer), longest);
  error_ = Error{ErrorKind::bad_input, fmt::format("{}: {}: {}", name_, place, what)};
}

std::string NumberRange::words() const {
  const bool has_low = std::isfinite(low), has_high = std::isfinite(high);
  if (has_low && has_high)
    return above_low ? fmt::format("above {}, up to {}", low, high) : fmt::format("from {} to {}", low, high);
  if (has_low) return fmt::format("{} {}", above_low ? "above" : "from", low);
  return has_high ? fmt::format("up to {}", high) : std::string();
}

std::vector<std::string> JsonValue::keys() const {
  std::vector<std::string> names;
  if (!is_object()) return names;
  for (const auto& member : value_->items()) names.push_back(member.key());
  return names;
}

JsonValue JsonValue::item(std::size_t index) const {
  return {(*value_)[index], *report_, json_pointer(pointer_, std::to_string(index))};
}

std::optional<JsonValue> JsonValue::find(const std::string& key) const {
  if (!is_object()) return std::nullopt;
  const auto member = value_->find(key);
  if (member == value_->end()) return std::nullopt;
  return JsonValue(*member, *report_, json_pointer(pointer_, key));
}

std::optional<JsonValue> JsonValue::require(const std::string& key, std::string_view expected) const {
  auto found = find(key);
  if (!found) report_->add(json_pointer(pointer_, key), fmt::format("missing, expected {}", expected));
  return found;
}

bool JsonValue::expect_object(std::span<const std::string> known) const {
  if (!is_object()) {
    error_expected("an object");
    return false;
  }
  for (const auto& member : value_->items()) {
    const std::string& key = member.key();
    if (is_json_note(key) || std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string hint = did_you_mean(key, known);
    report_->add(json_pointer(pointer_, key),
                 hint.empty() ? fmt::format("unknown key, expected one of {}", fmt::join(known, ", "))
                              : fmt::format("unknown key{}", hint));
    return false;
  }
  return true;
}

bool JsonValue::expect_list(std::size_t low, std::size_t high, std::string_view expected) const {
  if (is_list() && size() >= low && size() <= high) return true;
  error_expected(expected);
  return false;
}

double JsonValue::number(const NumberRange& range) const {
  const double value = is_number() ? value_->get<double>() : NAN;
  if (std::isfinite(value) && range.contains(value)) return value;
  const std::string bounds = range.words();
  error_expected(bounds.empty() ? "a number" : "a number " + bounds);
  return std::isfinite(range.high) ? range.high : 1.0;
}

int JsonValue::integer(int low, int high) const {
  const double value = is_number() ? value_->get<double>() : NAN;
  if (value >= low && value <= high && value == std::floor(value)) return static_cast<int>(value);
  error_expected(fmt::format("an integer from {} to {}", low, high));
  return low;
}

bool JsonValue::flag() const {
  if (!value_->is_boolean()) error_expected("true or false");
  return value_->is_boolean() && value_->get<bool>();
}

std::string JsonValue::text(std::string_view expected) const {
  std::string value = is_text() ? value_->get<std::string>() : std::string();
  if (!value.empty() && value.find('\0') == std::string::npos) return value;
  error_expected(expected);
  return "unknown";
}

std::size_t JsonValue::word(std::span<const std::string> words) const {
  const std::string value = is_text() ? value_->get<std::string>() : std::string();
  const auto found = std::find(words.begin(), words.end(), value);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  error(fmt::format("expected one of {}, found {}{}", fmt::join(words, ", "), description(*value_),
                    did_you_mean(value, words)));
  return 0;
}

std::vector<double> JsonValue::numbers(std::size_t count, std::string_view expected, const NumberRange& range) const {
  std::vector<double> values(count, 1.0);
  if (!expect_list(count, count, expected)) return values;
  for (std::size_t i = 0; i < count; ++i) values[i] = item(i).number(range);
  return values;
}

Vec3 JsonValue::vec3(std::string_view expected) const {
  const std::vector<double> values = numbers(3, expected);
  return {values[0], values[1], values[2]};
}

void JsonValue::error_expected(std::string_view expected) const {
  error(fmt::format("expected {}, found {}", expected, description(*value_)));
}

}  // namespace sinew
