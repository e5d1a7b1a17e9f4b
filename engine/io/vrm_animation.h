#pragma once
/// VRM animations out: a humanoid's motion as .vrma, glTF with the extension VRMC_vrm_animation 1.0.

#include <map>
#include <string>

#include "engine/core/files.h"
#include "engine/core/result.h"
#include "engine/model/model.h"

namespace sinew {

/// The model's skeleton at rest in a T pose and its first clip. `bones`: VRM 1.0 bone to node. Of the clip are written
/// what the extension allows: rotations of bones and the translation of the hips. Fails as rig_glb does.
Result<Bytes> vrm_animation_glb(const Model& model, const std::map<std::string, int>& bones);

}  // namespace sinew
