#pragma once
/// How much a limb's segment holds. engine/definitions.md 10.

#include "engine/body/limb_surface.h"

namespace sinew {

struct SegmentVolume {
  double from = 0.0, to = 1.0;  ///< the cutting planes, as shares of the way from joint to child
  double volume = 0.0;          ///< between them, cubic world units
  std::size_t open_edges = 0;   ///< of the surface between the planes; 0 where it is closed and the volume exact
};

/// Of the limb from `joint` to `child` between two planes across it, closed by them. An end at which no section is the
/// limb's alone (limb_section) moves inwards by hundredths, at most to the middle, and the report says where it came to
/// stand. Counts what hangs together with the section in the middle; sleeves and the like over it, or skin under it,
/// are surfaces of their own and do not count. Fails as limb_section() does.
Result<SegmentVolume> segment_volume(const PosedSurface& surface, int joint, int child, double from = 0.0,
                                     double to = 1.0);

}  // namespace sinew
