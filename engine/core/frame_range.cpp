#include "engine/core/frame_range.h"

#include <cassert>
#include <optional>
#include <unordered_set>
#include <utility>

#include "engine/core/text.h"

namespace sinew {
namespace {

/// One part of a list: first, first + step, ... up to last.
struct Part {
  int first = 0;
  int last = 0;
  int step = 1;
};

std::string_view trimmed(std::string_view text) {
  const auto start = text.find_first_not_of(' ');
  if (start == std::string_view::npos) return {};
  return text.substr(start, text.find_last_not_of(' ') - start + 1);
}

Result<int> parse_between(std::string_view number, long long low, std::string_view part, std::string_view what) {
  const bool is_written_plainly = !number.empty() && number.find_first_not_of("0123456789") == std::string_view::npos;
  const auto value = is_written_plainly ? parse_integer(number) : std::nullopt;
  if (!value || *value < low || *value > last_possible_frame)
    return failure(ErrorKind::usage, "frames \"{}\": expected {}, an integer from {} to {}, found \"{}\"", part, what,
                   low, last_possible_frame, number);
  return static_cast<int>(*value);
}

Result<Part> parse_part(std::string_view text) {
  if (text.empty())
    return failure(ErrorKind::usage, "frames \"\": expected a frame or a range, such as 7, 0-47 or 0-99:5");
  const auto colon = text.find(':');
  const std::string_view range = text.substr(0, colon);
  const auto dash = range.find('-');
  if (colon != std::string_view::npos && dash == std::string_view::npos)
    return failure(ErrorKind::usage, "frames \"{}\": a step needs a range before it, such as 0-99:5", text);

  auto first = parse_between(range.substr(0, dash), 0, text, "a frame");
  if (!first) return pass_on(std::move(first));
  Part part{*first, *first, 1};
  if (dash != std::string_view::npos) {
    auto last = parse_between(range.substr(dash + 1), 0, text, "the range's last frame");
    if (!last) return pass_on(std::move(last));
    part.last = *last;
  }
  if (colon != std::string_view::npos) {
    auto step = parse_between(text.substr(colon + 1), 1, text, "the range's step");
    if (!step) return pass_on(std::move(step));
    part.step = *step;
  }
  if (part.first > part.last)
    return failure(ErrorKind::usage, "frames \"{}\": expected the lower frame first, {}-{}", text, part.last,
                   part.first);
  return part;
}

/// Where the last run of two '#' or more in the file's own name starts and how long it is; nothing where there is none.
std::optional<std::pair<std::size_t, std::size_t>> frame_pattern(std::string_view file) {
  const auto pair = file.rfind("##");
  const auto slash = file.rfind('/');
  if (pair == std::string_view::npos || (slash != std::string_view::npos && pair < slash)) return std::nullopt;
  const auto before = file.find_last_not_of('#', pair);
  const std::size_t start = before == std::string_view::npos ? 0 : before + 1;
  return std::pair{start, pair + 2 - start};
}

}  // namespace

Result<std::vector<int>> parse_frame_range(std::string_view text) {
  std::vector<int> frames;
  std::unordered_set<int> seen;
  for (const std::string& written : split(text, ',')) {
    const std::string_view part_text = trimmed(written);
    auto part = parse_part(part_text);
    if (!part) return pass_on(std::move(part));
    // A step may be as large as the largest frame, so the sum must not be an int's.
    for (long long frame = part->first; frame <= part->last; frame += part->step) {
      if (!seen.insert(static_cast<int>(frame)).second) continue;
      if (frames.size() == most_frames)
        return failure(ErrorKind::usage, "frames \"{}\": expected at most {} frames altogether", part_text,
                       most_frames);
      frames.push_back(static_cast<int>(frame));
    }
  }
  return frames;
}

bool has_frame_pattern(std::string_view file) { return frame_pattern(file).has_value(); }

std::string frame_file_name(std::string_view pattern, int frame) {
  assert(frame >= 0);
  const auto place = frame_pattern(pattern);
  if (!place) return std::string(pattern);
  const auto [start, length] = *place;
  return fmt::format("{}{:0{}}{}", pattern.substr(0, start), frame, length, pattern.substr(start + length));
}

bool is_frame_file_name(std::string_view pattern, std::string_view file) {
  const auto place = frame_pattern(pattern);
  if (!place) return file == pattern;
  const auto [start, length] = *place;
  const std::size_t around = pattern.size() - length;
  if (file.size() <= around || !file.starts_with(pattern.substr(0, start))) return false;
  const auto frame = parse_integer(file.substr(start, file.size() - around));
  return frame && *frame >= 0 && *frame <= last_possible_frame &&
         frame_file_name(pattern, static_cast<int>(*frame)) == file;
}

}  // namespace sinew
