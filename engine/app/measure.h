#pragma once
/// Limbs measured on a stage: `sinew info --girth`, `--volume`.

#include "engine/app/stage.h"
#include "engine/body/girth_meter.h"
#include "engine/body/volume_meter.h"

namespace sinew {

/// Of the limb from `joint` (a node's or a humanoid bone's name) to the joint after it, on the first character that has
/// it, posed and swollen as at the first frame. Each fails as bad_input where no character has the joint, where no
/// joint comes after it, or as limb_section() does.
Result<Girth> measure_girth(const Stage& stage, const std::string& joint, double at);
Result<SegmentVolume> measure_volume(const Stage& stage, const std::string& joint);

}  // namespace sinew
