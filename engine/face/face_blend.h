#pragma once
/// Two faces of the same vertices, and what lies between them.

#include <span>

#include "engine/model/face.h"

namespace sinew {

/// Gives every rig a delta wherever one of them has one, so that they can be blended; all have the same vertices.
void give_same_signals(std::span<FaceRig* const> rigs);

/// All numbers on the way from `a` (0) to `b` (1), which have deltas of the same signals at the same vertices.
FaceRig blended_face(const FaceRig& a, const FaceRig& b, double t);

}  // namespace sinew
