#pragma once
/// The parts of the head's cage, in the order in which they are added: each may use the points of those before it.

#include "engine/face/head_cage.h"

namespace sinew {

inline CagePoint eye_point(int ring, int place) { return {HeadPart::eye, ring, (place + 16) % 16}; }
inline CagePoint nose_point(int ring, int place) { return {HeadPart::nose, ring, place}; }
inline CagePoint mouth_point(int ring, int place) { return {HeadPart::mouth, ring, place}; }
inline CagePoint chin_point(int column, int row) { return {HeadPart::chin, column, row}; }
inline CagePoint forehead_point(int row, int place) { return {HeadPart::forehead, row, place}; }
inline CagePoint side_point(int column, int row) { return {HeadPart::side, column, row}; }
inline CagePoint ear_point(int ring, int place) { return {HeadPart::ear, ring, place}; }
inline CagePoint neck_point(int ring, int place) { return {HeadPart::neck, ring, place}; }

constexpr int eye_places = 16, mouth_places = 11, cheek_rows = 11, side_rows = 17, side_columns = 8, ear_places = 18;
/// Rows of the side columns between which the ear stands.
constexpr int ear_first_row = 3, ear_last_row = 10;

/// A point of the cheek's grid, column 0-3, row 0-10; the outer ones belong to eye, nose, mouth and chin.
CagePoint cheek_point(int column, int row);
/// What stands in front of the side columns, row 0-16.
CagePoint side_front(int row);
/// The lower end of face and sides, 0 (chin) to 14 (nape): where the neck begins.
CagePoint jaw_rim(int place);
/// The edge of the hole in which the ear stands, in the order of the ear's places.
CagePoint ear_hole(int place);

void add_eye(const HeadPlan& plan, HeadCage& cage);
void add_nose(const HeadPlan& plan, HeadCage& cage);
void add_mouth(const HeadPlan& plan, HeadCage& cage);
void add_nostril(HeadCage& cage);
void add_cheek(const HeadPlan& plan, HeadCage& cage);
void add_forehead(const HeadPlan& plan, HeadCage& cage);
void add_sides(const HeadPlan& plan, HeadCage& cage);
void add_cap(const HeadPlan& plan, HeadCage& cage);
void add_ear(const HeadPlan& plan, HeadCage& cage);
void add_neck(const HeadPlan& plan, HeadCage& cage);
/// Fills the cheek beside the mouth.
void puff_cheek(const HeadPlan& plan, HeadCage& cage);
/// Takes the creases out of the cheek between mouth and jaw: their rows come from unlike curves.
void relax_cheek(HeadCage& cage);

}  // namespace sinew
