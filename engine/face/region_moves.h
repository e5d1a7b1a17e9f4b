#pragma once
/// How each region's weights become movements of the cage, and of the skin.

#include "engine/face/head_skin.h"
#include "engine/model/face.h"

namespace sinew {

/// The weights of a region in face_regions.json, by the half cage's points.
CageValues region_weights(const HeadCage& cage, const char* region);

/// Shares of the jaw's turn; `sealed`: with lips that stay closed.
CageValues jaw_weights(const HeadPlan& plan, const HeadCage& cage, bool sealed);

/// Adds the deltas of all linear signals to the skin's vertices.
void add_region_moves(const HeadPlan& plan, const HeadTopology& topology, const HeadCage& cage,
                      const std::vector<Vec3>& skin, FaceRig& face);

}  // namespace sinew
