#pragma once
/// Animation sampling as glTF 2.0 defines it (Specification 3.11 and appendix C).

#include "engine/model/model.h"
#include "engine/rig/pose.h"

namespace sinew {

/// Writes the clip's properties at `seconds` into the pose; what the clip does not animate stays as it was. Before the
/// first key and after the last one each channel holds its end value.
void sample_clip(const Clip& clip, double seconds, Pose& pose);

}  // namespace sinew
