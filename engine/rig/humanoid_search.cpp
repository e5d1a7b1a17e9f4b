#include "engine/rig/humanoid_search.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "engine/rig/humanoid_names.h"
#include "engine/rig/humanoid_shape.h"

namespace sinew {
namespace {

using enum HumanoidBone;

/// A joint that its name puts forward for a part of the body.
struct Candidate {
  int node = -1;
  NameReading reading;
};

/// What speaks against a choice is added up; a missing joint costs more than any doubt about a name.
constexpr int missing_cost = 20, elsewhere_cost = 3, too_close_cost = 8;
constexpr int weak_name = 3;  ///< "root" may be the hips, but mostly is not

constexpr std::size_t candidates_kept = 256;  ///< of a part: a file may hold a crowd, but one humanoid is looked for
constexpr std::size_t candidates_tried = 12;  ///< of a limb's joint: all triples are looked at

constexpr Candidate nobody{};

HumanoidBone on_side(HumanoidBone left, Side side) { return side == Side::right ? mirrored_bone(left) : left; }

Side other(Side side) { return side == Side::left ? Side::right : Side::left; }

class NameSearch {
 public:
  NameSearch(const Model& model, const JointTree& tree, std::vector<std::string>& notes)
      : model_(model), tree_(tree), notes_(notes) {}

  BoneNodes run() {
    collect();
    for (const Side side : {Side::left, Side::right}) {
      leave_out_numbered_chains(side);
      settle_shoulder(side);
      settle_leg(side);
      find_limb({BodyPart::upper_arm, BodyPart::lower_arm, BodyPart::hand}, on_side(left_upper_arm, side), side);
      find_limb({BodyPart::upper_leg, BodyPart::lower_leg, BodyPart::foot}, on_side(left_upper_leg, side), side);
    }
    for (const Side side : {Side::left, Side::right}) {
      find_clavicle(side);
      set(on_side(left_toes, side), topmost_below(BodyPart::toes, side, node(on_side(left_foot, side))));
      find_fingers(side);
    }
    find_head();
    find_hips();
    find_trunk();
    set(jaw, topmost_below(BodyPart::jaw, Side::middle, node(head)));
    set(left_eye, topmost_below(BodyPart::eye, Side::left, node(head)));
    set(right_eye, topmost_below(BodyPart::eye, Side::right, node(head)));
    return bones_;
  }

 private:
  using Candidates = std::vector<Candidate>;

  int node(HumanoidBone bone) const { return bones_[index_of(bone)]; }
  void set(HumanoidBone bone, int node) { bones_[index_of(bone)] = node; }
  Candidates& of(BodyPart part, Side side) { return candidates_[{part, side}]; }
  std::string name_of(int node) const { return called(model_, node); }

  /// The surest name first, of equals the one higher in the hierarchy (limbs are split from the top), then the first.
  bool before(const Candidate& a, const Candidate& b) const {
    return std::tuple(a.reading.doubt, tree_.depth(a.node), a.node) <
           std::tuple(b.reading.doubt, tree_.depth(b.node), b.node);
  }

  void collect() {
    for (int i = 0; i < tree_.size(); ++i) {
      auto reading = tree_.may_be_joint(i) ? read_joint_name(model_.nodes[i].name) : std::nullopt;
      if (!reading) continue;
      if (!tree_.is_joint(i)) reading->doubt += 2;
      of(reading->part, reading->side).push_back({i, *reading});
    }
    for (auto& [part, list] : candidates_) {
      std::sort(list.begin(), list.end(), [&](const Candidate& a, const Candidate& b) { return before(a, b); });
      if (list.size() > candidates_kept) list.erase(list.begin() + candidates_kept, list.end());
    }
  }

  bool any_below(const Candidates& list, int ancestor) const {
    return std::any_of(list.begin(), list.end(), [&](const Candidate& c) { return tree_.is_below(c.node, ancestor); });
  }
  bool any_above(const Candidates& list, int node) const {
    return std::any_of(list.begin(), list.end(), [&](const Candidate& c) { return tree_.is_below(node, c.node); });
  }

  /// "leg_1" to "leg_4", one below the other, are a whole leg: the number was no counter, so the word says too little.
  void leave_out_numbered_chains(Side side) {
    for (const BodyPart part :
         {BodyPart::clavicle_or_upper_arm, BodyPart::upper_arm, BodyPart::lower_arm, BodyPart::hand,
          BodyPart::upper_leg, BodyPart::upper_or_lower_leg, BodyPart::lower_leg, BodyPart::foot}) {
      Candidates& list = of(part, side);
      const Candidates all = list;
      std::erase_if(list, [&](const Candidate& c) {
        return c.reading.counted && std::any_of(all.begin(), all.end(), [&](const Candidate& d) {
                 return d.reading.counted && (tree_.is_below(d.node, c.node) || tree_.is_below(c.node, d.node));
               });
      });
    }
  }

  void move_to(BodyPart part, Side side, const Candidate& candidate) {
    Candidates& list = of(part, side);
    list.push_back(candidate);
    std::sort(list.begin(), list.end(), [&](const Candidate& a, const Candidate& b) { return before(a, b); });
  }

  /// "LeftShoulder" is the clavicle over an upper arm, but the upper arm itself over an elbow.
  void settle_shoulder(Side side) {
    for (const Candidate& shoulder : of(BodyPart::clavicle_or_upper_arm, side)) {
      const bool is_upper_arm = !any_below(of(BodyPart::upper_arm, side), shoulder.node) &&
                                any_below(of(BodyPart::lower_arm, side), shoulder.node);
      move_to(is_upper_arm ? BodyPart::upper_arm : BodyPart::clavicle, side, shoulder);
      if (is_upper_arm)
        notes_.push_back(fmt::format("{} is the upper arm: a lower arm hangs from it and no other upper arm does",
                                     name_of(shoulder.node)));
    }
  }

  /// "LeftLeg" is the upper leg over a knee, else the lower leg.
  void settle_leg(Side side) {
    const Candidates lower = of(BodyPart::lower_leg, side);
    for (const Candidate& leg : of(BodyPart::upper_or_lower_leg, side))
      move_to(any_below(lower, leg.node) ? BodyPart::upper_leg : BodyPart::lower_leg, side, leg);
  }

  /// What speaks against `below` as the next joint after `above`; nothing where it cannot be.
  std::optional<int> link_cost(int above, int below, double segment_before) const {
    if (above < 0 || below < 0 || tree_.is_below(below, above)) return 0;
    if (above == below || tree_.is_below(above, below)) return std::nullopt;
    const double segment = tree_.distance(above, below);
    const bool ends_the_limb = segment > 0.4 * segment_before && segment < 2.5 * segment_before;
    return ends_the_limb && tree_.common_ancestor(above, below) >= 0 ? std::optional(elsewhere_cost) : std::nullopt;
  }

  int name_cost(const Candidate& candidate, const Candidate& lower) const {
    if (candidate.node < 0) return missing_cost;
    // In ASF files, which name bones by radius and tibia, the joint behind the forearm is the wrist, and the hand's
    // bone begins in the palm.
    if (lower.reading.word == "radius" && candidate.reading.word == "wrist") return 0;
    if (lower.reading.word == "radius" && candidate.reading.word == "hand") return 1;
    return candidate.reading.doubt;
  }

  std::optional<int> limb_cost(const Candidate& upper, const Candidate& lower, const Candidate& end) const {
    const bool whole = upper.node >= 0 && lower.node >= 0;
    const double first = whole ? tree_.distance(upper.node, lower.node) : 0.0;
    const auto first_link = link_cost(upper.node, lower.node, 0.0);
    const auto second_link = link_cost(lower.node >= 0 ? lower.node : upper.node, end.node, first);
    if (!first_link || !second_link) return std::nullopt;
    int cost = *first_link + *second_link + name_cost(upper, nobody) + name_cost(lower, nobody) + name_cost(end, lower);
    if (whole && end.node >= 0) {
      const double second = tree_.distance(lower.node, end.node);
      if (first < 0.05 * second || second < 0.05 * first) cost += too_close_cost;
    }
    return cost;
  }

  Candidates tried(BodyPart part, Side side) {
    Candidates list = of(part, side);
    list.resize(std::min(list.size(), candidates_tried));
    list.push_back(nobody);
    return list;
  }

  /// Upper joint, lower joint and hand or foot: the triple that the least speaks against.
  void find_limb(std::array<BodyPart, 3> parts, HumanoidBone upper_bone, Side side) {
    int least = std::numeric_limits<int>::max();
    std::array<int, 3> best{-1, -1, -1};
    for (const Candidate& upper : tried(parts[0], side))
      for (const Candidate& lower : tried(parts[1], side))
        for (const Candidate& end : tried(parts[2], side)) {
          const auto cost = limb_cost(upper, lower, end);
          if (!cost || *cost >= least) continue;
          least = *cost;
          best = {upper.node, lower.node, end.node};
        }
    HumanoidBone bone = upper_bone;
    for (const int node : best) {
      set(bone, node);
      bone = next_on_chain(bone).value_or(bone);
    }
    if (best[1] >= 0 && best[2] >= 0 && !tree_.is_below(best[2], best[1]))
      notes_.push_back(fmt::format("{} does not hang from {}: it was taken because it stands at the limb's end",
                                   name_of(best[2]), name_of(best[1])));
  }

  void find_clavicle(Side side) {
    const int arm = node(on_side(left_upper_arm, side)), opposite = node(on_side(left_upper_arm, other(side)));
    if (arm < 0) return;
    for (const Candidate& clavicle : of(BodyPart::clavicle, side)) {
      if (!tree_.is_below(arm, clavicle.node)) continue;
      if (opposite >= 0 && tree_.is_below(opposite, clavicle.node)) continue;
      return set(on_side(left_shoulder, side), clavicle.node);
    }
  }

  /// The best candidate that hangs from `ancestor`, or -1.
  int topmost_below(BodyPart part, Side side, int ancestor) {
    if (ancestor < 0) return -1;
    for (const Candidate& candidate : of(part, side))
      if (tree_.is_below(candidate.node, ancestor)) return candidate.node;
    return -1;
  }

  /// A finger's joints that hang from the hand, from the palm outwards, each from the one before.
  Candidates finger_chain(BodyPart finger, Side side) {
    const int palm = node(on_side(left_hand, side));
    Candidates chain = palm < 0 ? Candidates() : of(finger, side);
    std::erase_if(chain, [&](const Candidate& c) { return !tree_.is_below(c.node, palm); });
    std::stable_sort(chain.begin(), chain.end(),
                     [](const Candidate& a, const Candidate& b) { return a.reading.ordinal < b.reading.ordinal; });
    // Number 0 is a metacarpal, which VRM lacks, but in a file that counts three joints from 0.
    const auto is_metacarpal = [&](const Candidate& c) {
      return c.reading.ordinal == 0 && (chain.size() > 3 || c.reading.word.ends_with("metacarpal"));
    };
    Candidates joints;
    for (const Candidate& c : chain)
      if (!is_metacarpal(c) && (joints.empty() || tree_.is_below(c.node, joints.back().node))) joints.push_back(c);
    return joints;
  }

  void find_fingers(Side side) {
    static constexpr std::pair<BodyPart, HumanoidBone> fingers[] = {{BodyPart::thumb, left_thumb_metacarpal},
                                                                    {BodyPart::index, left_index_proximal},
                                                                    {BodyPart::middle, left_middle_proximal},
                                                                    {BodyPart::ring, left_ring_proximal},
                                                                    {BodyPart::little, left_little_proximal}};
    for (const auto& [finger, first] : fingers) {
      const Candidates joints = finger_chain(finger, side);
      // A thumb of two joints that are numbered from 2 lacks the metacarpal.
      const std::size_t skipped =
          finger == BodyPart::thumb && joints.size() == 2 && joints[0].reading.ordinal >= 2 ? 1 : 0;
      const std::size_t base = index_of(on_side(first, side)) + skipped;
      for (std::size_t i = 0; i < std::min<std::size_t>(joints.size(), 3); ++i) bones_[base + i] = joints[i].node;
    }
  }

  /// Where the arms branch off, or -1.
  int arms_ancestor() const {
    const int left = node(left_upper_arm), right = node(right_upper_arm);
    return left >= 0 && right >= 0 ? tree_.common_ancestor(left, right) : -1;
  }

  void find_head() {
    for (const Candidate& candidate : of(BodyPart::head, Side::middle)) {
      if (node(left_upper_arm) >= 0 && tree_.is_below(node(left_upper_arm), candidate.node)) continue;
      return set(head, candidate.node);
    }
    // Blender's metarig calls everything from pelvis to head "spine".
    const int chest_node = arms_ancestor();
    if (chest_node < 0) return;
    int top = -1;
    for (const Candidate& candidate : of(BodyPart::spine, Side::middle))
      if (tree_.is_below(candidate.node, chest_node) && (top < 0 || tree_.depth(candidate.node) > tree_.depth(top)))
        top = candidate.node;
    if (top < 0) return;
    set(head, top);
    notes_.push_back(fmt::format("{} is the head: no joint is named so and it is the spine's end", name_of(top)));
  }

  /// The joint up to which the trunk is followed.
  int trunk_top() const { return node(head) >= 0 ? node(head) : arms_ancestor(); }

  bool near_legs(int candidate) const {
    const int left = node(left_upper_leg), right = node(right_upper_leg);
    if (left < 0 || right < 0) return true;
    const Vec3 between = 0.5 * (tree_.position(left) + tree_.position(right));
    return glm::length(tree_.position(candidate) - between) <= 0.6 * leg_length(tree_, bones_);
  }

  /// How good a place in the hierarchy the hips have here: 2 legs and trunk hang from it, 1 the trunk does, 0 neither.
  int hips_rank(int candidate) const {
    const auto carries = [&](int node) { return node < 0 || tree_.is_below(node, candidate); };
    if (!carries(trunk_top())) return 0;
    return carries(node(left_upper_leg)) && carries(node(right_upper_leg)) ? 2 : 1;
  }

  void find_hips() {
    std::tuple<bool, int, int> best{false, 0, -1};  // a name that is not weak, the rank, the depth
    for (const Candidate& candidate : of(BodyPart::hips, Side::middle)) {
      const bool sure = candidate.reading.doubt < weak_name;
      if (!near_legs(candidate.node) || (!sure && node(left_upper_leg) < 0)) continue;
      const std::tuple found{sure, hips_rank(candidate.node), tree_.depth(candidate.node)};
      if (std::get<1>(found) == 0 || found <= best) continue;
      best = found;
      set(hips, candidate.node);
    }
    if (node(hips) >= 0) {
      if (std::get<1>(best) == 1)
        notes_.push_back(fmt::format("the legs do not hang from {}, which is named as the hips", name_of(node(hips))));
      return;
    }
    const int left = node(left_upper_leg), right = node(right_upper_leg), top = trunk_top();
    if (left < 0 || right < 0 || top < 0) return;
    const int legs = tree_.common_ancestor(left, right);
    const int shared = legs < 0 ? -1 : tree_.common_ancestor(legs, top);
    if (shared < 0 || !tree_.may_be_joint(shared) || !near_legs(shared)) return;
    set(hips, shared);
    notes_.push_back(fmt::format("{} is the hips: legs and spine hang from it", name_of(shared)));
  }

  bool is_named(int node, BodyPart part) {
    const Candidates& list = of(part, Side::middle);
    return std::any_of(list.begin(), list.end(), [&](const Candidate& c) { return c.node == node; });
  }

  /// The lowest joint of the neck on the way to the head; where none is named so, the lowest of the spine over the
  /// arms.
  int neck_on(const std::vector<int>& path) {
    for (const int joint : path)
      if (is_named(joint, BodyPart::neck)) return joint;
    const int chest_node = arms_ancestor();
    for (const int joint : path)
      if (chest_node >= 0 && is_named(joint, BodyPart::spine) && tree_.is_below(joint, chest_node)) return joint;
    return -1;
  }

  /// Neck, and the joints of the spine between hips and neck.
  void find_trunk() {
    const int top = trunk_top();
    if (node(hips) < 0 || top < 0) {
      const Candidates& necks = of(BodyPart::neck, Side::middle);
      return set(neck, necks.empty() ? -1 : necks.front().node);
    }
    std::vector<int> path = tree_.between(node(hips), top);
    if (top != node(head) && top != node(hips)) path.push_back(top);
    set(neck, neck_on(path));
    path.erase(std::find(path.begin(), path.end(), node(neck)), path.end());
    std::vector<int> spine_joints;
    for (const int joint : path)
      if (is_named(joint, BodyPart::spine)) spine_joints.push_back(joint);
    if (spine_joints.empty()) {
      std::copy_if(path.begin(), path.end(), std::back_inserter(spine_joints),
                   [&](int joint) { return tree_.is_joint(joint); });
      if (!spine_joints.empty())
        notes_.push_back(fmt::format("{} begins the spine: it is the first joint between hips and head",
                                     name_of(spine_joints.front())));
    }
    assign_spine(tree_, spine_joints, bones_);
  }

  const Model& model_;
  const JointTree& tree_;
  std::vector<std::string>& notes_;
  std::map<std::pair<BodyPart, Side>, Candidates> candidates_;
  BoneNodes bones_ = no_bones();
};

}  // namespace

std::string called(const Model& model, int node) {
  return model.nodes[node].name.empty() ? fmt::format("node {}", node) : fmt::format("\"{}\"", model.nodes[node].name);
}

BoneNodes find_by_names(const Model& model, const JointTree& tree, std::vector<std::string>& notes) {
  return NameSearch(model, tree, notes).run();
}

}  // namespace sinew
