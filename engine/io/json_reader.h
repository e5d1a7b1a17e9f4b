#pragma once
/// Typed reading of JSON that people write, with errors that name the file and the JSON pointer.
///
/// Reading goes on after an error with harmless values, so that a reader is a plain list of what it reads; it asks
/// JsonReport once, at its end, whether all was well.

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/math.h"
#include "engine/core/result.h"
#include "engine/io/json_parser.h"

namespace sinew {

/// The first thing found wrong with a document.
class JsonReport {
 public:
  explicit JsonReport(std::string name) : name_(std::move(name)) {}

  /// Keeps the message unless there is one already.
  void add(std::string_view pointer, std::string_view what);
  const std::optional<Error>& error() const { return error_; }

 private:
  std::string name_;
  std::optional<Error> error_;
};

/// Bounds of a number, both included unless said.
struct NumberRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;  ///< low itself is not allowed

  bool contains(double x) const { return (above_low ? x > low : x >= low) && x <= high; }
  std::string words() const;  ///< "from 0 to 1", "above 0", or nothing
};

/// A value and its place in the document. Refers to the document and the report; both outlive it.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& value, JsonReport& report) : JsonValue(value, report, "") {}

  bool is_list() const { return value_->is_array(); }
  bool is_object() const { return value_->is_object(); }
  bool is_number() const { return value_->is_number(); }
  bool is_text() const { return value_->is_string(); }
  std::size_t size() const { return value_->size(); }
  std::vector<std::string> keys() const;  ///< of an object; else none

  JsonValue item(std::size_t index) const;                      ///< of a list, index < size()
  std::optional<JsonValue> find(const std::string& key) const;  ///< nothing where absent or no object
  /// find(), and an error where the key is absent: "missing, expected " and `expected`.
  std::optional<JsonValue> require(const std::string& key, std::string_view expected) const;

  /// An object; every key is one of `known` or a note: it begins with "_" or "comment", or is "$schema". False, and an
  /// error with the nearest known key, where not.
  bool expect_object(std::span<const std::string> known) const;
  /// A list of `low` to `high` items; `expected` says it in words. False, and an error, where not.
  bool expect_list(std::size_t low, std::size_t high, std::string_view expected) const;

  // Each of these gives the value, or reports what it expected and gives one that is safe to go on with.
  double number(const NumberRange& range = {}) const;
  int integer(int low, int high) const;
  bool flag() const;
  std::string text(std::string_view expected) const;           ///< never empty, no NUL
  std::size_t word(std::span<const std::string> words) const;  ///< index into `words`
  std::vector<double> numbers(std::size_t count, std::string_view expected, const NumberRange& range = {}) const;
  Vec3 vec3(std::string_view expected) const;

  void error(std::string_view what) const { report_->add(pointer_, what); }
  void error_expected(std::string_view expected) const;  ///< "expected ..., found ..."

 private:
  JsonValue(const nlohmann::json& value, JsonReport& report, std::string pointer)
      : value_(&value), report_(&report), pointer_(std::move(pointer)) {}

  const nlohmann::json* value_;
  JsonReport* report_;
  std::string pointer_;
};

/// True for keys that carry remarks for people and editors and are never an error.
bool is_json_note(std::string_view key);

}  // namespace sinew
