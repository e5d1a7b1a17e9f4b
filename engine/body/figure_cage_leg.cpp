#include <map>

#include "engine/body/figure_cage_parts.h"

namespace sinew {
namespace {

constexpr double limb_looseness = 0.12, junction_looseness = 0.5, foot_looseness = 0.10, heel_looseness = 0.30;

/// The ankle's ring as a block: 3 edges wide, 4 long, the foot's columns 2 high; 5 toes.
constexpr int wide = 3, longways = 4, high = 2, toes = 5;
constexpr std::size_t inner_seam = 5;  ///< of the leg's ring, from the groin to the ankle

using Cell = std::array<int, 3>;  ///< i from the outer to the inner side, j upwards, k from heel to front

std::vector<std::pair<int, int>> ankle_outline() {
  std::vector<std::pair<int, int>> outline;
  for (int i = 0; i < wide; ++i) outline.emplace_back(i, longways);
  for (int k = longways; k > 0; --k) outline.emplace_back(wide, k);
  for (int i = wide; i > 0; --i) outline.emplace_back(i, 0);
  for (int k = 0; k < longways; ++k) outline.emplace_back(0, k);
  return outline;
}

/// The sole under the ankle; its heel is round, and rises a little at the back.
Vec3 on_sole(const BodyPart& foot, double ankle, int i, int k) {
  const double f = static_cast<double>(k) / longways;
  const double back = foot.first - 0.5 * foot.cap_first;
  const double t = glm::mix(back, ankle + 0.015, f);
  const Vec3 inner = foot.on_surface(t, 110.0 * degrees_to_radians),
             outer = foot.on_surface(t, 250.0 * degrees_to_radians);
  const double narrow = k == 0 ? 0.62 : 1.0;
  const double across = 0.5 + narrow * (static_cast<double>(i) / wide - 0.5);
  Vec3 p = glm::mix(outer, inner, across);
  if (k == 0 && (i == 0 || i == wide)) p += 0.004 * foot.direction(t);
  p.y = k == 0 ? 0.009 : 0.004;
  return p;
}

/// Heel and ankle: a block whose top is the leg's last ring. Returns the loop of its open front, [10]: the top from the
/// outer to the inner side, then down, back along the sole and up.
Loop add_heel(HalfCage& cage, const BodyPart& foot, double ankle_t, const Loop& ankle) {
  const auto outline = ankle_outline();
  std::map<Cell, Index> block;
  for (std::size_t n = 0; n < outline.size(); ++n) block[{outline[n].first, high, outline[n].second}] = ankle[n];
  for (int i = 0; i <= wide; ++i)
    for (int k = 0; k <= longways; ++k)
      block[{i, 0, k}] = cage.add(on_sole(foot, ankle_t, i, k), Chain::foot, heel_looseness);
  const auto in_front = [](int i, int k) { return k == longways && i > 0 && i < wide; };
  for (const auto& [i, k] : outline) {
    if (in_front(i, k)) continue;
    for (int j = 1; j < high; ++j)
      block[{i, j, k}] =
          cage.add(glm::mix(on_sole(foot, ankle_t, i, k), cage.at(block[{i, high, k}]), static_cast<double>(j) / high),
                   Chain::foot, heel_looseness);
  }
  for (std::size_t n = 0; n < outline.size(); ++n) {
    const auto [i, k] = outline[n];
    const auto [next_i, next_k] = outline[(n + 1) % outline.size()];
    if (k == longways && next_k == longways) continue;
    for (int j = 0; j < high; ++j)
      cage.quads.push_back(
          {block[{i, j + 1, k}], block[{next_i, j + 1, next_k}], block[{next_i, j, next_k}], block[{i, j, k}]});
  }
  for (int i = 0; i < wide; ++i)
    for (int k = 0; k < longways; ++k)
      cage.quads.push_back({block[{i, 0, k}], block[{i, 0, k + 1}], block[{i + 1, 0, k + 1}], block[{i + 1, 0, k}]});

  Loop front;
  for (int i = 0; i < wide; ++i) front.push_back(block[{i, high, longways}]);
  for (int j = high; j > 0; --j) front.push_back(block[{wide, j, longways}]);
  for (int i = wide; i > 0; --i) front.push_back(block[{i, 0, longways}]);
  for (int j = 0; j < high; ++j) front.push_back(block[{0, j, longways}]);
  return front;
}

/// A ring of the foot: `angles` of its tube, in degrees; the top leans forward by `lean`.
Loop foot_ring(HalfCage& cage, const BodyPart& foot, double t, double lean, std::span<const double> angles) {
  Loop ring;
  const Vec3 axis = foot.direction(0.0);
  for (const double degrees : angles) {
    const double angle = degrees * degrees_to_radians;
    const double leaning = t + lean * std::cos(angle);
    const Index vertex = cage.add(foot.on_surface(leaning, angle), Chain::foot, foot_looseness);
    cage.anchor(vertex, axis, glm::dot(axis, foot.axis[0]) + leaning);
    ring.push_back(vertex);
  }
  return ring;
}

/// From a ring of 10 to one of 14: the middle edge of top and sole becomes three, by two inner vertices each.
void widen(HalfCage& cage, const Loop& ten, const Loop& fourteen) {
  const auto quad = [&](Index a, Index b, Index c, Index d) { cage.quads.push_back({a, b, c, d}); };
  const auto straight = [&](std::size_t t, std::size_t f) {
    quad(ten[t], ten[(t + 1) % 10], fourteen[(f + 1) % 14], fourteen[f]);
  };
  for (const auto& [t, f] : {std::pair{0, 0}, {2, 4}, {3, 5}, {4, 6}, {5, 7}, {7, 11}, {8, 12}, {9, 13}})
    straight(t, f);
  for (const auto& [t, f] : {std::pair<std::size_t, std::size_t>{1, 1}, {6, 8}}) {
    const Index a = ten[t], b = ten[t + 1];
    const Index one = cage.add(glm::mix(cage.at(a), cage.at(fourteen[f + 1]), 0.55), Chain::foot, foot_looseness);
    const Index two = cage.add(glm::mix(cage.at(b), cage.at(fourteen[f + 2]), 0.55), Chain::foot, foot_looseness);
    quad(a, b, two, one);
    quad(a, one, fourteen[f + 1], fourteen[f]);
    quad(one, two, fourteen[f + 2], fourteen[f + 1]);
    quad(b, fourteen[f + 3], fourteen[f + 2], two);
  }
}

/// Where toes part: share of their length.
double toe_root(const BodyPart& toe) { return 0.42 * toe.last; }

/// A toe's section as a square: `across` 0 outer to 1 inner, `height` 0 sole to 1 top.
Vec3 on_squared_toe(const BodyPart& toe, double across, double height) {
  const double x = 1.0 - 2.0 * across, y = 2.0 * height - 1.0;
  const double angle = x == 0.0 && y == 0.0 ? 0.0 : std::atan2(y, x);
  const Vec3 surface = toe.on_surface(toe_root(toe), angle);
  const Vec3 centre = 0.5 * (surface + toe.on_surface(toe_root(toe), angle + std::numbers::pi));
  return centre + std::max(std::abs(x), std::abs(y)) * (surface - centre);
}

void add_toes(HalfCage& cage, const MeasuredBody& body, const Loop& before) {
  std::array<const BodyPart*, toes> toe;  // from the outer side: the little toe first
  for (int c = 0; c < toes; ++c) toe[c] = &body.part("toe" + std::to_string(toes - c));
  std::map<std::pair<int, int>, Index> end;
  for (int c = 0; c <= toes; ++c)
    for (int j = 0; j <= high; ++j) {
      Vec3 sum(0.0);
      int count = 0;
      for (int f = std::max(c - 1, 0); f <= std::min(c, toes - 1); ++f, ++count)
        sum += on_squared_toe(*toe[f], c - f, static_cast<double>(j) / high);
      end[{c, j}] = cage.add(sum / static_cast<double>(count), Chain::foot, foot_looseness);
    }
  Loop ring;
  for (int c = 0; c < toes; ++c) ring.push_back(end[{c, 2}]);
  ring.push_back(end[{toes, 2}]);
  ring.push_back(end[{toes, 1}]);
  for (int c = toes; c >= 0; --c) ring.push_back(end[{c, 0}]);
  ring.push_back(end[{0, 1}]);
  cage.bridge(before, ring);

  std::array<double, 6> angles{50.0, 130.0, 180.0, 230.0, 310.0, 360.0};
  for (double& angle : angles) angle *= degrees_to_radians;
  for (int c = 0; c < toes; ++c) {
    const Loop loop{end[{c, 2}], end[{c + 1, 2}], end[{c + 1, 1}], end[{c + 1, 0}], end[{c, 0}], end[{c, 1}]};
    const double stations[] = {glm::mix(toe_root(*toe[c]), toe[c]->last, 0.72), toe[c]->last + 0.7 * toe[c]->cap_last};
    add_digit(cage, *toe[c], toe_chain(toes - c), loop, stations, angles);
  }
}

}  // namespace

Loop add_leg(HalfCage& cage, const MeasuredBody& body, const Loop& groin) {
  const BodyPart &leg = body.part("leg"), &trunk = body.part("trunk");
  const double crotch = leg.axis[0].y - (trunk.axis[0].y - 0.010);
  const double knee = leg.along(body.joint("lowerleg01"));
  const double first = crotch + 0.022, last = leg.along(body.joint("foot")) - 0.030, bend = 0.024;
  std::vector<double> stations;
  for (int n = 0; n < 4; ++n) stations.push_back(glm::mix(first, knee - bend, n / 4.0));
  for (const double t : {knee - bend, knee, knee + bend}) stations.push_back(t);
  // Further apart on the calf's belly, closer towards the ankle.
  for (const double f : {0.30, 0.60, 0.82, 1.0}) stations.push_back(glm::mix(knee + bend, last, f));

  const Vec3 axis = leg.direction(0.0);
  Loop previous = groin, seam{groin[inner_seam]};
  for (std::size_t r = 0; r < stations.size(); ++r) {
    const double lean = std::max(0.0, 1.0 - (static_cast<double>(r) + 1.0) / 3.0);
    const double turn = 0.5 * static_cast<double>(r + 1) / static_cast<double>(stations.size());
    Loop ring;
    for (std::size_t n = 0; n < leg_ring; ++n) {
      const double angle = (static_cast<double>(n) - 2.0 + turn) / leg_ring * 2.0 * std::numbers::pi;
      const double loop_t = 0.5 * (crotch + 0.012) + 0.5 * (crotch + 0.004) * std::sin(angle);
      const double t =
          std::max(stations[r] + lean * 0.8 * (loop_t - crotch), loop_t + 0.008 * (static_cast<double>(r) + 1.0));
      const Index vertex = cage.add(leg.on_surface(t, angle), Chain::leg, r < 3 ? junction_looseness : limb_looseness);
      cage.anchor(vertex, axis, glm::dot(axis, leg.axis[0]) + t);
      ring.push_back(vertex);
    }
    cage.bridge(previous, ring);
    seam.push_back(ring[inner_seam]);
    previous = ring;
  }
  cage.cut(seam);
  return previous;
}

void add_foot(HalfCage& cage, const MeasuredBody& body, const Loop& ankle) {
  const BodyPart& foot = body.part("foot");
  const double ankle_t = foot.along(body.joint("foot")), ball_t = foot.along(body.joint("toe2-1"));
  Loop previous = add_heel(cage, foot, ankle_t, ankle);
  std::array<double, 10> ten;
  for (std::size_t n = 0; n < ten.size(); ++n) ten[n] = -54.0 + 36.0 * static_cast<double>(n);
  const double start = ankle_t + 0.032, end = ball_t - 0.012;
  for (const auto& [share, lean] : {std::pair{0.0, 0.012}, std::pair{0.5, 0.004}}) {
    const Loop ring = foot_ring(cage, foot, glm::mix(start, end, share), lean, ten);
    cage.bridge(previous, ring);
    previous = ring;
  }
  const std::array<double, 14> fourteen{-60, -36, -12, 12, 36, 60, 90, 120, 144, 168, 192, 216, 240, 270};
  const Loop ball = foot_ring(cage, foot, end, 0.0, fourteen);
  widen(cage, previous, ball);
  add_toes(cage, body, ball);
}

}  // namespace sinew
