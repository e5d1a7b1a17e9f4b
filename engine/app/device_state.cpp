#include "engine/app/device_state.h"

namespace sinew {

Result<void> load_state(const StagedCharacter& character, const CharacterState& state, GpuDeformer& deformer) {
  if (state.mesh)
    if (auto ok = deformer.set_mesh(*state.mesh, character.rest); !ok) return ok;
  deformer.set_state({state.palette, state.morph_weights, state.activations, state.face ? &*state.face : nullptr});
  return {};
}

}  // namespace sinew
