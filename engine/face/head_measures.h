#pragma once
/// The measures that a head is drawn by: guide lines, widths, depths; their five sets by age and four skulls.
/// Units: crown to chin is 3.5; x to the side, y up from the underside of the chin, z forward from the middle of the
/// skull. Loomis, Drawing the Head and Hands, 1956; Yen, Animation of Human Faces, 1990, 4.1.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/math.h"
#include "engine/core/result.h"

namespace sinew {

/// Crown to chin, in the units of the measures.
constexpr double head_units = 3.5;

struct HeadMeasures {
  double height;  ///< metres, crown to chin
  // Guide lines, as heights.
  double hair_line, brow_height, eye_height, nose_height, mouth_height;
  // Eyes: the balls' distance from the middle, radius, foremost depth; the lids' margin from its ball's centre.
  double eye_spacing, eye_radius, eye_depth, lid_inner, lid_outer, lid_inner_rise, lid_outer_rise, lid_upper, lid_lower;
  double lid_thickness, lid_puff, iris_angle;  ///< thickness as a factor; iris_angle in degrees from the ball's axis
  double brow_ridge, brow_thickness, brow_inner_rise, brow_arch;
  double nose_width, nose_length, nose_tip_rise, nasion_depth, bridge_width;
  double mouth_width, upper_lip, lower_lip, lip_depth;
  double chin_width, chin_depth, chin_boss, jaw_width, jaw_height, jaw_depth;  ///< jaw: its angle
  double cheek_bone, cheek_puff;
  double ear_bottom, ear_top, ear_depth, ear_flare;  ///< flare in degrees from the skull
  double neck_width, neck_front, neck_back, neck_rise, neck_length;
  // Widths of the skull as factors, at the heights of skull_width_heights.
  double width_jaw, width_mouth, width_eyes, width_temples, width_crown;
  // Shares of the three measured skulls.
  double skull_adult, skull_child, skull_infant;
};

constexpr double skull_width_heights[] = {0.3, 1.0, 1.9, 2.7, 3.4};

/// A measure by its name, and between which values it makes a head.
struct HeadMeasureField {
  const char* name;
  double HeadMeasures::*member;
  double low, high;
};
std::span<const HeadMeasureField> head_measure_fields();

/// The measures of an age, 0 (adult) to 1 (infant), linear between the five stops.
HeadMeasures measures_of_age(double age);

/// 0, 0.25 ... 1 of "adult", "young", "adolescent", "child", "infant", or the number that the text is. Fails as usage.
Result<double> parse_age(std::string_view text);

/// How much of each outline a skull has; none: as measured.
using SkullWeights = std::map<std::string, double>;

/// square, round, wide, narrow.
std::span<const std::string> skull_names();

/// "round", or "round=0.5,wide=0.2" with weights from 0 to 1. Fails as usage.
Result<SkullWeights> parse_skull(std::string_view text);

/// Changes the outline of the skull and what follows it; a measure that would leave its range stops at its end.
void apply_skull(const SkullWeights& skull, HeadMeasures& measures);

/// "NAME=VALUE" set in the measures. Fails as usage where the text has not that form, as bad_input where there is no
/// such measure or the value is out of its range.
Result<void> apply_measure(std::string_view text, HeadMeasures& measures);

/// One measure. Fails as bad_input where there is none of that name, or the value is out of its range.
Result<void> set_measure(std::string_view name, double value, HeadMeasures& measures);

/// Fails as bad_input where measures cross: guide lines out of their order, an eye that leaves the face, a mouth wider
/// than the jaw.
Result<void> check_measures(const HeadMeasures& measures);

/// A head as a small file of its own, and back. Measures that the text does not give are an adult's. Fails as bad_input
/// with the place in the file.
std::string measures_text(const HeadMeasures& measures);
Result<HeadMeasures> parse_measures(std::string_view text, const std::string& name);

/// Radii of a bare skull: [heights][13], theta 0, 15 ... 180 degrees from the front.
struct SkullSections {
  std::vector<double> heights;
  std::vector<std::vector<double>> radii;
};
/// The measured skulls mixed by their shares, which need not sum to 1.
SkullSections skull_sections(const HeadMeasures& measures);

}  // namespace sinew
