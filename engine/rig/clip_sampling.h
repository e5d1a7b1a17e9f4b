#pragma once
/// Animation sampling as glTF 2.0 defines it (Specification 3.11 and appendix C).

#include "engine/core/result.h"
#include "engine/model/model.h"
#include "engine/model/scene.h"
#include "engine/rig/pose.h"

namespace sinew {

/// Writes the clip's properties at `seconds` into the pose; what the clip does not animate stays as it was. Before the
/// first key and after the last one each channel holds its end value.
void sample_clip(const Clip& clip, double seconds, Pose& pose);

/// The clip that was chosen, an index into the model's clips, or -1 for none. Fails as bad_input naming the clips there
/// are.
Result<int> find_clip(const Model& model, const ClipChoice& choice);

}  // namespace sinew
