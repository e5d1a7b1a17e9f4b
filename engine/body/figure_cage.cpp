#include "engine/body/figure_cage.h"

#include <cassert>

#include "engine/body/figure_cage_parts.h"

namespace sinew {
namespace {

/// Rounds of averaging after which a patch of unplaced vertices, at most five edges wide, lies still.
constexpr int placing_rounds = 300;

/// Puts unplaced vertices where each is the mean of its neighbours.
void place_rest(HalfCage& cage) {
  std::vector<std::set<Index>> neighbours(cage.vertices.size());
  for (const auto& quad : cage.quads)
    for (std::size_t corner = 0; corner < 4; ++corner) {
      neighbours[quad[corner]].insert(quad[(corner + 1) % 4]);
      neighbours[quad[(corner + 1) % 4]].insert(quad[corner]);
    }
  Vec3 middle(0.0);
  for (const CageVertex& v : cage.vertices) middle += v.position;
  for (int round = 0; round < placing_rounds; ++round)
    for (std::size_t i = 0; i < cage.vertices.size(); ++i) {
      CageVertex& v = cage.vertices[i];
      if (v.placed) continue;
      Vec3 sum(0.0);
      for (const Index n : neighbours[i]) sum += cage.at(n);
      v.position = sum / static_cast<double>(neighbours[i].size());
      if (v.on_plane) v.position.x = 0.0;
    }
  for (CageVertex& v : cage.vertices) v.placed = true;
}

}  // namespace

Index HalfCage::add(const Vec3& position, Chain chain, double looseness) {
  CageVertex vertex;
  vertex.position = position;
  vertex.placed = true;
  vertex.chain = chain;
  vertex.looseness = looseness;
  vertices.push_back(vertex);
  return static_cast<Index>(vertices.size() - 1);
}

Index HalfCage::add_unplaced(Chain chain, double looseness) {
  const Index vertex = add(Vec3(0.1, 0.5, 0.0), chain, looseness);
  vertices[vertex].placed = false;
  return vertex;
}

void HalfCage::anchor(Index vertex, const Vec3& axis, double station) {
  vertices[vertex].anchored = true;
  vertices[vertex].axis = axis;
  vertices[vertex].station = station;
}

void HalfCage::bridge(const Loop& near, const Loop& far, bool closed) {
  assert(near.size() == far.size());
  for (std::size_t k = 0; k + (closed ? 0 : 1) < near.size(); ++k) {
    const std::size_t next = (k + 1) % near.size();
    quads.push_back({near[k], near[next], far[next], far[k]});
  }
}

void HalfCage::cap_six(const Loop& loop) {
  assert(loop.size() == 6);
  quads.push_back({loop[0], loop[1], loop[2], loop[5]});
  quads.push_back({loop[5], loop[2], loop[3], loop[4]});
}

void HalfCage::cut(std::span<const Index> line) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) seams.insert(cage_edge(line[i], line[i + 1]));
}

HalfCage figure_cage(const MeasuredBody& body) {
  HalfCage cage;
  const TrunkLoops trunk = add_trunk(cage, body);
  add_head(cage, body, trunk.neck);
  add_hand(cage, body, add_arm(cage, body, trunk.arm));
  add_foot(cage, body, add_leg(cage, body, trunk.leg));
  place_rest(cage);
  return cage;
}

std::vector<Loop> add_digit(HalfCage& cage, const BodyPart& tube, Chain chain, const Loop& loop,
                            std::span<const double> stations, std::span<const double> angles) {
  std::vector<Loop> loops{loop};
  for (const double t : stations) {
    Loop ring;
    for (const double angle : angles) {
      const Index vertex = cage.add(tube.on_surface(t, angle), chain, 0.0);
      const Vec3 axis = tube.direction(t);
      cage.anchor(vertex, axis, glm::dot(axis, tube.on_axis(t)));
      ring.push_back(vertex);
    }
    cage.bridge(loops.back(), ring);
    loops.push_back(ring);
  }
  for (const Index vertex : loops.back()) cage.vertices[vertex].looseness = 0.12;
  cage.cap_six(loops.back());
  return loops;
}

}  // namespace sinew
