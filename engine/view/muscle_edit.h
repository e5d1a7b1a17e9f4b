#pragma once
/// Edits of a character's muscles. No interface here.

#include "engine/app/stage.h"

namespace sinew {

/// The two angles of a muscle's driver that its activation runs between.
enum class MuscleAngle { rest, reference };

/// Sets one of them, degrees from 0 to 180, at least one degree away from the other, which `placed` tells.
void set_muscle_angle(MuscleSpec& spec, const Muscle& placed, MuscleAngle angle, double degrees);

/// True where the character has a muscle of the preset's name.
bool has_muscle(const Character& character, MusclePreset preset, MuscleSide side);

/// Adds a preset's muscle with every number written out. Fails as bad_input where the model has no place for it.
Result<void> add_muscle(Character& character, const StagedCharacter& staged, MusclePreset preset, MuscleSide side);

/// Adds every preset that fits, as `sinew muscles --all` does; muscles that are there stay as they are. The number of
/// those that came. Fails as bad_input where the model has no place for any.
Result<int> add_fitting_muscles(Character& character, const StagedCharacter& staged);

}  // namespace sinew
