#pragma once
/// How far it is round a limb. engine/definitions.md 10.

#include "engine/body/limb_surface.h"

namespace sinew {

/// World units.
struct Girth {
  double length = 0.0;  ///< of the section itself, along every hollow
  double tape = 0.0;    ///< of its convex hull, as a tape measure lies: never more than `length`
};

/// Of a section that limb_section() cut.
Girth section_girth(const LimbSection& section);

/// Of the limb from `joint` to `child`, at the share `at` of the way. Fails as limb_section() does.
Result<Girth> limb_girth(const PosedSurface& surface, int joint, int child, double at);

}  // namespace sinew
