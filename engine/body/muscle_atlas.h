#pragma once
/// The muscles that a scene can name by preset: where each lies on any humanoid, what swells it, and why those numbers.
/// engine/definitions.md 7.

#include <optional>
#include <span>
#include <string_view>

#include "engine/model/scene.h"
#include "engine/rig/humanoid_bone.h"

namespace sinew {

/// Which side of its limb a belly looks to, found on each model from its joints.
enum class BellySide {
  flexor,       ///< the inside of the bend that the rest pose shows at the segment's far end
  extensor,     ///< the outside of that bend
  front,        ///< the body's
  back,         ///< the body's
  palm,         ///< where the palm looks
  front_outer,  ///< between the body's front and its side, as one half of the chest looks
  outer,        ///< away from the trunk: up on an arm held out, sideways on one that hangs
};

/// A joint whose angle swells a muscle. Bones are those of the left side.
struct AtlasDriver {
  HumanoidBone joint;
  std::optional<HumanoidBone> before;  ///< measured from this joint; nothing: from the one before the driver
  double reference_angle;              ///< degrees at which the whole peak is reached
};

/// One muscle, in units of the limb that carries it: L its length, r its radius at the region's centre. Bones are those
/// of the left side.
struct AtlasMuscle {
  MusclePreset preset;
  HumanoidBone bone, child;              ///< the segment; for a spine bone see muscle_placement
  std::span<const AtlasDriver> drivers;  ///< the first that the model has; a scene may name another
  BellySide side;
  BellySide otherwise;  ///< where the model does not tell `side`: no bend, no fingers, a limb that runs along it
  double from, to;      ///< along the segment
  double spread;        ///< degrees to either side
  double peak;          ///< in r
  double sigma_along;   ///< in L
  double sigma_across;  ///< in r
  double full_range;  ///< degrees: a rest pose that leaves less between rest and reference angle has so much less peak
  std::string_view reason;  ///< anatomy behind the numbers
};

/// In the order of MusclePreset.
std::span<const AtlasMuscle> muscle_atlas();

const AtlasMuscle& atlas_muscle(MusclePreset preset);

}  // namespace sinew
