#include "engine/rig/retarget.h"

#include <algorithm>

#include "engine/model/character_mesh.h"
#include "engine/rig/foot_contact.h"
#include "engine/rig/joint_matching.h"
#include "engine/rig/joint_tree.h"
#include "engine/rig/limb_twist.h"
#include "engine/rig/motion_rig.h"
#include "engine/rig/pose.h"
#include "engine/rig/rest_alignment.h"

namespace sinew {
namespace {

using enum HumanoidBone;

std::size_t at(int node) { return static_cast<std::size_t>(node); }

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
    follows_ = match_joints(model_, humanoid_, order_, rig_.model, rig_.humanoid);
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

  void find_strays() {
    const JointTree tree(model_, rest_global_);
    for (const HumanoidBone bone :
         {left_upper_leg, right_upper_leg, left_lower_leg, right_lower_leg, left_foot, right_foot, left_upper_arm,
          right_upper_arm, left_lower_arm, right_lower_arm, left_hand, right_hand}) {
      const auto above = humanoid_.parent_present(bone);
      const int node = humanoid_.find(bone), limb = above ? humanoid_.find(*above) : -1;
      if (node < 0 || limb < 0 || tree.is_below(node, limb)) continue;
      const Vec3 offset(glm::inverse(rest_global_[at(limb)]) * rest_global_[at(node)][3]);
      bool carried = tree.is_below(node, humanoid_.find(hips));
      for (const Stray& stray : strays_) carried = carried || tree.is_below(node, stray.node);
      strays_.push_back({node, limb, offset, carried});
    }
  }

  /// Which nodes the clip moves.
  void measure() {
    find_strays();
    moved_.assign(model_.nodes.size(), false);
    for (const JointFollow& follow : follows_) moved_[at(follow.node)] = true;
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
    for (const JointFollow& follow : follows_) {
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
      place_strays(pose);
      heights.push_back(feet_.height(global_transforms(model_, order_, pose)));
      for (Channel& channel : channels) add_rotation(pose.local[at(channel.node)].rotation, channel);
      for (const Stray& stray : strays_) stray_places_.push_back(pose.local[at(stray.node)].translation);
    }
    unsettled_places_ = places;
    settle(rest_place, options, places, heights);
    Channel path{node_hips, ChannelPath::translation, Interpolation::linear, 3, {}, {}};
    for (const Vec3& place : places) {
      const Vec3 local = hips_translation(place);
      path.values.insert(path.values.end(), {local.x, local.y, local.z});
    }
    channels.push_back(std::move(path));
    for (std::size_t i = 0; i < strays_.size(); ++i) channels.push_back(stray_path(i, places));
    std::vector<double> times;
    for (std::size_t f = 0; f < count; ++f) times.push_back(static_cast<double>(f) * motion_.frame_time);
    for (Channel& channel : channels) channel.times = times;
    out_.clip = {motion_.name, std::move(channels), motion_.duration()};
  }

  /// Parts of limbs that hang from elsewhere (feet from a root for IK) stand where the part before them ends.
  void place_strays(Pose& pose) const {
    for (const Stray& stray : strays_) {
      const std::vector<Mat4> global = global_transforms(model_, order_, pose);
      const Vec3 end(global[at(stray.limb)] * Vec4(stray.offset, 1.0));
      const int parent = model_.nodes[at(stray.node)].parent;
      pose.local[at(stray.node)].translation =
          parent < 0 ? end : Vec3(glm::inverse(global[at(parent)]) * Vec4(end, 1.0));
    }
  }

  /// Their way over all frames; what the hips were moved by since they were placed moves them as well.
  Channel stray_path(std::size_t index, const std::vector<Vec3>& places) const {
    const Stray& stray = strays_[index];
    Channel path{stray.node, ChannelPath::translation, Interpolation::linear, 3, {}, {}};
    for (std::size_t f = 0; f < places.size(); ++f) {
      Vec3 local = stray_places_[f * strays_.size() + index];
      if (!stray.carried) {
        const int parent = model_.nodes[at(stray.node)].parent;
        const Vec3 moved = places[f] - unsettled_places_[f];
        local += parent < 0 ? moved : Vec3(glm::inverse(rest_global_[at(parent)]) * Vec4(moved, 0.0));
      }
      path.values.insert(path.values.end(), {local.x, local.y, local.z});
    }
    return path;
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

  struct Stray {
    int node = -1, limb = -1;  ///< nodes
    Vec3 offset{0.0};          ///< the node's rest place in the limb's frame
    bool carried = false;      ///< hangs from the hips, or from what is placed like this
  };

  const Motion& motion_;
  const Model& model_;
  const Humanoid& humanoid_;
  MotionRig rig_;
  std::vector<int> order_;
  std::vector<Mat4> rest_global_;
  std::vector<Quat> rest_;  ///< [nodes] global
  std::vector<TwistSegment> twists_;
  FootContact feet_;
  std::vector<JointFollow> follows_;
  std::vector<Quat> joint_rest_, aligned_;
  std::vector<bool> moved_;
  std::vector<Stray> strays_;
  std::vector<Vec3> stray_places_, unsettled_places_;
  Quat to_world_{1, 0, 0, 0};
  Retargeted out_;
};

}  // namespace

Result<Retargeted> retarget(const Motion& motion, const Model& model, const Humanoid& humanoid,
                            const RetargetOptions& options) {
  return Retargeter(motion, model, humanoid).run(options);
}

}  // namespace sinew
