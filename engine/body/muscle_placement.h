#pragma once
/// Muscles on a given character: from what a scene says, or by preset (engine/definitions.md 6 and 7).

#include <string>
#include <vector>

#include "engine/deform/muscle_region.h"
#include "engine/model/scene.h"
#include "engine/rig/humanoid.h"
#include "engine/rig/joint_angle.h"

namespace sinew {

/// What placing a muscle asks about the character.
struct PlacementContext {
  const Model& model;
  const CharacterMesh& mesh;
  const RestShape& rest;
  const Humanoid& humanoid;
};

/// A muscle with its numbers resolved, the vertices that it swells, and the angle that drives it.
struct PlacedMuscle {
  Muscle muscle;
  MuscleRegion region;
  JointAngle driver;
  std::string note;  ///< what was decided otherwise than the preset says, for people; empty: nothing
};

/// Resolves what a scene says about a muscle. Fails as bad_input where a joint does not exist, where the driver has no
/// joint after it to measure an angle to, or where the numbers contradict each other. A region without vertices is no
/// failure: such a muscle moves nothing.
Result<PlacedMuscle> place_muscle(const PlacementContext& character, const MuscleSpec& spec);

/// What people should know about a placed muscle: its note, and a region of fewer than five vertices, which are too few
/// to swell as an arc.
std::vector<std::string> placement_problems(const PlacedMuscle& placed);

/// The muscles that a bare humanoid has: biceps and calf on both sides. What cannot be placed is left out and named in
/// `problems`. A model that is no complete humanoid has none.
std::vector<PlacedMuscle> default_muscles(const PlacementContext& character, std::vector<std::string>& problems);

}  // namespace sinew
