#include "engine/body/hand_cage.h"

#include <iterator>
#include <vector>

namespace sinew {
namespace {

constexpr std::size_t finger_ring_size = 6;
using FingerRing = std::array<std::uint32_t, finger_ring_size>;

/// A cross section of the palm: where it lies between wrist and fingers, its two edges, and how far palm and back are
/// from its middle.
struct PalmSection {
  double along;                                        ///< share of the way from the wrist to the fingers' roots
  double thumb_edge, little_edge, palm, back, middle;  ///< metres; `middle` is the section's z
};

constexpr PalmSection palm_sections[] = {
    {0.13, 0.0325, -0.0310, 0.0176, 0.0162, 0.0005},
    {0.28, 0.0395, -0.0342, 0.0178, 0.0150, 0.0010},
    {0.64, 0.0398, -0.0382, 0.0150, 0.0133, 0.0005},
    {0.85, 0.0388, -0.0385, 0.0134, 0.0122, 0.0000},
};

/// A swelling of the hand between the cage's columns: a Gaussian round a place, raised along z on one side of the hand.
struct HandRelief {
  double x, y, radius, height;  ///< metres from the wrist
  bool on_palm;
};

constexpr HandRelief hand_reliefs[] = {
    {0.039, 0.027, 0.015, 0.0110, true},                                          // ball of the thumb
    {0.032, -0.024, 0.014, 0.0075, true},  {0.054, -0.028, 0.014, 0.0060, true},  // heel of the little finger
    {0.062, -0.002, 0.013, -0.0045, true}, {0.040, 0.001, 0.012, -0.0040, true},  // hollow
    {0.086, 0.028, 0.009, 0.0012, true},   {0.090, 0.009, 0.009, 0.0012, true},   // pads below the fingers
    {0.087, -0.011, 0.009, 0.0012, true},  {0.077, -0.030, 0.009, 0.0012, true},
    {0.086, 0.029, 0.008, 0.0034, false},  {0.089, 0.009, 0.008, 0.0042, false},  // knuckles
    {0.085, -0.011, 0.008, 0.0036, false}, {0.077, -0.029, 0.008, 0.0034, false},
};

/// Relief counts in full this far from the hand's middle plane, metres.
constexpr double relief_depth = 0.010;

/// The palm ends in a wall of 4 x 2 cells, one pair a finger: five columns from the index to the little finger.
struct WebColumn {
  double y, palm_x, middle_x, back_x, middle_z;  ///< metres from the wrist
};

constexpr WebColumn web_columns[] = {{0.0386, 0.093, 0.091, 0.088, 0.0010},
                                     {0.0189, 0.100, 0.097, 0.092, 0.0000},
                                     {-0.0010, 0.101, 0.098, 0.093, -0.0005},
                                     {-0.0204, 0.093, 0.091, 0.087, 0.0010},
                                     {-0.0376, 0.084, 0.082, 0.079, 0.0030}};
constexpr double web_half_thickness = 0.0090;

/// A finger as it leaves the palm's wall, bent a little in its three joints.
struct Finger {
  double root_x, root_y, root_z;  ///< middle of its two cells, metres from the wrist
  double length;                  ///< from there to the tip
  double half_width;              ///< at its root
  double spread;                  ///< degrees towards the thumb
  std::array<double, 3> flexion;  ///< degrees at knuckle, middle and end joint
};

constexpr Finger fingers[] = {{0.0940, 0.0288, 0.0005, 0.0765, 0.0098, 2.2, {9, 17, 10}},
                              {0.0975, 0.0090, -0.0005, 0.0865, 0.0101, 0.3, {14, 22, 13}},
                              {0.0945, -0.0108, 0.0000, 0.0805, 0.0097, -1.2, {17, 28, 16}},
                              {0.0870, -0.0294, 0.0020, 0.0640, 0.0087, -3.5, {19, 31, 18}}};

/// A ring of a finger at a share of its length; sizes in half widths of the root.
struct FingerStation {
  double along, width, palm, back;
};

constexpr FingerStation finger_stations[] = {
    {0.14, 0.90, 0.98, 0.95}, {0.27, 0.93, 1.00, 0.88}, {0.39, 0.99, 0.88, 0.96}, {0.51, 0.91, 0.94, 0.82},
    {0.65, 0.92, 0.80, 0.84}, {0.77, 0.87, 0.90, 0.70}, {0.90, 0.79, 0.80, 0.56}, {0.98, 0.46, 0.44, 0.34}};
constexpr double finger_joints[] = {0.0, 0.39, 0.65};  ///< shares of the length

/// A ring of the thumb, by the points on the nail's side and on the pad's, metres from the wrist, and half its width
/// across them.
struct ThumbStation {
  Vec3 nail, pad;
  double half_width;
};

constexpr ThumbStation thumb_stations[] = {{{0.0310, 0.0490, 0.0075}, {0.0610, 0.0445, 0.0075}, 0.0118},
                                           {{0.0455, 0.0595, 0.0155}, {0.0670, 0.0480, 0.0170}, 0.0112},
                                           {{0.0605, 0.0685, 0.0250}, {0.0725, 0.0525, 0.0255}, 0.0103},
                                           {{0.0750, 0.0720, 0.0330}, {0.0815, 0.0575, 0.0330}, 0.0093},
                                           {{0.0890, 0.0730, 0.0390}, {0.0930, 0.0570, 0.0390}, 0.0100},
                                           {{0.1020, 0.0710, 0.0435}, {0.1040, 0.0575, 0.0435}, 0.0090},
                                           {{0.1105, 0.0675, 0.0460}, {0.1112, 0.0610, 0.0460}, 0.0048}};

/// Which cells of the palm are open for the thumb: the band after this ring, both cells of the thumb's side.
constexpr std::size_t thumb_band = 2;

/// The place on an oblong section: an ellipse squared a little, so that four fingers fit side by side.
Vec3 palm_point(const PalmSection& section, std::size_t k, double roots_x) {
  const double angle = static_cast<double>(k) * 2.0 * std::numbers::pi / limb_ring_size;
  const double across = std::cos(angle),
               depth = std::copysign(std::pow(std::abs(std::sin(angle)), 0.8), std::sin(angle));
  const double y =
      0.5 * (section.thumb_edge + section.little_edge + (section.thumb_edge - section.little_edge) * across);
  return {section.along * roots_x, y, section.middle + depth * (depth > 0 ? section.palm : section.back)};
}

/// The palm's end wall: [column][0 palm, 1 middle, 2 back].
using Wall = std::array<std::array<std::uint32_t, 3>, std::size(web_columns)>;

Wall add_wall(QuadCage& cage, const Vec3& wrist) {
  Wall wall;
  for (std::size_t i = 0; i < wall.size(); ++i) {
    const WebColumn& column = web_columns[i];
    const bool edge = i == 0 || i + 1 == wall.size();
    const double half = edge ? 0.75 * web_half_thickness : web_half_thickness;
    const double inset = edge ? std::copysign(0.0035, column.y) : 0.0;
    wall[i][0] = cage.add(wrist + Vec3{column.palm_x, column.y - inset, column.middle_z + half});
    wall[i][1] = cage.add(wrist + Vec3{column.middle_x, column.y, column.middle_z});
    wall[i][2] = cage.add(wrist + Vec3{column.back_x, column.y - inset, column.middle_z - half});
  }
  return wall;
}

/// The wall's outline in the order of a limb ring.
LimbRing outline(const Wall& wall) {
  return {wall[0][1], wall[0][0], wall[1][0], wall[2][0], wall[3][0], wall[4][0],
          wall[4][1], wall[4][2], wall[3][2], wall[2][2], wall[1][2], wall[0][2]};
}

void close_with_two_quads(QuadCage& cage, const FingerRing& ring) {
  cage.quads.push_back({ring[0], ring[1], ring[2], ring[5]});
  cage.quads.push_back({ring[5], ring[2], ring[3], ring[4]});
}

void bridge_palm(QuadCage& cage, const LimbRing& near, const LimbRing& far, bool open_for_thumb) {
  QuadCage band;
  band.bridge(near, far);
  const std::size_t last = band.quads.size() - 1;
  for (std::size_t k = 0; k <= last; ++k)
    if (!open_for_thumb || (k != 0 && k != last)) cage.quads.push_back(band.quads[k]);
}

/// Flexion of a finger at a share of its length, degrees: each joint bends over a tenth of the finger to either side.
double flexion_at(const Finger& finger, double along) {
  double degrees = finger.flexion[0];
  for (std::size_t joint = 1; joint < finger.flexion.size(); ++joint)
    degrees += finger.flexion[joint] * smoothstep01((along - finger_joints[joint] + 0.1) / 0.2);
  return degrees;
}

void add_finger(QuadCage& cage, const Finger& finger, const FingerRing& root, const Vec3& wrist) {
  constexpr double ring_angles[] = {60,  120, 180,
                                    240, 300, 0};  // palm thumb-side first, as the wall's cells are walked
  const double spread = finger.spread * degrees_to_radians;
  const Vec3 forwards{std::cos(spread), std::sin(spread), 0}, thumbwards{-std::sin(spread), std::cos(spread), 0};
  const Vec3 palmwards{0, 0, 1};
  Vec3 middle = wrist + Vec3{finger.root_x, finger.root_y, finger.root_z};
  double reached = 0.0;
  FingerRing near = root;
  for (const FingerStation& station : finger_stations) {
    const double step = flexion_at(finger, 0.5 * (reached + station.along)) * degrees_to_radians;
    middle += (station.along - reached) * finger.length * (std::cos(step) * forwards + std::sin(step) * palmwards);
    reached = station.along;
    const double here = flexion_at(finger, reached) * degrees_to_radians;
    const Vec3 up = std::cos(here) * palmwards - std::sin(here) * forwards;
    FingerRing ring;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const double angle = ring_angles[k] * degrees_to_radians, rise = std::sin(angle);
      const double depth = rise * (rise > 0 ? station.palm : station.back);
      ring[k] = cage.add(middle + finger.half_width * (std::cos(angle) * station.width * thumbwards + depth * up));
    }
    cage.bridge(near, ring);
    near = ring;
  }
  close_with_two_quads(cage, near);
}

void add_thumb(QuadCage& cage, const FingerRing& root, const Vec3& wrist) {
  constexpr double ring_angles[] = {60, 120, 180, 240, 300, 0};  // from the nail over the hand's back to the pad
  FingerRing near = root;
  for (std::size_t s = 0; s < std::size(thumb_stations); ++s) {
    const ThumbStation& station = thumb_stations[s];
    const ThumbStation& before = thumb_stations[s == 0 ? 0 : s - 1];
    const ThumbStation& after = thumb_stations[std::min(s + 1, std::size(thumb_stations) - 1)];
    const Vec3 forwards = after.nail + after.pad - before.nail - before.pad;
    const Vec3 to_nail = 0.5 * (station.nail - station.pad);
    const Vec3 sideways = station.half_width * glm::normalize(glm::cross(forwards, to_nail));
    FingerRing ring;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const double angle = ring_angles[k] * degrees_to_radians;
      ring[k] = cage.add(wrist + station.pad + (1.0 + std::cos(angle)) * to_nail + std::sin(angle) * sideways);
    }
    cage.bridge(near, ring);
    near = ring;
  }
  close_with_two_quads(cage, near);
}

}  // namespace

void add_hand(QuadCage& cage, const LimbRing& ring, double wrist_x) {
  const Vec3 wrist{wrist_x, 0, 0};
  std::vector<LimbRing> rings{ring};
  const Wall wall = add_wall(cage, wrist);
  const LimbRing roots = outline(wall);
  for (const PalmSection& section : palm_sections) {
    LimbRing& next = rings.emplace_back();
    for (std::size_t k = 0; k < next.size(); ++k)
      next[k] = cage.add(wrist + palm_point(section, k, cage.positions[roots[k]].x - wrist_x));
  }
  rings.push_back(roots);
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) bridge_palm(cage, rings[r], rings[r + 1], r == thumb_band);

  for (std::size_t f = 0; f < std::size(fingers); ++f)
    add_finger(cage, fingers[f], {wall[f][0], wall[f + 1][0], wall[f + 1][1], wall[f + 1][2], wall[f][2], wall[f][1]},
               wrist);
  const LimbRing &near = rings[thumb_band], &far = rings[thumb_band + 1];
  add_thumb(cage, {near[1], far[1], far[0], far[11], near[11], near[0]}, wrist);
}

Vec3 with_hand_relief(const Vec3& position, double wrist_x) {
  const Vec3 from_wrist = position - Vec3{wrist_x, 0, 0};
  double lift = 0.0;
  for (const HandRelief& relief : hand_reliefs) {
    const Vec2 off = (Vec2{from_wrist} - Vec2{relief.x, relief.y}) / relief.radius;
    const double side = relief.on_palm ? 1.0 : -1.0;
    const double on_side = smoothstep01(side * from_wrist.z / relief_depth);
    lift += side * on_side * relief.height * std::exp(-0.5 * glm::dot(off, off));
  }
  return position + Vec3{0, 0, lift};
}

}  // namespace sinew
