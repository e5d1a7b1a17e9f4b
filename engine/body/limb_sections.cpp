#include "engine/body/limb_sections.h"

#include <algorithm>
#include <array>
#include <span>

namespace sinew {
namespace {

/// A strand's cross section: a disc.
struct Disc {
  double x;       ///< metres along the axis
  double y, z;    ///< its centre: towards the thumb, towards the flexor side
  double radius;  ///< metres
};

/// A muscle, a tendon or a bone: discs strung along the arm, x rising. Its ends lie inside other strands.
using Strand = std::span<const Disc>;

// An athletic adult's arm, palm forward, its biceps at rest: 0.31 m round at mid upper arm, 0.30 m at the forearm's
// fullest, 0.17 m at the wrist.

constexpr Disc humerus[] = {{-0.080, 0.006, 0, 0.042}, {0.000, 0.006, 0, 0.040}, {0.060, 0.000, 0, 0.030},
                            {0.200, 0.000, 0, 0.026},  {0.260, 0.000, 0, 0.026}, {0.290, 0.000, 0, 0.029},
                            {0.330, 0.000, 0, 0.026}};
/// What closes the armpit: the tendons of the breast and of the back.
constexpr Disc armpit[] = {
    {-0.080, -0.014, 0, 0.038}, {-0.020, -0.013, 0, 0.035}, {0.030, -0.0105, 0.001, 0.031}, {0.080, -0.008, 0, 0.026}};

constexpr Disc deltoid_middle[] = {{-0.100, 0.002, 0, 0.024},     {-0.030, 0.030, 0.000, 0.0350},
                                   {0.025, 0.035, 0.001, 0.0345}, {0.075, 0.029, 0.004, 0.029},
                                   {0.115, 0.025, 0.005, 0.0225}, {0.150, 0.021, 0.006, 0.0150},
                                   {0.190, 0.018, 0.006, 0.006}};
constexpr Disc deltoid_front[] = {{-0.100, 0.000, 0.004, 0.022},  {-0.030, 0.010, 0.0235, 0.0325},
                                  {0.025, 0.015, 0.0260, 0.0310}, {0.070, 0.018, 0.0235, 0.0260},
                                  {0.105, 0.019, 0.019, 0.0210},  {0.145, 0.018, 0.014, 0.0130},
                                  {0.185, 0.017, 0.010, 0.005}};
constexpr Disc deltoid_rear[] = {{-0.100, 0.000, -0.006, 0.022},  {-0.030, 0.010, -0.0230, 0.0320},
                                 {0.025, 0.015, -0.0255, 0.0310}, {0.070, 0.019, -0.0215, 0.0250},
                                 {0.105, 0.021, -0.016, 0.0195},  {0.145, 0.020, -0.006, 0.0110},
                                 {0.180, 0.018, 0.000, 0.005}};

constexpr Disc biceps[] = {
    {0.010, -0.005, 0.016, 0.024},   {0.060, -0.004, 0.0225, 0.0275}, {0.105, -0.003, 0.0248, 0.0280},
    {0.145, -0.003, 0.0255, 0.0278}, {0.182, -0.002, 0.0240, 0.0250}, {0.210, -0.001, 0.0220, 0.0215},
    {0.240, 0.000, 0.0205, 0.0165},  {0.275, 0.002, 0.0185, 0.011},   {0.310, 0.004, 0.012, 0.006}};
constexpr Disc brachialis[] = {{0.095, 0.014, 0.004, 0.010},   {0.135, 0.016, 0.006, 0.0165},
                               {0.180, 0.0195, 0.007, 0.0205}, {0.225, 0.019, 0.007, 0.0205},
                               {0.265, 0.012, 0.007, 0.019},   {0.300, 0.004, 0.006, 0.014}};
constexpr Disc triceps_outer[] = {{0.010, 0.010, -0.018, 0.022},    {0.060, 0.013, -0.0255, 0.0260},
                                  {0.110, 0.0155, -0.0285, 0.0258}, {0.160, 0.015, -0.0275, 0.0220},
                                  {0.200, 0.012, -0.0245, 0.016},   {0.240, 0.007, -0.020, 0.010}};
constexpr Disc triceps_long[] = {{-0.010, -0.010, -0.020, 0.026},  {0.040, -0.011, -0.0255, 0.0275},
                                 {0.090, -0.015, -0.0275, 0.0275}, {0.140, -0.0170, -0.0280, 0.0260},
                                 {0.185, -0.014, -0.0265, 0.0215}, {0.220, -0.010, -0.0235, 0.016},
                                 {0.250, -0.006, -0.020, 0.010}};
constexpr Disc triceps_inner[] = {{0.080, -0.012, -0.006, 0.012},
                                  {0.140, -0.0175, -0.010, 0.0185},
                                  {0.195, -0.0190, -0.011, 0.0195},
                                  {0.240, -0.0165, -0.009, 0.0170},
                                  {0.275, -0.012, -0.006, 0.015}};
constexpr Disc triceps_tendon[] = {{0.170, 0.000, -0.018, 0.018},
                                   {0.220, 0.000, -0.0202, 0.0192},
                                   {0.260, -0.001, -0.0210, 0.0188},
                                   {0.290, -0.002, -0.0195, 0.0175}};

constexpr Disc inner_epicondyle[] = {{0.255, -0.020, -0.004, 0.012},
                                     {0.280, -0.0275, -0.006, 0.0130},
                                     {0.298, -0.025, -0.005, 0.012},
                                     {0.320, -0.014, -0.004, 0.010}};
constexpr Disc outer_epicondyle[] = {{0.260, 0.022, -0.002, 0.012},
                                     {0.287, 0.0270, -0.005, 0.0125},
                                     {0.305, 0.025, -0.005, 0.012},
                                     {0.325, 0.014, -0.004, 0.010}};
constexpr Disc olecranon[] = {{0.255, -0.002, -0.018, 0.012},
                              {0.277, -0.003, -0.0282, 0.0150},
                              {0.296, -0.003, -0.0288, 0.0145},
                              {0.330, -0.004, -0.020, 0.012}};

constexpr Disc brachioradialis[] = {{0.180, 0.010, 0.006, 0.010},    {0.240, 0.0225, 0.009, 0.0165},
                                    {0.290, 0.0275, 0.013, 0.0200},  {0.330, 0.0270, 0.018, 0.0215},
                                    {0.365, 0.0260, 0.0185, 0.0210}, {0.405, 0.0235, 0.0135, 0.0172},
                                    {0.455, 0.0195, 0.008, 0.0110},  {0.530, 0.017, 0.004, 0.006}};
constexpr Disc extensors[] = {{0.255, 0.020, -0.004, 0.013},    {0.300, 0.0240, -0.0125, 0.0185},
                              {0.345, 0.0230, -0.0205, 0.0210}, {0.385, 0.0190, -0.0210, 0.0190},
                              {0.430, 0.0155, -0.0175, 0.0155}, {0.490, 0.011, -0.011, 0.010},
                              {0.550, 0.006, -0.008, 0.007}};
constexpr Disc flexors[] = {{0.265, -0.022, 0.001, 0.011},    {0.305, -0.0235, 0.010, 0.019},
                            {0.345, -0.0225, 0.0165, 0.0240}, {0.390, -0.0190, 0.0160, 0.0222},
                            {0.435, -0.0155, 0.0125, 0.0180}, {0.490, -0.011, 0.008, 0.0120},
                            {0.550, -0.006, 0.007, 0.008}};
constexpr Disc flexor_of_the_ulna[] = {{0.285, -0.022, -0.006, 0.012},   {0.330, -0.0235, -0.008, 0.0175},
                                       {0.380, -0.0215, -0.008, 0.0172}, {0.430, -0.0188, -0.005, 0.0148},
                                       {0.490, -0.0165, -0.001, 0.011},  {0.550, -0.015, 0.001, 0.009}};
constexpr Disc flexors_middle[] = {{0.325, 0.000, 0.006, 0.014},   {0.380, 0.001, 0.0135, 0.0160},
                                   {0.430, 0.001, 0.0115, 0.0145}, {0.490, 0.000, 0.0085, 0.0125},
                                   {0.550, 0.000, 0.0080, 0.0115}, {0.585, 0.000, 0.0080, 0.0115}};
constexpr Disc radius_bone[] = {{0.310, 0.008, 0, 0.014},       {0.400, 0.0140, 0, 0.0140},
                                {0.480, 0.0175, 0, 0.0142},     {0.520, 0.0175, 0.001, 0.0145},
                                {0.545, 0.0160, 0.001, 0.0160}, {0.585, 0.0140, 0.001, 0.0160}};
constexpr Disc ulna[] = {{0.300, -0.005, -0.018, 0.013},   {0.380, -0.0100, -0.0145, 0.0125},
                         {0.460, -0.0145, -0.006, 0.0120}, {0.515, -0.0165, -0.003, 0.0125},
                         {0.540, -0.0175, -0.005, 0.0140}, {0.558, -0.0160, -0.002, 0.0130},
                         {0.585, -0.0150, 0.000, 0.0140}};
constexpr Disc between_the_bones[] = {{0.310, 0, 0.001, 0.027}, {0.350, 0, 0, 0.025},  {0.400, 0, 0, 0.020},
                                      {0.460, 0, 0, 0.0165},    {0.520, 0, 0, 0.0155}, {0.585, 0, 0, 0.0165}};

constexpr Strand strands[] = {humerus,        armpit,           deltoid_middle,   deltoid_front,      deltoid_rear,
                              biceps,         brachialis,       triceps_outer,    triceps_long,       triceps_inner,
                              triceps_tendon, inner_epicondyle, outer_epicondyle, olecranon,          brachioradialis,
                              extensors,      flexors,          flexors_middle,   flexor_of_the_ulna, radius_bone,
                              ulna,           between_the_bones};

/// How far the skin rounds off the grooves between strands, metres.
constexpr double skin_softness = 0.0038;

/// No section reaches as far from the axis, metres.
constexpr double farthest = 0.12;

/// Towards the wrist sections grow flat: this much wider than thick.
double flatness(double x) { return 1.0 + 0.5 * smoothstep01((x - 0.40) / 0.12); }

/// The strand at `x`: cubic Hermite with slopes from both neighbours. Beyond an end it shrinks like a ball.
Disc disc_at(Strand strand, double x) {
  if (x <= strand.front().x)
    return {x, strand.front().y, strand.front().z, strand.front().radius - (strand.front().x - x)};
  if (x >= strand.back().x) return {x, strand.back().y, strand.back().z, strand.back().radius - (x - strand.back().x)};
  const std::size_t after =
      static_cast<std::size_t>(std::ranges::upper_bound(strand, x, {}, &Disc::x) - strand.begin());
  const Disc &b = strand[after], &a = strand[after - 1];
  const Disc& earlier = strand[after == 1 ? 0 : after - 2];
  const Disc& later = strand[std::min(after + 1, strand.size() - 1)];
  const double step = b.x - a.x, t = (x - a.x) / step;
  const double in = step / (b.x - earlier.x), out = step / (later.x - a.x);
  const auto curve = [&](double Disc::*number) {
    const double slope_in = (b.*number - earlier.*number) * in, slope_out = (later.*number - a.*number) * out;
    const double rise = b.*number - a.*number;
    return a.*number +
           t * (slope_in + t * (3 * rise - 2 * slope_in - slope_out + t * (slope_in + slope_out - 2 * rise)));
  };
  return {x, curve(&Disc::y), curve(&Disc::z), curve(&Disc::radius)};
}

using Section = std::array<Disc, std::size(strands)>;

Section section_at(double x) {
  Section section;
  for (std::size_t i = 0; i < section.size(); ++i) section[i] = disc_at(strands[i], x);
  return section;
}

/// True where the skin over the discs lies outside `p`: the soft minimum of the distances to them is negative.
bool under_skin(const Section& section, const Vec2& p) {
  double sum = 0.0;
  for (const Disc& disc : section)
    sum += std::exp((disc.radius - glm::distance(p, Vec2{disc.y, disc.z})) / skin_softness);
  return sum > 1.0;
}

}  // namespace

Vec2 limb_section(double x, double angle) {
  const Section section = section_at(x);
  const Vec2 direction = glm::normalize(Vec2{flatness(x) * std::cos(angle), std::sin(angle)});
  double inside = 0.0, outside = farthest;
  while (outside - inside > 1e-9) {
    const double middle = 0.5 * (inside + outside);
    (under_skin(section, middle * direction) ? inside : outside) = middle;
  }
  return inside * direction;
}

double limb_section_angle(double x, const Vec2& yz) { return std::atan2(yz.y, yz.x / flatness(x)); }

}  // namespace sinew
