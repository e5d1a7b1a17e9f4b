#include <map>

#include "engine/body/figure_cage_parts.h"

namespace sinew {
namespace {

constexpr double loose = 0.5;
constexpr int trunk_rings = 6;  ///< from above the legs to the armpits
constexpr int perimeter = 2 * front_edges + side_edges;
constexpr int armpit_row = trunk_rings, shoulder_row = trunk_rings + arm_hole_rows;
constexpr int head_rings = 8, neck_rings = 2;

/// Vertices of the trunk on a lattice: column i from the middle to the left, row j upwards, k from back to front.
class Lattice {
 public:
  explicit Lattice(HalfCage& cage) : cage_(cage) {}

  /// The vertex, made unplaced where it is new.
  Index at(int i, int j, int k) {
    const auto [place, is_new] = indices_.try_emplace({i, j, k}, 0);
    if (is_new) {
      place->second = cage_.add_unplaced(Chain::trunk, loose);
      cage_.vertices[place->second].on_plane = i == 0;
    }
    return place->second;
  }
  /// Step m of the half ring: from the middle of the front over the side to the middle of the back.
  Index round(int m, int j) {
    if (m <= front_edges) return at(m, j, side_edges);
    if (m <= front_edges + side_edges) return at(front_edges, j, side_edges - (m - front_edges));
    return at(perimeter - m, j, 0);
  }

 private:
  HalfCage& cage_;
  std::map<std::array<int, 3>, Index> indices_;
};

void place(HalfCage& cage, Index vertex, Vec3 position, Chain chain) {
  CageVertex& v = cage.vertices[vertex];
  if (v.on_plane) position.x = 0.0;
  v.position = position;
  v.placed = true;
  v.chain = chain;
}

Loop arm_hole(Lattice& lattice) {
  Loop loop;
  for (int k = side_edges; k > 0; --k) loop.push_back(lattice.at(front_edges, armpit_row, k));
  for (int j = armpit_row; j < shoulder_row; ++j) loop.push_back(lattice.at(front_edges, j, 0));
  for (int k = 0; k < side_edges; ++k) loop.push_back(lattice.at(front_edges, shoulder_row, k));
  for (int j = shoulder_row; j > armpit_row; --j) loop.push_back(lattice.at(front_edges, j, side_edges));
  return loop;
}

/// The hole for the leg begins one column off the middle: between the two lies the crotch.
Loop leg_hole(Lattice& lattice) {
  Loop loop;
  for (int i = front_edges; i > 1; --i) loop.push_back(lattice.at(i, 0, side_edges));
  for (int k = side_edges; k > 0; --k) loop.push_back(lattice.at(1, 0, k));
  for (int i = 1; i < front_edges; ++i) loop.push_back(lattice.at(i, 0, 0));
  for (int k = 0; k < side_edges; ++k) loop.push_back(lattice.at(front_edges, 0, k));
  return loop;
}

Loop neck_hole(Lattice& lattice) {
  Loop loop;
  for (int i = 0; i < neck_front_edges; ++i) loop.push_back(lattice.at(i, shoulder_row, side_edges));
  for (int k = side_edges; k > 0; --k) loop.push_back(lattice.at(neck_front_edges, shoulder_row, k));
  for (int i = neck_front_edges; i >= 0; --i) loop.push_back(lattice.at(i, shoulder_row, 0));
  return loop;
}

void add_quads(HalfCage& cage, Lattice& lattice) {
  for (int j = 0; j < shoulder_row; ++j)
    for (int m = 0; m < perimeter; ++m) {
      const bool side = m >= front_edges && m < front_edges + side_edges;
      if (side && j >= armpit_row) continue;
      cage.quads.push_back(
          {lattice.round(m, j), lattice.round(m + 1, j), lattice.round(m + 1, j + 1), lattice.round(m, j + 1)});
    }
  for (int k = 0; k < side_edges; ++k) {
    for (int i = neck_front_edges; i < front_edges; ++i)
      cage.quads.push_back({lattice.at(i, shoulder_row, k + 1), lattice.at(i + 1, shoulder_row, k + 1),
                            lattice.at(i + 1, shoulder_row, k), lattice.at(i, shoulder_row, k)});
    cage.quads.push_back({lattice.at(0, 0, k), lattice.at(1, 0, k), lattice.at(1, 0, k + 1), lattice.at(0, 0, k + 1)});
  }
}

void add_seams(HalfCage& cage, Lattice& lattice, const TrunkLoops& loops) {
  // The outer line of the side, the top of the shoulder and the crotch part the front from the back.
  constexpr int middle_of_side = 1;
  Loop side, shoulder;
  for (int j = 0; j <= armpit_row; ++j) side.push_back(lattice.at(front_edges, j, middle_of_side));
  for (int i = front_edges; i >= neck_front_edges; --i) shoulder.push_back(lattice.at(i, shoulder_row, middle_of_side));
  cage.cut(side);
  cage.cut(shoulder);
  cage.cut(Loop{lattice.at(1, 0, middle_of_side), lattice.at(0, 0, middle_of_side)});
  // Arms, legs and head stay with the back.
  constexpr std::size_t arm_front = 7, arm_below = 2, leg_outside = 12, leg_inside = 6, neck_side = 4;
  Loop arm(loops.arm.begin() + arm_front, loops.arm.end()),
      neck(loops.neck.begin(), loops.neck.begin() + neck_side + 1);
  arm.insert(arm.end(), loops.arm.begin(), loops.arm.begin() + arm_below + 1);
  Loop leg(loops.leg.begin() + leg_outside, loops.leg.end());
  leg.insert(leg.end(), loops.leg.begin(), loops.leg.begin() + leg_inside + 1);
  cage.cut(arm);
  cage.cut(leg);
  cage.cut(neck);
}

/// Radians of step m of the neck's half loop.
double neck_angle(std::size_t m, std::size_t size) {
  return std::numbers::pi * static_cast<double>(m) / static_cast<double>(size - 1);
}

/// The neck's surface, `share` 0 at its root, 1 below the head; the root lies lower at the front.
Vec3 on_neck(const BodyPart& neck, double share, double angle) {
  const double root = -0.008 - 0.012 * std::cos(angle);
  const double top = neck.last - 0.022 - 0.012 * std::cos(angle);
  return neck.on_surface(glm::mix(root, top, share), angle);
}

}  // namespace

TrunkLoops add_trunk(HalfCage& cage, const MeasuredBody& body) {
  Lattice lattice(cage);
  const BodyPart &trunk = body.part("trunk"), &arm = body.part("arm"), &leg = body.part("leg");
  const double low = leg.axis[0].y + 0.025, high = body.joint("upperarm01").y - 0.078;
  for (int j = 1; j <= armpit_row; ++j) {
    const double y = glm::mix(low, high, (j - 1.0) / (armpit_row - 1.0));
    for (int m = 0; m <= perimeter; ++m) {
      const Index vertex = lattice.round(m, j);
      place(cage, vertex, trunk.on_surface(y - trunk.axis[0].y, std::numbers::pi * m / perimeter), Chain::trunk);
      cage.anchor(vertex, {0, 1, 0}, y);
    }
  }
  TrunkLoops loops{arm_hole(lattice), leg_hole(lattice), neck_hole(lattice)};

  // The armpit is a saddle: the loop lies on the arm, close to the shoulder above and further out below.
  for (std::size_t n = 0; n < loops.arm.size(); ++n) {
    const double angle = (45.0 + 30.0 * static_cast<double>(n)) * degrees_to_radians;
    const double t = 0.003 + 0.019 * std::sin(angle);
    place(cage, loops.arm[n], arm.on_surface(t, angle), Chain::arm);
    cage.anchor(loops.arm[n], arm.direction(0), glm::dot(arm.direction(0), arm.axis[0]) + t);
  }
  // The groin rises outwards; the crotch lies lowest.
  const double crotch = leg.axis[0].y - (trunk.axis[0].y - 0.010);
  for (std::size_t n = 0; n < loops.leg.size(); ++n) {
    const double angle = (static_cast<double>(n) - 2.0) / leg_ring * 2.0 * std::numbers::pi;
    Vec3 on_leg = leg.on_surface(0.5 * (crotch + 0.012) + 0.5 * (crotch + 0.004) * std::sin(angle), angle);
    on_leg.x = std::max(on_leg.x, 0.012);
    cage.vertices[loops.leg[n]].anchored = false;
    place(cage, loops.leg[n], on_leg, Chain::leg);
  }
  for (std::size_t m = 0; m < loops.neck.size(); ++m)
    place(cage, loops.neck[m], on_neck(body.part("neck"), 0.0, neck_angle(m, loops.neck.size())), Chain::trunk);

  add_quads(cage, lattice);
  add_seams(cage, lattice, loops);
  return loops;
}

void add_head(HalfCage& cage, const MeasuredBody& body, const Loop& neck_loop) {
  const BodyPart &neck = body.part("neck"), &head = body.part("head");
  const std::size_t size = neck_loop.size();
  Loop previous = neck_loop;
  const auto add_ring = [&](auto position, Chain chain) {
    Loop ring;
    for (std::size_t m = 0; m < size; ++m) {
      ring.push_back(cage.add(position(neck_angle(m, size)), chain, loose));
      CageVertex& v = cage.vertices.back();
      v.on_plane = m == 0 || m + 1 == size;
      if (v.on_plane) v.position.x = 0.0;
    }
    cage.bridge(previous, ring, false);
    previous = ring;
  };
  for (int r = 1; r <= neck_rings; ++r)
    add_ring([&](double angle) { return on_neck(neck, static_cast<double>(r) / neck_rings, angle); }, Chain::trunk);
  for (int r = 0; r < head_rings; ++r) {
    // Low rings are tilted: the chin lies lower than the nape.
    const double f = r / (head_rings - 1.0);
    const double tilt = -16.0 * std::pow(1.0 - f, 1.2) - 6.0 * f * (1.0 - f);
    add_ring(
        [&](double angle) {
          return head.on_ball((-46.0 + 98.0 * f + tilt * std::cos(angle)) * degrees_to_radians, angle);
        },
        Chain::head);
  }
  // The crown is a lattice within the last ring.
  std::map<std::pair<int, int>, Index> crown;
  std::size_t m = 0;
  for (int i = 0; i < neck_front_edges; ++i) crown[{i, side_edges}] = previous[m++];
  for (int k = side_edges; k > 0; --k) crown[{neck_front_edges, k}] = previous[m++];
  for (int i = neck_front_edges; i >= 0; --i) crown[{i, 0}] = previous[m++];
  for (int i = 0; i <= neck_front_edges; ++i)
    for (int k = 0; k <= side_edges; ++k)
      if (!crown.contains({i, k})) {
        crown[{i, k}] = cage.add_unplaced(Chain::head, loose);
        cage.vertices.back().position = head.on_ball(0.45 * std::numbers::pi, 0.0);
        cage.vertices.back().on_plane = i == 0;
      }
  for (int i = 0; i < neck_front_edges; ++i)
    for (int k = 0; k < side_edges; ++k)
      cage.quads.push_back({crown[{i, k + 1}], crown[{i + 1, k + 1}], crown[{i + 1, k}], crown[{i, k}]});
}

}  // namespace sinew
