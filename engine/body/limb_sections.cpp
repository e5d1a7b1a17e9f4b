#include "engine/body/limb_sections.h"

#include <algorithm>
#include <iterator>

namespace sinew {
namespace {

/// How far the surface lies from the axis on four sides; between them a section is four quarters of ellipses.
struct Section {
  double x;                                ///< metres along the axis
  double thumb, flexor, little, extensor;  ///< metres towards +Y, +Z, -Y, -Z
};

/// The four outlines of an athletic adult's arm, palm forward. Girths were laid beside a measured body of 1.8 m
/// (MakeHuman's CC0 figure: upper arm 0.31 m, elbow and forearm 0.26 m, wrist 0.14 m at the joint).
constexpr Section sections[] = {{-0.062, 0.014, 0.014, 0.014, 0.014},    {-0.052, 0.033, 0.033, 0.031, 0.033},
                                {-0.034, 0.050, 0.049, 0.045, 0.049},    {-0.010, 0.060, 0.058, 0.0495, 0.057},
                                {0.018, 0.066, 0.061, 0.0495, 0.060},    {0.045, 0.066, 0.060, 0.0475, 0.059},
                                {0.072, 0.062, 0.056, 0.046, 0.057},     {0.099, 0.053, 0.051, 0.0445, 0.057},
                                {0.126, 0.0455, 0.050, 0.045, 0.057},    {0.153, 0.0445, 0.0525, 0.0455, 0.056},
                                {0.180, 0.0450, 0.0545, 0.0445, 0.0525}, {0.207, 0.0440, 0.0525, 0.0425, 0.047},
                                {0.232, 0.0420, 0.047, 0.0405, 0.0415},  {0.252, 0.0405, 0.042, 0.0395, 0.038},
                                {0.275, 0.0405, 0.040, 0.0400, 0.037},   {0.300, 0.0405, 0.040, 0.0385, 0.037},
                                {0.320, 0.0445, 0.0415, 0.0400, 0.037},  {0.343, 0.049, 0.0425, 0.043, 0.037},
                                {0.367, 0.0485, 0.042, 0.0440, 0.037},   {0.391, 0.045, 0.040, 0.0425, 0.036},
                                {0.419, 0.0405, 0.037, 0.039, 0.034},    {0.447, 0.036, 0.033, 0.035, 0.031},
                                {0.475, 0.033, 0.029, 0.032, 0.0275},    {0.502, 0.031, 0.026, 0.030, 0.0245},
                                {0.526, 0.0300, 0.0235, 0.029, 0.0215},  {0.546, 0.030, 0.0215, 0.029, 0.0195},
                                {0.560, 0.0305, 0.0205, 0.0295, 0.0185}, {0.580, 0.034, 0.0190, 0.032, 0.0170}};

/// A swelling or a hollow that the four outlines cannot say: a Gaussian in x and in angle.
struct Relief {
  double x, angle;       ///< metres; degrees as in limb_section
  double length, width;  ///< standard deviations, metres and degrees
  double height;         ///< metres outwards
};

constexpr Relief reliefs[] = {
    {0.176, 88, 0.040, 32, 0.0085},    // biceps
    {0.122, 320, 0.032, 22, 0.0065},   // triceps, lateral head
    {0.150, 236, 0.046, 26, 0.0065},   // triceps, long head
    {0.215, 276, 0.026, 22, -0.0040},  // triceps tendon
    {0.190, 10, 0.042, 15, -0.0055},   // groove between biceps and triceps, outer side
    {0.175, 166, 0.055, 15, -0.0050},  // the same, inner side
    {0.045, 88, 0.020, 14, -0.0030},   // deltoid's front edge, down to where it ends
    {0.075, 66, 0.020, 14, -0.0055},
    {0.104, 44, 0.018, 14, -0.0055},
    {0.060, 296, 0.020, 15, -0.0030},  // deltoid's rear edge
    {0.096, 336, 0.018, 14, -0.0035},
    {0.302, 268, 0.019, 22, 0.0085},  // olecranon, and the hollows on both sides of it
    {0.300, 224, 0.020, 17, -0.0035},
    {0.302, 314, 0.020, 17, -0.0040},
    {0.279, 188, 0.020, 26, 0.0030},   // medial epicondyle
    {0.290, 350, 0.016, 18, 0.0012},   // lateral epicondyle
    {0.302, 92, 0.016, 26, -0.0050},   // crook of the elbow
    {0.346, 44, 0.034, 24, 0.0065},    // brachioradialis
    {0.365, 140, 0.044, 26, 0.0060},   // flexors
    {0.370, 312, 0.042, 22, 0.0055},   // extensors
    {0.375, 242, 0.060, 15, -0.0035},  // along the ulna
    {0.385, 94, 0.050, 14, -0.0035},   // between brachioradialis and flexors
    {0.390, 352, 0.045, 14, -0.0025},  // between brachioradialis and extensors
    {0.545, 222, 0.010, 20, 0.0030},   // head of the ulna
    {0.540, 330, 0.014, 22, 0.0012},   // styloid of the radius
};

/// Cubic Hermite through the table with slopes from both neighbours; held beyond its ends.
Section section_at(double x) {
  x = std::clamp(x, std::begin(sections)->x, std::prev(std::end(sections))->x);
  const Section* after = std::upper_bound(std::begin(sections) + 1, std::prev(std::end(sections)), x,
                                          [](double value, const Section& s) { return value < s.x; });
  const Section* before = after - 1;
  const Section* earlier = before == std::begin(sections) ? before : before - 1;
  const Section* later = after == std::prev(std::end(sections)) ? after : after + 1;
  const double step = after->x - before->x, t = (x - before->x) / step;
  const double in = step / (after->x - earlier->x), out = step / (later->x - before->x);
  const auto curve = [&](double Section::*side) {
    const double slope_in = (after->*side - earlier->*side) * in, slope_out = (later->*side - before->*side) * out;
    const double rise = after->*side - before->*side;
    return before->*side +
           t * (slope_in + t * (3 * rise - 2 * slope_in - slope_out + t * (slope_in + slope_out - 2 * rise)));
  };
  return {x, curve(&Section::thumb), curve(&Section::flexor), curve(&Section::little), curve(&Section::extensor)};
}

double relief_at(double x, double angle) {
  double height = 0.0;
  for (const Relief& relief : reliefs) {
    const double along = (x - relief.x) / relief.length;
    const double turn = std::remainder(angle * radians_to_degrees - relief.angle, 360.0) / relief.width;
    height += relief.height * std::exp(-0.5 * (along * along + turn * turn));
  }
  return height;
}

Vec2 half_axes(const Section& section, const Vec2& direction) {
  return {direction.x >= 0 ? section.thumb : section.little, direction.y >= 0 ? section.flexor : section.extensor};
}

}  // namespace

Vec2 limb_section(double x, double angle) {
  const Vec2 direction{std::cos(angle), std::sin(angle)};
  const Vec2 axes = half_axes(section_at(x), direction);
  const Vec2 outwards = glm::normalize(Vec2{direction.x * axes.y, direction.y * axes.x});
  return direction * axes + relief_at(x, angle) * outwards;
}

double limb_section_angle(double x, const Vec2& yz) {
  const Vec2 axes = half_axes(section_at(x), yz);
  return std::atan2(yz.y / axes.y, yz.x / axes.x);
}

}  // namespace sinew
