#pragma once
/// JSON for people to read and change: short values stay on one line.

#include <string>

#include <nlohmann/json.hpp>

namespace sinew {

/// The document with objects and lists broken into lines only where they would not fit into `columns`, two spaces a
/// level, with a line end at the end. Bytes that are no UTF-8 become U+FFFD.
std::string readable_json(const nlohmann::ordered_json& document, std::size_t columns = 120);

/// The number, without ".0" where it is whole. `x` is finite.
nlohmann::ordered_json json_number(double x);

}  // namespace sinew
