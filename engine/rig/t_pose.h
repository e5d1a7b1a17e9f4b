#pragma once
/// A model re-rested: its rest pose and bind pose become the T pose that VRM 1.0 asks for.

#include <span>

#include "engine/core/result.h"
#include "engine/model/model.h"
#include "engine/rig/humanoid.h"

namespace sinew {

/// The model standing in a T pose: front +Z, arms along X, legs straight down, feet level as they were, the lowest
/// vertex of its skinned meshes at y = 0. Upper arms, lower arms and hands are turned the shortest way, so that palms
/// that faced the thighs face down; fingers, trunk and head keep their pose. Vertices, normals and morph targets are
/// those that the skin makes of the pose, and every skin is bound to it. Without clips: their first frame would be
/// another pose. Fails as bad_input where the model is no complete humanoid, or where two nodes skin one mesh by
/// different skins.
Result<Model> in_t_pose(const Model& model, const Humanoid& humanoid);

}  // namespace sinew
