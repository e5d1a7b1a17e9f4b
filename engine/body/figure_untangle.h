#pragma once
/// The last step of laying a mesh on a surface: where the surface is too narrow for it, between toes and fingers, quads
/// may have folded over; here they are pulled flat.

#include "engine/body/figure_relax.h"

namespace sinew {

/// Moves the corners of folded quads towards their neighbours' mean, off the field's surface if need be, until no quad
/// is folded in itself or against the one beside it. Returns how many still are.
std::size_t untangle(HalfSurface& surface, const Neighbours& neighbours);

}  // namespace sinew
