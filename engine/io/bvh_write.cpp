#include <array>

#include "engine/core/euler.h"
#include "engine/io/bvh.h"

namespace sinew {
namespace {

using enum MotionChannel;

constexpr std::array<std::string_view, 6> channel_names{"Xposition", "Yposition", "Zposition",
                                                        "Xrotation", "Yrotation", "Zrotation"};

bool is_position(MotionChannel channel) { return channel < x_rotation; }

bool turns(const Motion& motion, std::size_t joint) {
  for (const MotionFrame& frame : motion.frames)
    if (std::abs(frame.rotations[joint].w) < 1.0 - 1e-14) return true;
  return false;
}

/// The three axes of the joint's order; those that it does not name come last.
EulerOrder full_order(const MotionJoint& joint) {
  std::vector<int> axes = rotation_order(joint);
  for (const int axis : {2, 0, 1})
    if (std::find(axes.begin(), axes.end(), axis) == axes.end()) axes.push_back(axis);
  return {axes[0], axes[1], axes[2]};
}

/// The joint's own channels where they can say all that it does, else all three rotations in its order.
std::vector<MotionChannel> written_channels(const Motion& motion, std::size_t j) {
  const MotionJoint& joint = motion.skeleton.joints[j];
  std::vector<MotionChannel> channels = joint.channels;
  std::size_t rotations = rotation_order(joint).size();
  if (rotations < 3 && turns(motion, j)) {
    const EulerOrder order = full_order(joint);
    bool enough = rotations > 0;
    for (const MotionFrame& frame : motion.frames)
      for (std::size_t i = rotations; i < 3 && enough; ++i)
        enough = std::abs(to_euler(frame.rotations[j], order)[static_cast<int>(i)]) < 1e-9;
    if (!enough)
      for (; rotations < 3; ++rotations)
        channels.push_back(static_cast<MotionChannel>(int(x_rotation) + order[rotations]));
  }
  bool moves = joint.parent < 0;
  for (const MotionFrame& frame : motion.frames)
    moves = moves || (!frame.offsets.empty() && frame.offsets[j] != joint.offset);
  if (!moves) return channels;
  const auto has = [&](MotionChannel c) { return std::find(channels.begin(), channels.end(), c) != channels.end(); };
  int at = 0;
  for (const MotionChannel c : {x_position, y_position, z_position})
    if (!has(c)) channels.insert(channels.begin() + at++, c);
  return channels;
}

std::string indent(int depth) { return std::string(static_cast<std::size_t>(depth), '\t'); }

std::string offset_line(int depth, const Vec3& v) {
  return fmt::format("{}OFFSET {:.9g} {:.9g} {:.9g}\n", indent(depth), v.x, v.y, v.z);
}

/// A name that a line can hold.
std::string line_name(const std::string& name, std::size_t index) {
  std::string out = name.empty() ? fmt::format("joint{}", index) : name;
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20 || c == '{' || c == '}' || c == '#') c = '_';
  return out;
}

/// Joints in the order in which BVH lists them, depth first.
std::vector<std::size_t> depth_first(const std::vector<MotionJoint>& joints) {
  std::vector<std::vector<std::size_t>> children(joints.size());
  for (std::size_t j = 1; j < joints.size(); ++j) children[static_cast<std::size_t>(joints[j].parent)].push_back(j);
  std::vector<std::size_t> order, stack{0};
  while (!stack.empty()) {
    const std::size_t j = stack.back();
    stack.pop_back();
    order.push_back(j);
    stack.insert(stack.end(), children[j].rbegin(), children[j].rend());
  }
  return order;
}

std::string hierarchy(const std::vector<MotionJoint>& joints, const std::vector<std::size_t>& order,
                      const std::vector<std::vector<MotionChannel>>& channels) {
  std::vector<int> depth(joints.size(), 0);
  std::vector<bool> leaf(joints.size(), true);
  for (std::size_t j = 1; j < joints.size(); ++j) {
    depth[j] = depth[static_cast<std::size_t>(joints[j].parent)] + 1;
    leaf[static_cast<std::size_t>(joints[j].parent)] = false;
  }
  std::string text = "HIERARCHY\n";
  int open = 0;
  for (const std::size_t j : order) {
    const MotionJoint& joint = joints[j];
    while (open > depth[j]) text += indent(--open) + "}\n";
    text +=
        fmt::format("{}{} {}\n{}{{\n", indent(open), j == 0 ? "ROOT" : "JOINT", line_name(joint.name, j), indent(open));
    ++open;
    text += offset_line(open, joint.offset);
    text += fmt::format("{}CHANNELS {}", indent(open), channels[j].size());
    for (const MotionChannel c : channels[j]) text += fmt::format(" {}", channel_names[static_cast<std::size_t>(c)]);
    text += "\n";
    if (leaf[j] || joint.end)
      text += fmt::format("{0}End Site\n{0}{{\n{1}{0}}}\n", indent(open),
                          offset_line(open + 1, joint.end.value_or(Vec3(0.0))));
  }
  while (open > 0) text += indent(--open) + "}\n";
  return text;
}

}  // namespace

Motion without_rest_rotations(const Motion& motion) {
  Motion out = motion;
  std::vector<MotionJoint>& joints = out.skeleton.joints;
  std::vector<Quat> rest;  // global
  for (MotionJoint& joint : joints) {
    const Quat above = joint.parent < 0 ? Quat(1, 0, 0, 0) : rest[static_cast<std::size_t>(joint.parent)];
    rest.push_back(glm::normalize(above * joint.rest_rotation));
    joint.offset = above * joint.offset;
    if (joint.end) joint.end = rest.back() * *joint.end;
    if (std::abs(rest.back().w) < 1.0 - 1e-12 || std::abs(above.w) < 1.0 - 1e-12) joint.channels.clear();
    joint.rest_rotation = Quat(1, 0, 0, 0);
  }
  for (MotionFrame& frame : out.frames)
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const Quat above = joints[j].parent < 0 ? Quat(1, 0, 0, 0) : rest[static_cast<std::size_t>(joints[j].parent)];
      frame.rotations[j] = glm::normalize(above * frame.rotations[j] * glm::conjugate(rest[j]));
      if (!frame.offsets.empty()) frame.offsets[j] = above * frame.offsets[j];
    }
  return out;
}

std::string bvh_text(const Motion& given) {
  bool rotated = false;
  for (const MotionJoint& joint : given.skeleton.joints) rotated = rotated || joint.rest_rotation != Quat(1, 0, 0, 0);
  const Motion motion = rotated ? without_rest_rotations(given) : given;
  const std::vector<MotionJoint>& joints = motion.skeleton.joints;
  std::vector<std::vector<MotionChannel>> channels;
  for (std::size_t j = 0; j < joints.size(); ++j) channels.push_back(written_channels(motion, j));
  const std::vector<std::size_t> order = depth_first(joints);
  std::string text = hierarchy(joints, order, channels);
  text += fmt::format("MOTION\nFrames: {}\nFrame Time: {:.9g}\n", motion.frames.size(), motion.frame_time);
  for (const MotionFrame& frame : motion.frames) {
    std::string row;
    for (const std::size_t j : order) {
      const EulerOrder euler = full_order(joints[j]);
      const Vec3 angles = to_euler(frame.rotations[j], euler) * radians_to_degrees;
      const Vec3 place = j == 0 ? frame.root : frame.offsets.empty() ? joints[j].offset : frame.offsets[j];
      for (const MotionChannel c : channels[j]) {
        const int axis = static_cast<int>(c) % 3;
        const auto turn = std::find(euler.begin(), euler.end(), axis) - euler.begin();
        row += fmt::format("{}{:.9g}", row.empty() ? "" : " ", is_position(c) ? place[axis] : angles[int(turn)]);
      }
    }
    text += row + "\n";
  }
  return text;
}

}  // namespace sinew
