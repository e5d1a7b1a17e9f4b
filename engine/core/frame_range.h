#pragma once
/// Lists of frames as `--frames` writes them, and the names of the files that hold one frame each.

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace sinew {

constexpr int last_possible_frame = 10'000'000;
constexpr std::size_t most_frames = 1'000'000;  ///< in one list

/// The frames of "0-47", "0-99:5" (every fifth) or "1,3,7-9", in the order written, each once. Spaces around a part are
/// allowed. Fails as usage, naming the part that is wrong: frames are integers from 0 to last_possible_frame, at most
/// most_frames of them, ranges rise, steps are 1 or more.
Result<std::vector<int>> parse_frame_range(std::string_view text);

/// True where the file's own name (not its folder's) has a run of two '#' or more. A single one is a letter like
/// others: "take #3.png" is one picture.
bool has_frame_pattern(std::string_view file);

/// The file with the last such run in its name replaced by the frame, padded with zeros to at least the run's length;
/// a file without such a run as it is. `frame` >= 0.
std::string frame_file_name(std::string_view pattern, int frame);

/// True where `file` is what frame_file_name() makes of `pattern` for some frame.
bool is_frame_file_name(std::string_view pattern, std::string_view file);

}  // namespace sinew
