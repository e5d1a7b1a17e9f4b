#include "engine/io/bvh.h"

#include "engine/core/euler.h"
#include "engine/core/text.h"
#include "engine/io/motion_limits.h"
#include "engine/io/text_scanner.h"

namespace sinew {
namespace {

bool is(const Word& word, std::string_view keyword) { return lower(word.text) == lower(keyword); }

std::optional<MotionChannel> channel_of(std::string_view word) {
  static constexpr std::string_view names[] = {"xposition", "yposition", "zposition",
                                               "xrotation", "yrotation", "zrotation"};
  const std::string wanted = lower(word);
  for (std::size_t i = 0; i < std::size(names); ++i)
    if (names[i] == wanted) return static_cast<MotionChannel>(i);
  return std::nullopt;
}

bool is_position(MotionChannel channel) { return channel < MotionChannel::x_rotation; }

class BvhReader {
 public:
  BvhReader(std::string_view text, const std::filesystem::path& file, std::string_view name) : scanner_(text, name) {
    motion_.name = file.stem().string();
  }

  Result<Motion> read() {
    if (auto ok = read_hierarchy(); !ok) return pass_on(std::move(ok));
    if (auto ok = read_motion_head(); !ok) return pass_on(std::move(ok));
    if (auto ok = read_rows(); !ok) return pass_on(std::move(ok));
    settle_positions();
    return std::move(motion_);
  }

 private:
  std::vector<MotionJoint>& joints() { return motion_.skeleton.joints; }

  Result<void> expect(std::string_view keyword) {
    const Word word = scanner_.next();
    if (!is(word, keyword)) return scanner_.wrong(word, fmt::format("\"{}\"", keyword));
    return {};
  }

  /// The joints without recursion, so that no file decides how deep the stack grows.
  Result<void> read_hierarchy() {
    if (auto ok = expect("HIERARCHY"); !ok) return ok;
    if (auto ok = expect("ROOT"); !ok) return ok;
    if (auto ok = open_joint(-1); !ok) return ok;
    std::vector<int> open{0};
    while (!open.empty()) {
      const int current = open.back();
      const Word word = scanner_.next();
      if (is(word, "}")) {
        if (!has_offset_[current])
          return scanner_.error(word, fmt::format("the joint {} has no OFFSET", in_quotes(joints()[current].name)));
        open.pop_back();
      } else if (is(word, "OFFSET")) {
        auto offset = scanner_.vec3("of an OFFSET with three");
        if (!offset) return pass_on(std::move(offset));
        joints()[current].offset = *offset;
        has_offset_[current] = true;
      } else if (is(word, "CHANNELS")) {
        if (auto ok = read_channels(current); !ok) return ok;
      } else if (is(word, "JOINT")) {
        if (open.size() >= deepest_motion_joint)
          return scanner_.error(
              word, fmt::format("more than {} joints hang from one another, which no body has", deepest_motion_joint));
        if (auto ok = open_joint(current); !ok) return ok;
        open.push_back(static_cast<int>(joints().size()) - 1);
      } else if (is(word, "End")) {
        if (auto ok = read_end(current); !ok) return ok;
      } else {
        return scanner_.wrong(word, "OFFSET, CHANNELS, JOINT, End Site or \"}\"");
      }
    }
    if (channels_ == 0) return scanner_.error(scanner_.peek(), "no joint has a channel, so nothing can move");
    return {};
  }

  Result<void> open_joint(int parent) {
    const Word name = scanner_.rest_of_line();
    if (joints().size() >= most_motion_joints)
      return scanner_.error(name, fmt::format("more than {} joints, which no body has", most_motion_joints));
    MotionJoint& joint = joints().emplace_back();
    joint.name = name.text;
    joint.parent = parent;
    has_offset_.push_back(false);
    return expect("{");
  }

  Result<void> read_channels(int joint) {
    const Word word = scanner_.peek();
    auto count = scanner_.number("how many channels there are");
    if (!count) return pass_on(std::move(count));
    if (*count != std::floor(*count) || *count < 0 || *count > 6)
      return scanner_.wrong(word, "a number of channels from 0 to 6");
    if (!joints()[joint].channels.empty()) return scanner_.error(word, "a second CHANNELS of the same joint");
    for (int i = 0; i < static_cast<int>(*count); ++i) {
      const Word name = scanner_.next();
      const auto channel = channel_of(name.text);
      if (!channel) return scanner_.wrong(name, "a channel such as Xposition or Zrotation");
      for (const MotionChannel other : joints()[joint].channels)
        if (other == *channel) return scanner_.error(name, fmt::format("the channel {} twice", in_quotes(name.text)));
      joints()[joint].channels.push_back(*channel);
      ++channels_;
    }
    return {};
  }

  Result<void> read_end(int joint) {
    scanner_.rest_of_line();  // "Site", or whatever the exporter calls it
    if (auto ok = expect("{"); !ok) return ok;
    if (auto ok = expect("OFFSET"); !ok) return ok;
    auto offset = scanner_.vec3("of an OFFSET with three");
    if (!offset) return pass_on(std::move(offset));
    if (!joints()[joint].end) joints()[joint].end = *offset;
    return expect("}");
  }

  /// "Frames: 12", "Frames : 12" or "Frames:12".
  Result<double> labelled(std::string_view label, std::string_view what) {
    std::string_view left = label;
    Word word = scanner_.next();
    const Word first = word;
    std::string_view text = word.text;
    while (true) {
      const std::size_t space = left.find(' ');
      const std::string_view part = left.substr(0, space);
      if (lower(text.substr(0, part.size())) != lower(part))
        return scanner_.wrong(word.end() ? word : first, fmt::format("\"{}:\"", label));
      text.remove_prefix(part.size());
      if (space == std::string_view::npos) break;
      left.remove_prefix(space + 1);
      word = scanner_.next();
      text = word.text;
    }
    if (text.empty()) {
      word = scanner_.next();
      text = word.text;
    }
    if (!text.starts_with(':')) return scanner_.wrong(word, fmt::format("\":\" after \"{}\"", label));
    text.remove_prefix(1);
    if (text.empty()) {
      word = scanner_.next();
      text = word.text;
    }
    place_ = word;
    const auto value = parse_number(text);
    if (!value) return scanner_.wrong(word, fmt::format("a number, {}", what));
    return *value;
  }

  Result<void> read_motion_head() {
    const Word word = scanner_.next();
    if (is(word, "ROOT")) return scanner_.error(word, "a second ROOT: give each skeleton a file of its own");
    if (!is(word, "MOTION")) return scanner_.wrong(word, "MOTION");
    auto count = labelled("Frames", "how many frames there are");
    if (!count) return pass_on(std::move(count));
    stated_frames_ = *count;
    auto time = labelled("Frame Time", "the seconds that a frame lasts");
    if (!time) return pass_on(std::move(time));
    if (!(*time >= shortest_frame_time && *time <= longest_frame_time))
      return scanner_.error(place_, fmt::format("a frame time of {} seconds, expected {} to {}", *time,
                                                shortest_frame_time, longest_frame_time));
    motion_.frame_time = *time;
    return {};
  }

  /// A row is a line, unless the first line shows that the file breaks its rows otherwise.
  Result<void> read_rows() {
    const std::size_t most_rows = most_joint_frames / joints().size();
    std::vector<double> row;
    row.reserve(channels_);
    bool by_line = true;
    Word start = scanner_.peek();
    for (Word word = scanner_.next(); !word.end(); word = scanner_.next()) {
      if (word.first_of_line && !row.empty() && by_line) {
        if (!motion_.frames.empty()) return short_row(start, row.size());
        by_line = false;
      }
      if (row.empty()) start = word;
      if (by_line && row.empty() && !word.first_of_line && !motion_.frames.empty()) {
        if (motion_.frames.size() > 1) return long_row(word);
        by_line = false;
      }
      const auto value = parse_number(word.text);
      if (!value) return scanner_.wrong(word, "a finite number");
      row.push_back(*value);
      if (row.size() < channels_) continue;
      if (motion_.frames.size() >= most_rows)
        return scanner_.error(start, fmt::format("more than {} rows of {} joints", most_rows, joints().size()));
      add_frame(row);
      row.clear();
    }
    if (!row.empty()) return short_row(start, row.size());
    const std::size_t rows = motion_.frames.size();
    if (rows == 0) return scanner_.wrong(scanner_.peek(), fmt::format("rows of {} numbers", channels_));
    if (static_cast<double>(rows) != stated_frames_)
      motion_.problems.push_back(
          fmt::format("says that it has {} frames, but has {} rows; the rows are used", stated_frames_, rows));
    return {};
  }

  tl::unexpected<Error> short_row(const Word& start, std::size_t found) const {
    return scanner_.error(start, fmt::format("the row of frame {} has {} numbers, expected {}, one a channel",
                                             motion_.frames.size(), found, channels_));
  }
  tl::unexpected<Error> long_row(const Word& word) const {
    return scanner_.error(word, fmt::format("the row of frame {} goes on after {} numbers, one a channel",
                                            motion_.frames.size() - 1, channels_));
  }

  void add_frame(const std::vector<double>& row) {
    MotionFrame& frame = motion_.frames.emplace_back();
    frame.rotations.reserve(joints().size());
    if (moves_below_root()) frame.offsets.reserve(joints().size());
    std::size_t at = 0;
    for (const MotionJoint& joint : joints()) {
      Quat rotation(1, 0, 0, 0);
      Vec3 place = joint.offset;
      for (const MotionChannel channel : joint.channels) {
        const double value = row[at++];
        const int axis = static_cast<int>(channel) % 3;
        if (is_position(channel)) {
          place[axis] = value;
        } else {
          rotation = rotation * axis_rotation(axis, value * degrees_to_radians);
        }
      }
      if (joint.parent < 0) frame.root = place;
      if (moves_below_root()) frame.offsets.push_back(place);
      frame.rotations.push_back(glm::normalize(rotation));
    }
  }

  bool moves_below_root() {
    if (!moves_below_root_) {
      moves_below_root_ = false;
      for (const MotionJoint& joint : joints())
        for (const MotionChannel channel : joint.channels)
          if (joint.parent >= 0 && is_position(channel)) moves_below_root_ = true;
    }
    return *moves_below_root_;
  }

  /// Position channels of joints below the root: places, or what is added to the offset. Exporters do either.
  void settle_positions() {
    if (!moves_below_root()) return;
    std::vector<std::string> added;
    for (std::size_t j = 1; j < joints().size(); ++j) {
      const MotionJoint& joint = joints()[j];
      double from_zero = 0.0, from_offset = 0.0;
      for (const MotionFrame& frame : motion_.frames) {
        from_zero += glm::length(frame.offsets[j]);
        from_offset += glm::length(frame.offsets[j] - joint.offset);
      }
      if (from_zero >= from_offset) continue;
      added.push_back(joint.name);
      for (MotionFrame& frame : motion_.frames)
        for (const MotionChannel channel : joint.channels)
          if (is_position(channel)) frame.offsets[j][int(channel)] += joint.offset[int(channel)];
    }
    if (!added.empty())
      motion_.problems.push_back(fmt::format(
          "the positions of {} joints (the first is {}) lie near zero: they are added to the joints' offsets",
          added.size(), in_quotes(added.front())));
    bool moved = false;
    for (const MotionFrame& frame : motion_.frames)
      for (std::size_t j = 1; j < joints().size(); ++j) moved = moved || frame.offsets[j] != joints()[j].offset;
    if (!moved)
      for (MotionFrame& frame : motion_.frames) frame.offsets.clear();
  }

  TextScanner scanner_;
  Motion motion_;
  std::vector<bool> has_offset_;
  std::size_t channels_ = 0;
  double stated_frames_ = 0.0;
  Word place_;
  std::optional<bool> moves_below_root_;
};

}  // namespace

Result<Motion> parse_bvh(const Bytes& bytes, const std::filesystem::path& file) {
  const std::string name = file.string();
  const auto text = as_text(bytes, name, "a BVH file");
  if (!text) return tl::unexpected<Error>(text.error());
  return BvhReader(*text, file, name).read();
}

}  // namespace sinew
