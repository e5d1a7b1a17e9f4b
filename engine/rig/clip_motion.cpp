#include "engine/rig/clip_motion.h"

#include <algorithm>
#include <set>

#include "engine/io/motion_limits.h"
#include "engine/model/character_mesh.h"
#include "engine/rig/clip_sampling.h"
#include "engine/rig/pose.h"

namespace sinew {
namespace {

/// Nodes that matter, without what stands above the deepest node that is over them all.
std::vector<bool> joint_nodes(const Model& model, const Clip& clip, std::span<const int> order) {
  std::vector<bool> wanted(model.nodes.size(), false);
  for (const Channel& channel : clip.channels)
    if (channel.path != ChannelPath::weights) wanted[static_cast<std::size_t>(channel.node)] = true;
  for (const Skin& skin : model.skins)
    for (const int joint : skin.joints) wanted[static_cast<std::size_t>(joint)] = true;
  for (const auto& [bone, node] : model.vrm_bones) wanted[static_cast<std::size_t>(node)] = true;
  std::vector<int> below(model.nodes.size(), 0);  // wanted nodes at or below each
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    const auto node = static_cast<std::size_t>(*i);
    below[node] += wanted[node] ? 1 : 0;
    if (model.nodes[node].parent >= 0) below[static_cast<std::size_t>(model.nodes[node].parent)] += below[node];
  }
  // The tree with the most of them, and in it down to where they part or the first of them stands.
  int top = -1;
  for (const int node : order)
    if (model.nodes[static_cast<std::size_t>(node)].parent < 0 &&
        (top < 0 || below[static_cast<std::size_t>(node)] > below[static_cast<std::size_t>(top)]))
      top = node;
  std::vector<bool> kept(model.nodes.size(), false);
  if (top < 0 || below[static_cast<std::size_t>(top)] == 0) return kept;
  while (!wanted[static_cast<std::size_t>(top)]) {
    int next = -1, branches = 0;
    for (const int child : model.nodes[static_cast<std::size_t>(top)].children)
      if (below[static_cast<std::size_t>(child)] > 0) {
        next = child;
        ++branches;
      }
    if (branches != 1) break;
    top = next;
  }
  kept[static_cast<std::size_t>(top)] = true;
  for (const int node : order) {
    const int parent = model.nodes[static_cast<std::size_t>(node)].parent;
    if (parent >= 0 && kept[static_cast<std::size_t>(parent)] && below[static_cast<std::size_t>(node)] > 0)
      kept[static_cast<std::size_t>(node)] = true;
  }
  return kept;
}

struct Timing {
  double frame_time = 1.0 / 60.0;
  std::size_t frames = 1;
  bool even = true;
};

/// The smallest step between keys, where all keys lie on multiples of it.
Timing timing_of(const Clip& clip) {
  constexpr double finest = 1.0 / 1000.0;
  std::set<double> times;
  for (const Channel& channel : clip.channels) times.insert(channel.times.begin(), channel.times.end());
  Timing timing;
  double step = clip.duration, last = times.empty() ? 0.0 : *times.begin();
  for (const double t : times) {
    if (t - last > finest) step = std::min(step, t - last);
    last = t;
  }
  if (clip.duration <= 0.0 || step <= 0.0) return timing;
  const double count = std::max(std::round(clip.duration / step), 1.0);
  step = clip.duration / count;
  for (const double t : times)
    timing.even = timing.even && std::abs(t / step - std::round(t / step)) * step < 0.1 * step + 1e-5;
  // A clip of few keys far apart moves between them, and not along straight ways.
  if (!timing.even || step > 1.0 / 20.0) {
    timing.even = step > 1.0 / 20.0;
    step = clip.duration / std::max(std::round(clip.duration * 60.0), 1.0);
  }
  timing.frame_time = step;
  timing.frames = static_cast<std::size_t>(std::min(std::round(clip.duration / step), 1e9)) + 1;
  return timing;
}

Quat unscaled_rotation(const Model& model, const Pose& pose, std::size_t node, const std::vector<Quat>& rotations) {
  const int parent = model.nodes[node].parent;
  const Quat above = parent >= 0 ? rotations[static_cast<std::size_t>(parent)] : Quat(1, 0, 0, 0);
  return glm::normalize(above * pose.local[node].rotation);
}

}  // namespace

Result<Motion> motion_from_clip(const Model& model, const Clip& clip) {
  const std::vector<int> order = hierarchy_order(model);
  const std::vector<bool> kept = joint_nodes(model, clip, order);
  Motion motion;
  motion.name = clip.name;
  motion.skeleton.metres_per_unit = 1.0;
  std::vector<int> joint_of(model.nodes.size(), -1), nodes;
  for (const int node : order) {
    if (!kept[static_cast<std::size_t>(node)]) continue;
    joint_of[static_cast<std::size_t>(node)] = static_cast<int>(nodes.size());
    nodes.push_back(node);
  }
  if (nodes.empty()) return bad_input("{}: the clip \"{}\" moves no joint", model.file, clip.name);
  const Timing timing = timing_of(clip);
  if (timing.frames > most_joint_frames / nodes.size())
    return bad_input("{}: the clip \"{}\" would have {} frames of {} joints, more than can be held", model.file,
                     clip.name, timing.frames, nodes.size());
  if (!timing.even)
    motion.problems.push_back(
        fmt::format("the keys are not evenly spaced: {:.4g} frames a second are taken", 1.0 / timing.frame_time));
  motion.frame_time = timing.frame_time;

  const auto frame_of = [&](const Pose& pose) {
    const std::vector<Mat4> global = global_transforms(model, order, pose);
    std::vector<Quat> rotations(model.nodes.size());
    for (const int node : order)
      rotations[static_cast<std::size_t>(node)] =
          unscaled_rotation(model, pose, static_cast<std::size_t>(node), rotations);
    MotionFrame frame;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const auto node = static_cast<std::size_t>(nodes[j]);
      const Vec3 place(global[node][3]);
      if (j == 0) {
        frame.root = place;
        frame.rotations.push_back(rotations[node]);
        frame.offsets.push_back(place);
        continue;
      }
      const auto parent = static_cast<std::size_t>(model.nodes[node].parent);
      const Quat back = glm::conjugate(rotations[parent]);
      frame.rotations.push_back(glm::normalize(back * rotations[node]));
      frame.offsets.push_back(back * (place - Vec3(global[parent][3])));
    }
    return frame;
  };

  const MotionFrame rest = frame_of(rest_pose(model));
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    MotionJoint& joint = motion.skeleton.joints.emplace_back();
    const Node& node = model.nodes[static_cast<std::size_t>(nodes[j])];
    joint.name = node.name;
    joint.parent = j == 0 ? -1 : joint_of[static_cast<std::size_t>(node.parent)];
    joint.offset = rest.offsets[j];
    joint.rest_rotation = rest.rotations[j];
  }
  for (const auto& [bone, node] : model.vrm_bones)
    if (joint_of[static_cast<std::size_t>(node)] >= 0)
      motion.skeleton.humanoid[bone] = joint_of[static_cast<std::size_t>(node)];

  double size = 0.0, change = 0.0;
  for (std::size_t f = 0; f < timing.frames; ++f) {
    Pose pose = rest_pose(model);
    sample_clip(clip, static_cast<double>(f) * timing.frame_time, pose);
    motion.frames.push_back(frame_of(pose));
    for (std::size_t j = 1; j < nodes.size(); ++j) {
      size = std::max(size, glm::length(rest.offsets[j]));
      change = std::max(change, glm::length(motion.frames.back().offsets[j] - rest.offsets[j]));
    }
  }
  // Float keys repeat the rest pose to about 1e-7 of a body's size.
  if (change <= 1e-5 * size)
    for (MotionFrame& frame : motion.frames) frame.offsets.clear();
  return motion;
}

}  // namespace sinew
