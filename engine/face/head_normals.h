#pragma once
/// How a head is shaded, at rest and moved.

#include "engine/face/head.h"

namespace sinew {

/// Fills in what each signal adds to the normals, so that at the region's limit they are those of the surface: a
/// compute pass sees one vertex at a time and cannot ask its neighbours.
void add_normal_deltas(Head& head);

}  // namespace sinew
