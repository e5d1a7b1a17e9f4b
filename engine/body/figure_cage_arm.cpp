#include <complex>
#include <map>

#include "engine/body/figure_cage_parts.h"

namespace sinew {
namespace {

constexpr double limb_looseness = 0.12, junction_looseness = 0.5;

/// The first rings lie close together; refinement cuts between them as if they did not.
constexpr std::size_t shoulder_rings = 4;
constexpr double shoulder_detail = 2.9;

/// The palm's end is a lattice of 4 fingers across and 2 cells from palm to back.
constexpr int fingers = 4, deep = 2;
constexpr int palm_rows = 3;
/// Shares of the palm's length; the thumb grows between the second and the third.
constexpr double palm_stations[palm_rows + 1] = {0.0, 0.24, 0.64, 1.0};
/// Row of the palm in whose radial side the thumb's hole is.
constexpr int thumb_row = 1;

/// The line that is cut open from the shoulder to the thumb.
constexpr std::size_t radial = 11;

/// Where a quarter turn of lattice corners lies on the wrist's ring, lattice (finger, depth): from the index finger's
/// palmar corner to the little finger, to the back of the hand, and home.
std::array<std::pair<int, int>, arm_ring> palm_outline() {
  std::array<std::pair<int, int>, arm_ring> outline;
  std::size_t m = 0;
  for (int i = 0; i < fingers; ++i) outline[m++] = {i, 0};
  for (int j = 0; j < deep; ++j) outline[m++] = {fingers, j};
  for (int i = fingers; i > 0; --i) outline[m++] = {i, deep};
  for (int j = deep; j > 0; --j) outline[m++] = {0, j};
  return outline;
}

/// A finger's section as a square: `across` 0 radial to 1 ulnar, `depth` 0 palmar to 1 dorsal.
Vec3 on_squared_finger(const BodyPart& finger, double t, double across, double depth) {
  const double x = 1.0 - 2.0 * across, y = 1.0 - 2.0 * depth;
  const double angle = x == 0.0 && y == 0.0 ? 0.0 : std::atan2(0.75 * y, x);
  const Vec3 surface = finger.on_surface(t, angle);
  const Vec3 centre = 0.5 * (surface + finger.on_surface(t, angle + std::numbers::pi));
  return centre + std::max(std::abs(x), std::abs(y)) * (surface - centre);
}

/// Where finger `index` (0: index finger) parts from the hand.
double web(const BodyPart& finger) { return 0.42 * finger.t_at(1); }

/// Stations of a finger's rings: up to the middle joint, on it, before the tip, and round the tip.
std::array<double, 4> finger_stations(const BodyPart& finger, double root, double first_joint) {
  return {glm::mix(root, first_joint, 0.5), first_joint, finger.last - 0.0045, finger.last + 0.75 * finger.cap_last};
}

/// The seam round a digit: up one side, over the tip, down the other.
void cut_digit(HalfCage& cage, const std::vector<Loop>& loops) {
  Loop line;
  for (const Loop& loop : loops) line.push_back(loop[2]);
  for (auto loop = loops.rbegin(); loop != loops.rend(); ++loop) line.push_back((*loop)[5]);
  cage.cut(line);
}

void add_thumb(HalfCage& cage, const MeasuredBody& body, const std::vector<Loop>& rows) {
  const BodyPart& thumb = body.part("finger1");
  const Loop &low = rows[thumb_row], &high = rows[thumb_row + 1];
  const Loop hole{low[0], high[0], high[11], high[10], low[10], low[11]};
  Vec3 centre(0.0);
  for (const Index vertex : hole) centre += cage.at(vertex) / static_cast<double>(hole.size());
  // The ring is turned so that it meets the hole without a twist.
  std::array<double, 6> at_hole;
  for (std::size_t n = 0; n < hole.size(); ++n) {
    const Vec3 out = cage.at(hole[n]) - centre;
    at_hole[n] = std::atan2(glm::dot(out, thumb.v(0)), glm::dot(out, thumb.u[0]));
  }
  double turned = 0.0;
  for (std::size_t n = 0; n + 1 < hole.size(); ++n)
    turned += std::remainder(at_hole[n + 1] - at_hole[n], 2.0 * std::numbers::pi);
  const double step = std::copysign(std::numbers::pi / 3.0, turned);
  std::complex<double> mean = 0.0;
  for (std::size_t n = 0; n < hole.size(); ++n) mean += std::polar(1.0, at_hole[n] - step * static_cast<double>(n));
  std::array<double, 6> angles;
  for (std::size_t n = 0; n < angles.size(); ++n) angles[n] = std::arg(mean) + step * static_cast<double>(n);

  // Nearer to the hand than its first joint the thumb has no side of its own towards the palm.
  const double joint = thumb.t_at(1), end = thumb.last - 0.006;
  const std::array<double, 4> stations{0.95 * joint, glm::mix(joint, end, 0.5), end,
                                       thumb.last + 0.75 * thumb.cap_last};
  const auto loops = add_digit(cage, thumb, Chain::finger1, hole, stations, angles);
  cut_digit(cage, loops);
}

}  // namespace

Loop add_arm(HalfCage& cage, const MeasuredBody& body, const Loop& shoulder) {
  const BodyPart& arm = body.part("arm");
  const double elbow = arm.along(body.joint("lowerarm01")), wrist = arm.along(body.joint("wrist")) - 0.004;
  const double first = 0.018, bend = 0.016;
  // Close together where the deltoid moves, and round the elbow.
  std::vector<double> stations{first, first + 0.008, first + 0.016, first + 0.024};
  for (int n = 1; n <= 2; ++n) stations.push_back(glm::mix(stations[3], elbow - bend, n / 3.0));
  for (const double t : {elbow - bend, elbow, elbow + bend}) stations.push_back(t);
  for (int n = 1; n <= 4; ++n) stations.push_back(glm::mix(elbow + bend, wrist, n / 4.0));

  const Vec3 axis = arm.direction(0.0);
  Loop previous = shoulder, seam{shoulder[radial]};
  for (std::size_t r = 0; r < stations.size(); ++r) {
    // The first rings lean as the shoulder's loop does; towards the wrist they turn onto the palm's corners.
    const double lean = std::max(0.0, 1.0 - (static_cast<double>(r) + 1.0) / 2.5);
    const double turn = 15.0 * static_cast<double>(r + 1) / static_cast<double>(stations.size());
    Loop ring;
    for (std::size_t n = 0; n < arm_ring; ++n) {
      const double angle = (45.0 - turn + 30.0 * static_cast<double>(n)) * degrees_to_radians;
      const double loop_t = 0.003 + 0.019 * std::sin(angle);
      const double t =
          std::max(stations[r] + lean * 0.8 * (loop_t - first), loop_t + 0.006 * (static_cast<double>(r) + 1.0));
      const Index vertex = cage.add(arm.on_surface(t, angle), Chain::arm, r < 3 ? junction_looseness : limb_looseness);
      cage.anchor(vertex, axis, glm::dot(axis, arm.axis[0]) + t);
      if (r < shoulder_rings) cage.vertices[vertex].detail = shoulder_detail;
      ring.push_back(vertex);
    }
    cage.bridge(previous, ring);
    seam.push_back(ring[radial]);
    previous = ring;
  }
  cage.cut(seam);
  return previous;
}

void add_hand(HalfCage& cage, const MeasuredBody& body, const Loop& wrist) {
  const BodyPart& palm = body.part("palm");
  const double length = glm::distance(body.joint("finger3-1"), body.joint("wrist"));
  std::array<const BodyPart*, fingers> finger;
  for (int i = 0; i < fingers; ++i) finger[i] = &body.part("finger" + std::to_string(i + 2));

  // The end face: where two fingers meet, the middle between them.
  std::map<std::pair<int, int>, Index> end;
  for (int i = 0; i <= fingers; ++i)
    for (int j = 0; j <= deep; ++j) {
      Vec3 sum(0.0);
      int count = 0;
      for (int f = std::max(i - 1, 0); f <= std::min(i, fingers - 1); ++f, ++count)
        sum += on_squared_finger(*finger[f], web(*finger[f]) * (i > 0 && i < fingers ? 1.0 : 0.7), i - f,
                                 static_cast<double>(j) / deep);
      end[{i, j}] = cage.add(sum / static_cast<double>(count), Chain::palm, limb_looseness);
    }

  const auto outline = palm_outline();
  std::vector<Loop> rows{wrist};
  for (int r = 1; r <= palm_rows; ++r) {
    const double f = palm_stations[r];
    Loop row;
    for (std::size_t m = 0; m < arm_ring; ++m) {
      const auto [i, j] = outline[m];
      if (r == palm_rows) {
        row.push_back(end[outline[m]]);
        continue;
      }
      const double angle = std::atan2(0.55 * (1.0 - 2.0 * j / deep), 1.0 - 2.0 * i / fingers);
      const Vec3 straight = glm::mix(cage.at(wrist[m]), cage.at(end[outline[m]]), f);
      row.push_back(
          cage.add(glm::mix(straight, palm.on_surface(f * length, angle), 0.45), Chain::palm, limb_looseness));
    }
    rows.push_back(row);
  }
  for (int r = 0; r < palm_rows; ++r)
    for (std::size_t m = 0; m < arm_ring; ++m) {
      if (r == thumb_row && m >= arm_ring - deep) continue;
      const std::size_t next = (m + 1) % arm_ring;
      cage.quads.push_back({rows[r][m], rows[r][next], rows[r + 1][next], rows[r + 1][m]});
    }

  std::array<double, 6> angles;
  for (std::size_t n = 0; n < angles.size(); ++n)
    angles[n] = (60.0 + 60.0 * static_cast<double>(n)) * degrees_to_radians;
  for (int f = 0; f < fingers; ++f) {
    const Loop loop{end[{f, 0}], end[{f + 1, 0}], end[{f + 1, 1}], end[{f + 1, 2}], end[{f, 2}], end[{f, 1}]};
    const auto stations = finger_stations(*finger[f], web(*finger[f]), finger[f]->t_at(1));
    cut_digit(cage, add_digit(cage, *finger[f], finger_chain(f + 2), loop, stations, angles));
  }
  add_thumb(cage, body, rows);
  cage.cut(Loop{rows[0][radial], rows[1][radial]});
  cage.cut(Loop{rows[2][radial], rows[3][radial]});
}

}  // namespace sinew
