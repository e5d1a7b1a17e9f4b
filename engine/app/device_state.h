#pragma once
/// A frame's state on its way to the device.

#include "engine/app/stage.h"
#include "engine/gpu/gpu_deformer.h"

namespace sinew {

/// Writes a character's state where the next dispatch reads it, and its mesh where the frame has one of its own. Must
/// not run while the device still works on the last frame.
Result<void> load_state(const StagedCharacter& character, const CharacterState& state, GpuDeformer& deformer);

}  // namespace sinew
