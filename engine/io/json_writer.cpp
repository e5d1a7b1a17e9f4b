#include "engine/io/json_writer.h"

#include <cassert>
#include <cmath>

namespace sinew {
namespace {

using nlohmann::ordered_json;

/// With a space after each comma and colon outside of texts.
void write_on_one_line(const ordered_json& value, std::string& out) {
  const bool is_object = value.is_object();
  if (!is_object && !value.is_array()) {
    out += value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    return;
  }
  out += is_object ? '{' : '[';
  bool first = true;
  for (const auto& member : value.items()) {
    if (!first) out += ", ";
    first = false;
    if (is_object) {
      write_on_one_line(member.key(), out);
      out += ": ";
    }
    write_on_one_line(member.value(), out);
  }
  out += is_object ? '}' : ']';
}

void write_value(const ordered_json& value, std::size_t indent, std::size_t columns, std::string& out) {
  const std::size_t line_start = out.rfind('\n') == std::string::npos ? 0 : out.rfind('\n') + 1;
  const std::size_t value_start = out.size();
  write_on_one_line(value, out);
  constexpr std::size_t comma = 1;
  if (!value.is_structured() || value.empty() || out.size() + comma - line_start <= columns) return;

  out.resize(value_start);
  const bool is_object = value.is_object();
  const std::string inner_line = "\n" + std::string(indent + 2, ' ');
  out += is_object ? '{' : '[';
  bool first = true;
  for (const auto& member : value.items()) {
    if (!first) out += ',';
    first = false;
    out += inner_line;
    if (is_object) {
      write_on_one_line(member.key(), out);
      out += ": ";
    }
    write_value(member.value(), indent + 2, columns, out);
  }
  out += "\n" + std::string(indent, ' ') + (is_object ? '}' : ']');
}

}  // namespace

std::string readable_json(const ordered_json& document, std::size_t columns) {
  std::string text;
  write_value(document, 0, columns, text);
  return text + "\n";
}

ordered_json json_number(double x) {
  assert(std::isfinite(x));
  constexpr double largest_exact_integer = 9007199254740992.0;
  if (x == std::floor(x) && std::abs(x) <= largest_exact_integer) return static_cast<std::int64_t>(x);
  return x;
}

}  // namespace sinew
