#pragma once
/// The regions of a head's skin: engine/face/face_regions.json carried to every vertex.

#include "engine/face/head_skin.h"
#include "engine/model/face.h"

namespace sinew {

/// The face of the skin alone, without normals' deltas. `skin`: the rest positions, drawing units.
FaceRig skin_face(const HeadPlan& plan, const HeadTopology& topology, const HeadCage& cage,
                  const std::vector<Vec3>& skin);

/// The limits of engine/face/face_regions.json for a face of these scales; `nose_scale` is its nose's width over the
/// adult's.
FaceLimits face_limits(const FaceRig& face, double nose_scale);

/// Nothing of the lids may lie inside the eyeball, at rest either: moves such vertices out.
void push_out_of_eyes(const FaceRig& face, std::vector<Vec3>& skin);

}  // namespace sinew
