#pragma once
/// What the joint names of the common skeletons say about the humanoid bones.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sinew {

enum class Side : std::uint8_t { middle, left, right };

/// What a joint's name can speak of. Two words mean different bones in different skeletons; the hierarchy decides.
enum class BodyPart : std::uint8_t {
  hips,
  spine,  ///< anything between hips and neck
  neck,
  head,
  jaw,
  eye,
  clavicle,
  clavicle_or_upper_arm,  ///< "LeftShoulder"
  upper_arm,
  lower_arm,
  hand,
  upper_leg,
  upper_or_lower_leg,  ///< "LeftLeg"
  lower_leg,
  foot,
  toes,
  thumb,
  index,
  middle,
  ring,
  little,
};

/// A joint's name, understood.
struct NameReading {
  BodyPart part = BodyPart::hips;
  Side side = Side::middle;
  int ordinal = 0;       ///< of a finger's joint, counted from the palm in the file's own way; 0: a metacarpal
  int doubt = 0;         ///< 0: the part's own name; the higher, the sooner another name is preferred
  bool counted = false;  ///< a number that the part's name does not have was dropped from the end, "Hand_08"
  std::string word;      ///< what was found in the tables
};

/// Reads names of VRM, Unity, Godot, H-Anim 1 and 2, Mixamo, MakeHuman, Unreal, Blender and Rigify, Biped, BVH files
/// (CMU and others), Poser, Daz, Reallusion, Quaternius and KayKit: engine/definitions.md 8. Namespaces, exporters'
/// prefixes and counters, separators and letter case do not matter. Only whole names are known, so that controls, twist
/// and tip bones
/// ("control-foot-roll.l", "Head_end") mean nothing.
std::optional<NameReading> read_joint_name(std::string_view name);

}  // namespace sinew
