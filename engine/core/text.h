#pragma once
/// Small text helpers: names that were meant, numbers that were written.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// The candidate nearest to `name` by edit distance, letter case ignored; nothing where none is even close
/// (more than half of the letters differ).
std::optional<std::string> nearest_name(std::string_view name, std::span<const std::string> candidates);

/// " (did you mean \"leftHand\"?)" or nothing: to be put at the end of an error about an unknown name.
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

/// The text split at every `separator`; empty parts are kept.
std::vector<std::string> split(std::string_view text, char separator);

/// Lower-case copy, ASCII letters only.
std::string lower(std::string_view text);

/// The whole text as a finite number, or nothing. The decimal sign is a point whatever the locale.
std::optional<double> parse_number(std::string_view text);

/// The whole text as an integer, or nothing.
std::optional<long long> parse_integer(std::string_view text);

}  // namespace sinew
