#pragma once
/// Where a motion is strongest.

#include <vector>

#include "engine/motion/library.h"

namespace sinew {

/// How far every frame is from the first: the root mean square, over all joints, of the angle between a joint's
/// rotation there and in the first frame; radians, [frames].
std::vector<double> deviations(const Motion& motion);

/// The time of the frame that deviates most, seconds; the first of several.
double find_apex(const Motion& motion);

/// Seconds of the clip's apex: as set, else as found in what is played, its curves or else its samples.
double apex_of(const StoredClip& clip);

}  // namespace sinew
