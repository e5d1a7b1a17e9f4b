#pragma once
/// A placed muscle as a scene states it, with every number written out.

#include "engine/body/muscle_placement.h"

namespace sinew {

/// What place_muscle() reads back as the same muscle on the same model, without a preset. Joints are called by their
/// humanoid names where that finds them, else by their nodes'. Fails as bad_input where a joint that has to be named
/// has no name of its own.
Result<MuscleSpec> explicit_muscle(const PlacementContext& character, const PlacedMuscle& placed);

}  // namespace sinew
