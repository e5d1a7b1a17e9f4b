#include "engine/rig/retarget.h"

#include <algorithm>

#include "engine/model/character_mesh.h"
#include "engine/rig/foot_contact.h"
#include "engine/rig/limb_twist.h"
#include "engine/rig/motion_rig.h"
#include "engine/rig/pose.h"
#include "engine/rig/rest_alignment.h"

namespace sinew {
namespace {

using enum HumanoidBone;

std::size_t at(int node) { return static_cast<std::size_t>(node); }

/// What a node of the model turns like: one joint of the motion, or between two.
struct Follow {
  int node = -1;
  int first = -1, second = -1;  ///< joints; second -1: the first alone
  double share = 0.0;           ///< of the second
};

/// Chains of any two numbers of joints, matched so that the last follows the last. `before`: the joint below both.
void follow_chain(const std::vector<int>& nodes, const std::vector<int>& joints, int before,
                  std::vector<Follow>& follows) {
  if (nodes.empty() || joints.empty()) return;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double place = static_cast<double>((i + 1) * joints.size()) / static_cast<double>(nodes.size());
    const auto whole = static_cast<std::size_t>(place + 1e-9);
    const double share = place - static_cast<double>(whole);
    const int first = whole == 0 ? before : joints[whole - 1];
    if (share < 1e-6 || whole >= joints.size())
      follows.push_back({nodes[i], first, -1, 0.0});
    else
      follows.push_back({nodes[i], first, joints[whole], share});
  }
}

/// Joints from above the hips up to below the neck, or the head where there is no neck.
std::vector<int> trunk_of(const Model& model, const Humanoid& humanoid) {
  const HumanoidBone top = humanoid.find(neck) >= 0 ? neck : head;
  std::vector<int> chain = joints_between(model, humanoid, hips, top);
  if (!chain.empty()) chain.pop_back();
  return chain;
}

std::vector<int> neck_of(const Model& model, const Humanoid& humanoid) {
  if (humanoid.find(head) < 0) return {};
  if (humanoid.find(neck) < 0) return {humanoid.find(head)};
  std::vector<int> chain = joints_between(model, humanoid, neck, head);
  chain.insert(chain.begin(), humanoid.find(neck));
  return chain;
}

class Retargeter {
 public:
  Retargeter(const Motion& motion, const Model& model, const Humanoid& humanoid)
      : motion_(motion),
        model_(model),
        humanoid_(humanoid),
        rig_(motion_rig(motion)),
        order_(hierarchy_order(model)),
        rest_global_(global_transforms(model, order_, rest_pose(model))),
        rest_(rest_rotations(model, order_)),
        twists_(twist_segments(model, humanoid, rest_global_)),
        feet_(model, humanoid, rest_global_) {}

  Result<Retargeted> run(const RetargetOptions& options) {
    if (rig_.humanoid.find(hips) < 0)
      return bad_input("{}: the motion has no hips that are known: {}", motion_.name, known_joints());
    if (humanoid_.find(hips) < 0)
      return bad_input("{}: the model has no humanoid hips, so that no motion fits it", model_.file);
    out_.notes = rig_.notes;
    find_follows();
    if (follows_.size() < 2)
      return bad_input("{}: has no joint but the hips in common with {}", motion_.name, model_.file);
    align();
    measure();
    pose_frames(options);
    return std::move(out_);
  }

 private:
  std::string known_joints() const {
    std::string names;
    constexpr std::size_t most_named = 8;
    for (std::size_t j = 0; j < std::min(motion_.skeleton.joints.size(), most_named); ++j)
      names += (j == 0 ? "" : ", ") + motion_.skeleton.joints[j].name;
    return "its joints are " + names + (motion_.skeleton.joints.size() > most_named ? " ..." : "");
  }

  void find_follows() {
    const int joint_hips = rig_.humanoid.find(hips), node_hips = humanoid_.find(hips);
    follows_.push_back({node_hips, joint_hips, -1, 0.0});
    const std::vector<int> trunk = trunk_of(rig_.model, rig_.humanoid);
    follow_chain(trunk_of(model_, humanoid_), trunk, joint_hips, follows_);
    follow_chain(neck_of(model_, humanoid_), neck_of(rig_.model, rig_.humanoid),
                 trunk.empty() ? joint_hips : trunk.back(), follows_);
    for (std::size_t i = index_of(jaw); i < humanoid_bone_count; ++i)
      if (humanoid_.node[i] >= 0 && rig_.humanoid.node[i] >= 0)
        follows_.push_back({humanoid_.node[i], rig_.humanoid.node[i], -1, 0.0});
    std::vector<std::size_t> rank(model_.nodes.size());
    for (std::size_t i = 0; i < order_.size(); ++i) rank[at(order_[i])] = i;
    std::stable_sort(follows_.begin(), follows_.end(),
                     [&](const Follow& a, const Follow& b) { return rank[at(a.node)] < rank[at(b.node)]; });
  }

  /// After this a node's rotation in the world is `to_world_` times the joint's turn from rest times `aligned_`.
  void align() {
    const MotionPose rest = motion_rest(motion_.skeleton);
    for (const Quat& q : rest.rotations) joint_rest_.push_back(q);
    to_world_ = turn_between(rig_.up, Vec3(0, 1, 0));
    const RestBody body{model_, humanoid_, rest_global_, standing_axes(model_, humanoid_, rest_global_)};
    const RestBody like{rig_.model, rig_.humanoid, rig_.rest_global, rig_.rest_axes};
    const std::vector<Quat> turns = rest_alignment(body, like, order_);
    for (std::size_t i = 0; i < turns.size(); ++i) aligned_.push_back(turns[i] * rest_[i]);
    const double own = hip_height(humanoid_, rest_global_, body.axes.up);
    out_.scale = own > 0.0 && rig_.height > 0.0 ? own / rig_.height : 1.0;
    if (!(own > 0.0 && rig_.height > 0.0))
      out_.notes.push_back("hip heights are not known of both bodies: lengths are not scaled");
  }

  /// Which nodes the clip moves.
  void measure() {
    moved_.assign(model_.nodes.size(), false);
    for (const Follow& follow : follows_) moved_[at(follow.node)] = true;
    for (const TwistSegment& segment : twists_) {
      for (const int node : segment.between) moved_[at(node)] = true;
      for (const TwistSegment::Leaf& leaf : segment.leaves) moved_[at(leaf.node)] = true;
    }
  }

  /// Global rotations of all nodes.
  std::vector<Quat> rotations(const MotionPose& pose) const {
    std::vector<Quat> global(model_.nodes.size());
    std::vector<bool> set(model_.nodes.size(), false);
    const auto turn = [&](int joint) {
      // A bone's free end is no joint; it turns as the joint that it belongs to.
      while (joint >= static_cast<int>(joint_rest_.size())) joint = rig_.model.nodes[at(joint)].parent;
      return pose.rotations[at(joint)] * glm::conjugate(joint_rest_[at(joint)]);
    };
    for (const Follow& follow : follows_) {
      Quat q = turn(follow.first);
      if (follow.second >= 0) q = glm::slerp(q, turn(follow.second), follow.share);
      global[at(follow.node)] = glm::normalize(to_world_ * q * aligned_[at(follow.node)]);
      set[at(follow.node)] = true;
    }
    follow_parents(set, global);
    for (const TwistSegment& segment : twists_) {
      share_twist(model_, segment, rest_, rest_global_, global);
      for (const int node : segment.between) set[at(node)] = true;
      for (const TwistSegment::Leaf& leaf : segment.leaves) set[at(leaf.node)] = true;
      follow_parents(set, global);
    }
    return global;
  }

  /// What nothing moves keeps its rest rotation to its parent.
  void follow_parents(const std::vector<bool>& set, std::vector<Quat>& global) const {
    for (const int node : order_) {
      if (set[at(node)]) continue;
      const int parent = model_.nodes[at(node)].parent;
      const Quat& local = model_.nodes[at(node)].rest.rotation;
      global[at(node)] = parent < 0 ? local : glm::normalize(global[at(parent)] * local);
    }
  }

  Pose posed(const std::vector<Quat>& global) const {
    Pose pose = rest_pose(model_);
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      if (!moved_[i]) continue;
      const int parent = model_.nodes[i].parent;
      const Quat above = parent < 0 ? Quat(1, 0, 0, 0) : global[at(parent)];
      pose.local[i].rotation = glm::normalize(glm::conjugate(above) * global[i]);
    }
    return pose;
  }

  /// The hips' local translation for a place in the world; what is above them rests.
  Vec3 hips_translation(const Vec3& place) const {
    const int parent = model_.nodes[at(humanoid_.find(hips))].parent;
    if (parent < 0) return place;
    return Vec3(glm::inverse(rest_global_[at(parent)]) * Vec4(place, 1.0));
  }

  void pose_frames(const RetargetOptions& options) {
    const int node_hips = humanoid_.find(hips), joint_hips = rig_.humanoid.find(hips);
    const Vec3 rest_place(rest_global_[at(node_hips)][3]);
    const std::size_t count = motion_.frames.size();
    std::vector<Vec3> places;
    std::vector<double> heights;
    std::vector<Channel> channels;
    for (std::size_t i = 0; i < model_.nodes.size(); ++i)
      if (moved_[i]) channels.push_back({static_cast<int>(i), ChannelPath::rotation, Interpolation::linear, 4, {}, {}});
    for (std::size_t f = 0; f < count; ++f) {
      const MotionPose source = motion_pose(motion_, f);
      Pose pose = posed(rotations(source));
      places.push_back(out_.scale * (to_world_ * source.places[at(joint_hips)]));
      pose.local[at(node_hips)].translation = hips_translation(places.back());
      heights.push_back(feet_.height(global_transforms(model_, order_, pose)));
      for (Channel& channel : channels) add_rotation(pose.local[at(channel.node)].rotation, channel);
    }
    settle(rest_place, options, places, heights);
    Channel path{node_hips, ChannelPath::translation, Interpolation::linear, 3, {}, {}};
    for (const Vec3& place : places) {
      const Vec3 local = hips_translation(place);
      path.values.insert(path.values.end(), {local.x, local.y, local.z});
    }
    channels.push_back(std::move(path));
    std::vector<double> times;
    for (std::size_t f = 0; f < count; ++f) times.push_back(static_cast<double>(f) * motion_.frame_time);
    for (Channel& channel : channels) channel.times = times;
    out_.clip = {motion_.name, std::move(channels), motion_.duration()};
  }

  /// The shorter way round from the key before.
  static void add_rotation(Quat q, Channel& channel) {
    const std::size_t n = channel.values.size();
    if (n >= 4) {
      const Quat before(channel.values[n - 1], channel.values[n - 4], channel.values[n - 3], channel.values[n - 2]);
      if (glm::dot(before, q) < 0.0) q = -q;
    }
    channel.values.insert(channel.values.end(), {q.x, q.y, q.z, q.w});
  }

  /// Sets the path onto the model's floor, and raises what sinks.
  void settle(const Vec3& rest_place, const RetargetOptions& options, std::vector<Vec3>& places,
              std::vector<double>& heights) {
    Vec3 shift(0.0);
    if (options.from_rest_place) shift = rest_place - places.front();
    if (feet_.empty()) {
      shift.y = rest_place.y - places.front().y;
    } else {
      std::vector<double> sorted = heights;
      const auto quarter = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 4);
      std::nth_element(sorted.begin(), quarter, sorted.end());
      shift.y = -*quarter;
    }
    for (Vec3& place : places) place += shift;
    for (double& height : heights) height += shift.y;
    if (feet_.empty()) return;
    const auto deepest = std::min_element(heights.begin(), heights.end());
    out_.deepest_sinking = std::max(-*deepest, 0.0);
    out_.deepest_frame = static_cast<std::size_t>(deepest - heights.begin());
    if (!options.lift_feet) return;
    constexpr double reach_seconds = 0.15;
    const auto reach = static_cast<std::size_t>(std::min(reach_seconds / motion_.frame_time, 1000.0));
    const std::vector<double> lift = smooth_lift(heights, reach);
    for (std::size_t f = 0; f < places.size(); ++f) places[f].y += lift[f];
  }

  const Motion& motion_;
  const Model& model_;
  const Humanoid& humanoid_;
  MotionRig rig_;
  std::vector<int> order_;
  std::vector<Mat4> rest_global_;
  std::vector<Quat> rest_;  ///< [nodes] global
  std::vector<TwistSegment> twists_;
  FootContact feet_;
  std::vector<Follow> follows_;
  std::vector<Quat> joint_rest_, aligned_;
  std::vector<bool> moved_;
  Quat to_world_{1, 0, 0, 0};
  Retargeted out_;
};

}  // namespace

Result<Retargeted> retarget(const Motion& motion, const Model& model, const Humanoid& humanoid,
                            const RetargetOptions& options) {
  return Retargeter(motion, model, humanoid).run(options);
}

}  // namespace sinew
