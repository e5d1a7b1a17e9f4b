#pragma once
/// The humanoid bones of VRM 1.0: their names and how they hang together.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace sinew {

/// The bones of a VRM 1.0 humanoid. Left and right are the character's own.
enum class HumanoidBone : std::uint8_t {
  hips,
  spine,
  chest,
  upper_chest,
  neck,
  head,
  left_eye,
  right_eye,
  jaw,
  left_upper_leg,
  left_lower_leg,
  left_foot,
  left_toes,
  right_upper_leg,
  right_lower_leg,
  right_foot,
  right_toes,
  left_shoulder,  ///< the clavicle
  left_upper_arm,
  left_lower_arm,
  left_hand,
  right_shoulder,
  right_upper_arm,
  right_lower_arm,
  right_hand,
  left_thumb_metacarpal,
  left_thumb_proximal,
  left_thumb_distal,
  left_index_proximal,
  left_index_intermediate,
  left_index_distal,
  left_middle_proximal,
  left_middle_intermediate,
  left_middle_distal,
  left_ring_proximal,
  left_ring_intermediate,
  left_ring_distal,
  left_little_proximal,
  left_little_intermediate,
  left_little_distal,
  right_thumb_metacarpal,
  right_thumb_proximal,
  right_thumb_distal,
  right_index_proximal,
  right_index_intermediate,
  right_index_distal,
  right_middle_proximal,
  right_middle_intermediate,
  right_middle_distal,
  right_ring_proximal,
  right_ring_intermediate,
  right_ring_distal,
  right_little_proximal,
  right_little_intermediate,
  right_little_distal,
};

constexpr std::size_t humanoid_bone_count = 55;

/// [humanoid_bone_count] the node of each bone, -1: absent.
using BoneNodes = std::array<int, humanoid_bone_count>;

/// The bone's index in arrays of humanoid_bone_count.
constexpr std::size_t index_of(HumanoidBone bone) { return static_cast<std::size_t>(bone); }

/// The VRM 1.0 spelling, for example "leftUpperArm".
std::string_view humanoid_name(HumanoidBone bone);

/// The bone of a VRM 1.0 name, letter by letter, or nothing.
std::optional<HumanoidBone> humanoid_bone(std::string_view vrm_name);

/// The bone above this one in the VRM hierarchy; nothing above the hips.
std::optional<HumanoidBone> parent_bone(HumanoidBone bone);

/// The same bone on the other side; a bone of the middle is its own.
HumanoidBone mirrored_bone(HumanoidBone bone);

/// The bone that this one points at: hips to spine to ... head, shoulder to ... hand to middle finger, upper leg to ...
/// toes, along each finger. Nothing after head, jaw, eyes, toes and fingertips.
std::optional<HumanoidBone> next_on_chain(HumanoidBone bone);

/// VRM does not call a model a humanoid without these 15.
bool is_required(HumanoidBone bone);

}  // namespace sinew
