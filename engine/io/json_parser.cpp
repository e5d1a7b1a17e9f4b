#include "engine/io/json_parser.h"

#include <algorithm>
#include <unordered_set>
#include <vector>

namespace sinew {
namespace {

using nlohmann::json;

/// Goes over the text once without keeping it: is it JSON, within the limits, no key twice in an object? Only then is
/// memory spent on the document.
class Inspection : public nlohmann::json_sax<json> {
 public:
  Inspection(std::string_view text, const JsonLimits& limits) : text_(text), limits_(limits) {}

  const std::string& fault() const { return fault_; }

  bool null() override { return begin_value(); }
  bool boolean(bool) override { return begin_value(); }
  bool number_integer(number_integer_t) override { return begin_value(); }
  bool number_unsigned(number_unsigned_t) override { return begin_value(); }
  bool number_float(number_float_t, const string_t&) override { return begin_value(); }
  bool string(string_t&) override { return begin_value(); }
  bool binary(binary_t&) override { return begin_value(); }
  bool start_array(std::size_t) override { return begin_value() && open(); }
  bool end_array() override { return close(); }
  bool start_object(std::size_t) override { return begin_value() && open(); }
  bool end_object() override { return close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.place = name;
    if (level.keys.insert(name).second) return true;
    return fail(pointer() + ": the key stands twice in one object; keep one");
  }

  bool parse_error(std::size_t position, const std::string&, const json::exception& exception) override {
    const std::string_view read = text_.substr(0, position == 0 ? 0 : position - 1);
    const auto line = 1 + std::count(read.begin(), read.end(), '\n');
    const auto line_start = read.rfind('\n');
    const std::size_t column = read.size() - (line_start == std::string_view::npos ? 0 : line_start + 1) + 1;
    return fail(fmt::format("line {}, column {}: {}", line, column, reason(exception.what())));
  }

 private:
  struct Level {
    std::string place;  ///< in an object: the last key
    std::size_t items = 0;
    std::unordered_set<std::string> keys;
  };

  bool fail(std::string what) {
    fault_ = std::move(what);
    return false;
  }

  bool begin_value() {
    if (!levels_.empty()) ++levels_.back().items;
    if (++values_ <= limits_.values) return true;
    return fail(fmt::format("holds more than {} values", limits_.values));
  }

  bool open() {
    if (levels_.size() == limits_.depth)
      return fail(fmt::format("{}: nested deeper than {} levels", pointer(), limits_.depth));
    levels_.emplace_back();
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  std::string pointer() const {
    std::string result;
    for (const Level& level : levels_)
      result = json_pointer(result, level.keys.empty() ? std::to_string(level.items - 1) : level.place);
    return shortened(result);
  }

  static std::string shortened(std::string text) {
    constexpr std::size_t longest = 160;
    return text.size() <= longest ? text : text.substr(0, longest) + "...";
  }

  /// The library's words without its code number and place, and without bytes that are no text.
  static std::string reason(std::string what) {
    if (const auto code_end = what.find("] "); code_end != std::string::npos) what.erase(0, code_end + 2);
    if (what.starts_with("parse error")) what.erase(0, what.find(": ") + 2);
    for (char& c : what)
      if (static_cast<unsigned char>(c) >= 0x80 || static_cast<unsigned char>(c) < 0x20) c = '?';
    what = shortened(std::move(what));
    if (what.find("unexpected ']'") != std::string::npos || what.find("unexpected '}'") != std::string::npos)
      what += " (is there a comma too many before it?)";
    return what;
  }

  std::string_view text_;
  const JsonLimits& limits_;
  std::vector<Level> levels_;
  std::size_t values_ = 0;
  std::string fault_;
};

}  // namespace

std::string json_pointer(std::string_view parent, std::string_view key) {
  std::string pointer(parent);
  pointer += '/';
  for (const char c : key) {
    if (c == '~')
      pointer += "~0";
    else if (c == '/')
      pointer += "~1";
    else
      pointer += c;
  }
  return pointer;
}

Result<json> parse_json(std::string_view text, const std::string& name, const JsonLimits& limits) {
  if (text.size() > limits.bytes)
    return bad_input("{}: holds {} bytes, expected at most {} MiB", name, text.size(), limits.bytes >> 20);
  constexpr bool whole_text = true, comments_allowed = true, exceptions = false;
  Inspection inspection(text, limits);
  if (!json::sax_parse(text, &inspection, json::input_format_t::json, whole_text, comments_allowed))
    return bad_input("{}: {}", name, inspection.fault());
  return json::parse(text, nullptr, exceptions, comments_allowed);
}

}  // namespace sinew
