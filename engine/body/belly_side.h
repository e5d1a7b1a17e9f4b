#pragma once
/// Which way a muscle's belly looks on a given model.

#include "engine/body/muscle_atlas.h"
#include "engine/deform/muscle_region.h"
#include "engine/rig/humanoid.h"
#include "engine/rig/joint_angle.h"

namespace sinew {

/// The direction of `side` for a muscle of which `bone` and `child` are known, rest space; its part along the limb is
/// not removed. `bend`: the angle at the child, if one is measured there. `left`: the limb is one of the left side.
/// `otherwise` stands in where the rest pose shows no bend or the model no fingers, and where the body's front or back
/// would run along the limb.
Vec3 belly_direction(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global,
                     const Muscle& muscle, const std::optional<JointAngle>& bend, bool left, BellySide side,
                     BellySide otherwise);

}  // namespace sinew
