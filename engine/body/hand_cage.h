#pragma once
/// A relaxed left hand, palm to +Z and thumb to +Y, as a coarse cage of quads.

#include <array>
#include <cstdint>

#include "engine/body/quad_cage.h"

namespace sinew {

constexpr std::size_t limb_ring_size = 12;

/// From the wrist to the tip of the middle finger as add_hand draws them, along the arm's axis, metres.
constexpr double drawn_hand_length = 0.1700;

/// A ring of the arm's cage: vertex k lies in the direction of k * 30 degrees, from +Y over +Z.
using LimbRing = std::array<std::uint32_t, limb_ring_size>;

/// Extends the cage from the arm's last ring by palm, fingers and thumb. The wrist's centre lies on the x axis at
/// `wrist_x`; metres.
void add_hand(QuadCage& cage, const LimbRing& ring, double wrist_x);

/// A point of the hand's surface moved by what is too small for the cage: knuckles, the balls of the palm. Metres, in
/// the measures of add_hand; points before the wrist hardly move.
Vec3 with_hand_relief(const Vec3& position, double wrist_x);

}  // namespace sinew
