#include "engine/rig/humanoid_bone.h"

#include <array>
#include <map>
#include <string>

namespace sinew {
namespace {

using enum HumanoidBone;

struct BoneRow {
  std::string_view name;
  HumanoidBone parent;  ///< hips: its own
};

constexpr std::array<BoneRow, humanoid_bone_count> bone_rows{{
    {"hips", hips},
    {"spine", hips},
    {"chest", spine},
    {"upperChest", chest},
    {"neck", upper_chest},
    {"head", neck},
    {"leftEye", head},
    {"rightEye", head},
    {"jaw", head},
    {"leftUpperLeg", hips},
    {"leftLowerLeg", left_upper_leg},
    {"leftFoot", left_lower_leg},
    {"leftToes", left_foot},
    {"rightUpperLeg", hips},
    {"rightLowerLeg", right_upper_leg},
    {"rightFoot", right_lower_leg},
    {"rightToes", right_foot},
    {"leftShoulder", upper_chest},
    {"leftUpperArm", left_shoulder},
    {"leftLowerArm", left_upper_arm},
    {"leftHand", left_lower_arm},
    {"rightShoulder", upper_chest},
    {"rightUpperArm", right_shoulder},
    {"rightLowerArm", right_upper_arm},
    {"rightHand", right_lower_arm},
    {"leftThumbMetacarpal", left_hand},
    {"leftThumbProximal", left_thumb_metacarpal},
    {"leftThumbDistal", left_thumb_proximal},
    {"leftIndexProximal", left_hand},
    {"leftIndexIntermediate", left_index_proximal},
    {"leftIndexDistal", left_index_intermediate},
    {"leftMiddleProximal", left_hand},
    {"leftMiddleIntermediate", left_middle_proximal},
    {"leftMiddleDistal", left_middle_intermediate},
    {"leftRingProximal", left_hand},
    {"leftRingIntermediate", left_ring_proximal},
    {"leftRingDistal", left_ring_intermediate},
    {"leftLittleProximal", left_hand},
    {"leftLittleIntermediate", left_little_proximal},
    {"leftLittleDistal", left_little_intermediate},
    {"rightThumbMetacarpal", right_hand},
    {"rightThumbProximal", right_thumb_metacarpal},
    {"rightThumbDistal", right_thumb_proximal},
    {"rightIndexProximal", right_hand},
    {"rightIndexIntermediate", right_index_proximal},
    {"rightIndexDistal", right_index_intermediate},
    {"rightMiddleProximal", right_hand},
    {"rightMiddleIntermediate", right_middle_proximal},
    {"rightMiddleDistal", right_middle_intermediate},
    {"rightRingProximal", right_hand},
    {"rightRingIntermediate", right_ring_proximal},
    {"rightRingDistal", right_ring_intermediate},
    {"rightLittleProximal", right_hand},
    {"rightLittleIntermediate", right_little_proximal},
    {"rightLittleDistal", right_little_intermediate},
}};

}  // namespace

std::string_view humanoid_name(HumanoidBone bone) { return bone_rows[index_of(bone)].name; }

std::optional<HumanoidBone> humanoid_bone(std::string_view vrm_name) {
  static const auto by_name = [] {
    std::map<std::string_view, HumanoidBone> bones;
    for (std::size_t i = 0; i < humanoid_bone_count; ++i) bones[bone_rows[i].name] = static_cast<HumanoidBone>(i);
    return bones;
  }();
  const auto found = by_name.find(vrm_name);
  return found == by_name.end() ? std::nullopt : std::optional(found->second);
}

std::optional<HumanoidBone> parent_bone(HumanoidBone bone) {
  return bone == hips ? std::nullopt : std::optional(bone_rows[index_of(bone)].parent);
}

HumanoidBone mirrored_bone(HumanoidBone bone) {
  const std::string_view name = humanoid_name(bone);
  if (name.starts_with("left")) return *humanoid_bone("right" + std::string(name.substr(4)));
  if (name.starts_with("right")) return *humanoid_bone("left" + std::string(name.substr(5)));
  return bone;
}

std::optional<HumanoidBone> next_on_chain(HumanoidBone bone) {
  switch (bone) {
    case hips:
      return spine;
    case upper_chest:
      return neck;
    case head:
      return std::nullopt;
    case left_hand:
      return left_middle_proximal;
    case right_hand:
      return right_middle_proximal;
    default:
      break;
  }
  for (std::size_t i = 0; i < humanoid_bone_count; ++i)
    if (bone_rows[i].parent == bone) return static_cast<HumanoidBone>(i);
  return std::nullopt;
}

bool is_required(HumanoidBone bone) {
  if (bone == left_toes || bone == right_toes || bone == left_shoulder || bone == right_shoulder) return false;
  return bone == hips || bone == spine || bone == head ||
         (index_of(bone) >= index_of(left_upper_leg) && index_of(bone) <= index_of(right_hand));
}

}  // namespace sinew
