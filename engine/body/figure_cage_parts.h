#pragma once
/// The parts of a figure's cage, from the trunk outwards: each takes the loop that it grows from.

#include <span>

#include "engine/body/figure_cage.h"

namespace sinew {

// The trunk's half ring has 5 edges on the front, 3 on the side and 5 on the back; the holes for arm, leg and neck have
// whole numbers of them on each side.
constexpr int front_edges = 5, side_edges = 3, neck_front_edges = 2, arm_hole_rows = 3;
constexpr std::size_t arm_ring = 12, leg_ring = 14;

/// The open loops of the trunk.
struct TrunkLoops {
  Loop arm;   ///< [12] from the front lower corner back, up, forward, down
  Loop leg;   ///< [14] from the front outer corner inwards, back, outwards, forward
  Loop neck;  ///< [8] half of it, from the front over the side to the back
};

TrunkLoops add_trunk(HalfCage& cage, const MeasuredBody& body);
void add_head(HalfCage& cage, const MeasuredBody& body, const Loop& neck);
/// From the shoulder to the wrist; returns the last ring.
Loop add_arm(HalfCage& cage, const MeasuredBody& body, const Loop& shoulder);
void add_hand(HalfCage& cage, const MeasuredBody& body, const Loop& wrist);
/// From the groin to above the ankle; returns the last ring, [14]: front 3 edges from the outer corner, inner side 4,
/// back 3, outer side 4.
Loop add_leg(HalfCage& cage, const MeasuredBody& body, const Loop& groin);
void add_foot(HalfCage& cage, const MeasuredBody& body, const Loop& ankle);

/// The rings of a finger or toe, each `angles.size()` vertices at angles (radians) of the tube, from `loop` on; returns
/// all loops with `loop` first.
std::vector<Loop> add_digit(HalfCage& cage, const BodyPart& tube, Chain chain, const Loop& loop,
                            std::span<const double> stations, std::span<const double> angles);

}  // namespace sinew
