#include <map>
#include <set>

#include "engine/core/euler.h"
#include "engine/core/text.h"
#include "engine/io/acclaim.h"
#include "engine/io/motion_limits.h"
#include "engine/io/text_scanner.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

class AmcReader {
 public:
  AmcReader(std::string_view text, std::string_view name, const AcclaimSkeleton& skeleton)
      : scanner_(text, name), skeleton_(skeleton), unit_(skeleton.degrees ? degrees_to_radians : 1.0) {
    const std::vector<MotionJoint>& joints = skeleton.skeleton.joints;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      index_[joints[j].name] = j;
      offsets_.push_back(joints[j].offset);
      changes_ = changes_ || (j > 0 && moves(j));
    }
    seen_.resize(joints.size(), 0);
    frame_.root = joints[0].offset;
    frame_.rotations.assign(joints.size(), Quat(1, 0, 0, 0));
  }

  Result<Motion> read() {
    for (Word word = scanner_.next(); !word.end(); word = scanner_.next()) {
      if (word.text.starts_with('#')) {
        scanner_.skip_line();
      } else if (word.text.starts_with(':')) {
        if (lower(word.text) == ":radians") unit_ = 1.0;
        if (lower(word.text) == ":degrees") unit_ = degrees_to_radians;
        scanner_.skip_line();
      } else if (word.first_of_line && parse_integer(word.text)) {
        if (auto ok = close_frame(word); !ok) return pass_on(std::move(ok));
        in_frame_ = true;
      } else {
        if (auto ok = read_bone(word); !ok) return pass_on(std::move(ok));
      }
    }
    if (auto ok = close_frame(scanner_.peek()); !ok) return pass_on(std::move(ok));
    if (motion_.frames.empty()) return scanner_.wrong(scanner_.peek(), "the number of a frame, and its bones' values");
    if (!kept_.empty())
      motion_.problems.push_back(fmt::format("{} bones miss in some frames (the first is {}); they keep their values",
                                             kept_.size(), in_quotes(joints()[*kept_.begin()].name)));
    motion_.skeleton = skeleton_.skeleton;
    return std::move(motion_);
  }

 private:
  const std::vector<MotionJoint>& joints() const { return skeleton_.skeleton.joints; }

  bool moves(std::size_t joint) const {
    for (const AcclaimDof dof : skeleton_.dof[joint])
      if (dof < AcclaimDof::rx) return true;
    return false;
  }

  Result<void> read_bone(const Word& word) {
    const auto found = index_.find(std::string(word.text));
    if (found == index_.end() || !word.first_of_line) {
      std::vector<std::string> names;
      for (const MotionJoint& joint : joints()) names.push_back(joint.name);
      return scanner_.error(
          word, fmt::format("the skeleton has no bone {}{}", in_quotes(word.text), did_you_mean(word.text, names)));
    }
    if (!in_frame_) return scanner_.error(word, "a bone's values before the number of the first frame");
    const std::size_t j = found->second;
    if (seen_[j] == motion_.frames.size() + 1)
      return scanner_.error(word, fmt::format("the bone {} a second time in this frame", in_quotes(word.text)));
    seen_[j] = motion_.frames.size() + 1;
    Quat turn(1, 0, 0, 0);
    Vec3 moved(0.0);
    for (const AcclaimDof dof : skeleton_.dof[j]) {
      const Word value_word = scanner_.peek();
      if (value_word.first_of_line || value_word.end())
        return scanner_.error(value_word, fmt::format("the line of {} ends early: expected {} numbers, one a degree "
                                                      "of freedom",
                                                      in_quotes(joints()[j].name), skeleton_.dof[j].size()));
      auto value = scanner_.number("a degree of freedom");
      if (!value) return pass_on(std::move(value));
      if (dof < AcclaimDof::rx) {
        moved[static_cast<int>(dof)] = *value;
      } else if (dof < AcclaimDof::length) {
        turn = axis_rotation(static_cast<int>(dof) - static_cast<int>(AcclaimDof::rx), *value * unit_) * turn;
      }
    }
    if (const Word extra = scanner_.peek(); !extra.first_of_line && !extra.end())
      return scanner_.wrong(extra, fmt::format("the end of the line after {} numbers", skeleton_.dof[j].size()));
    const Quat& axis = skeleton_.axis[j];
    // A bone's axes stand in a world-parallel frame; the root's are its rest orientation.
    const Quat back = j == 0 ? Quat(1, 0, 0, 0) : glm::conjugate(axis);
    frame_.rotations[j] = glm::normalize(axis * turn * back);
    if (j == 0) frame_.root = joints()[0].offset + moved;
    offsets_[j] = joints()[j].offset + axis * moved;
    return {};
  }

  Result<void> close_frame(const Word& at) {
    if (!in_frame_) return {};
    if (motion_.frames.size() >= most_joint_frames / joints().size())
      return scanner_.error(at, fmt::format("more than {} joints times frames", most_joint_frames));
    for (std::size_t j = 0; j < joints().size(); ++j)
      if (!skeleton_.dof[j].empty() && seen_[j] != motion_.frames.size() + 1) kept_.insert(j);
    motion_.frames.push_back(frame_);
    if (changes_) motion_.frames.back().offsets = offsets_;
    return {};
  }

  TextScanner scanner_;
  const AcclaimSkeleton& skeleton_;
  double unit_;
  Motion motion_;
  MotionFrame frame_;  ///< the last values of every bone
  std::vector<Vec3> offsets_;
  std::map<std::string, std::size_t> index_;
  std::vector<std::size_t> seen_;  ///< [joints] the frame, from 1, that had the bone last
  std::set<std::size_t> kept_;
  bool in_frame_ = false, changes_ = false;
};

}  // namespace

Result<Motion> parse_amc(const Bytes& bytes, const fs::path& file, const AcclaimSkeleton& skeleton, double frame_time) {
  const std::string name = file.string();
  const auto text = as_text(bytes, name, "an AMC file");
  if (!text) return tl::unexpected<Error>(text.error());
  auto motion = AmcReader(*text, name, skeleton).read();
  if (!motion) return motion;
  motion->name = file.stem().string();
  motion->frame_time = frame_time;
  motion->problems.insert(motion->problems.begin(), skeleton.problems.begin(), skeleton.problems.end());
  motion->problems.push_back(
      fmt::format("AMC files do not say their rate: {:.6g} frames a second are taken", 1.0 / frame_time));
  return motion;
}

Result<fs::path> find_asf(const Bytes& amc, const fs::path& file) {
  constexpr std::size_t head_length = 4096;
  const std::string_view head(reinterpret_cast<const char*>(amc.data()), std::min(amc.size(), head_length));
  std::vector<std::string> wanted;
  if (const std::size_t end = lower(head).find(".asf"); end != std::string::npos) {
    const std::size_t start = head.find_last_of("\\/: \t\n", end);
    wanted.push_back(lower(head.substr(start == std::string_view::npos ? 0 : start + 1, end - start + 3)));
  }
  const std::string stem = file.stem().string();
  wanted.push_back(lower(stem) + ".asf");
  wanted.push_back(lower(stem.substr(0, stem.find_last_of('_'))) + ".asf");
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::vector<fs::path> found;
  std::error_code error;
  constexpr std::size_t most_looked_at = 10000;
  std::size_t looked_at = 0;
  for (fs::directory_iterator i(folder, error), end; !error && i != end && looked_at < most_looked_at;
       i.increment(error), ++looked_at)
    if (lower(i->path().extension().string()) == ".asf") found.push_back(i->path());
  std::sort(found.begin(), found.end());
  for (const std::string& name : wanted)
    for (const fs::path& path : found)
      if (lower(path.filename().string()) == name) return file.parent_path() / path.filename();
  if (found.size() == 1) return file.parent_path() / found.front().filename();
  return bad_input("{}: an AMC file needs its skeleton beside it: expected {}", file.string(),
                   (fs::path(stem.substr(0, stem.find_last_of('_'))).string() + ".asf"));
}

}  // namespace sinew
