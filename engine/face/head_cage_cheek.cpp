/// Cheek and chin: the grid between eye, nose, mouth and the jaw's edge.

#include "engine/face/head_cage_parts.h"

namespace sinew {
namespace {

constexpr int last_row = cheek_rows - 1, columns = 4;

/// Where a row stands between the eye's rim (0) and the jaw's edge (1).
double row_share(const HeadCage& cage, int row) {
  constexpr double chin_share_height = 0.075, second_last_height = 0.17;
  const double top = cage.at(cheek_point(0, 0)).y;
  if (row == last_row) return 1.0;
  const double y = row == last_row - 1 ? second_last_height : cage.at(cheek_point(0, row)).y;
  return (top - y) / (top - chin_share_height);
}

/// The grid's column without its last row, laid on the skull and bent to the jaw below the mouth.
Vec3 cheek_place(const HeadPlan& plan, const HeadCage& cage, int column, int row) {
  const double edges[columns] = {0.0, 0.22, 0.42, 0.60};
  const Vec3 top = cage.at(cheek_point(column, 0)), bottom = plan.jaw_edge(edges[column]);
  const double share = row_share(cage, row);
  double x = glm::mix(top.x, bottom.x, share);
  const double y = glm::mix(top.y, bottom.y, share);
  if (row < last_row - 1 && column < columns - 1) {
    // Spread between the left edge and the last column, so that no column crosses the mouth's rings.
    const double left = cage.at(cheek_point(0, row)).x;
    const double right = glm::mix(cage.at(eye_point(6, 10)).x, plan.jaw_edge(edges[columns - 1]).x, share);
    x = 0.75 * (left + (right - left) * (0.30 * column + 0.01 * column * column)) + 0.25 * x;
  }
  const double bend = 0.68 * plan.mouth, height = std::max(y, bend);
  const bool beyond = x >= 0.98 * plan.loft.at(80.0, height).x;
  const double skull = beyond ? bottom.z : plan.loft.depth(x, height);
  const double to_jaw = y < bend ? std::clamp((bend - y) / (bend - bottom.y + 1e-6), 0.0, 1.0) : 0.0;
  return {x, y, glm::mix(skull, bottom.z + 0.02, to_jaw) + plan.cheek_bone(x, y)};
}

void add_chin(const HeadPlan& plan, HeadCage& cage) {
  for (int column = 0; column < columns; ++column) {
    const Vec3 bottom = plan.chin_edge(3 - column), top = cage.at(mouth_point(6, 7 + column));
    Vec3 middle = 0.5 * (top + bottom);
    middle.z = 0.55 * top.z + 0.45 * bottom.z + (column == 0 ? 0.030 : 0.045);
    cage.put(chin_point(column, 1), middle);
    cage.put(chin_point(column, 2), bottom);
  }
}

/// Points of the cheek and of the skin about the mouth's corner and jaw.
bool is_relaxed(const CagePoint& p) {
  switch (p.part) {
    case HeadPart::cheek:
      return p.place < last_row;
    case HeadPart::eye:
      return p.ring == 6 && p.place >= 9 && p.place <= 13;
    case HeadPart::mouth:
      return p.ring == 6 && p.place >= 5 && p.place <= 8;
    case HeadPart::chin:
      return p.ring <= 1 && p.place == 1;
    case HeadPart::side:
      return (p.ring == 0 && p.place >= 4 && p.place < side_rows - 1) ||
             (p.ring == 1 && p.place > ear_last_row && p.place < side_rows - 1);
    default:
      return false;
  }
}

}  // namespace

void puff_cheek(const HeadPlan& plan, HeadCage& cage) {
  for (std::size_t v = 0; v < cage.positions.size(); ++v) {
    const CagePoint& p = cage.names[v];
    const bool skin = p.part == HeadPart::cheek || (p.part == HeadPart::mouth && p.ring >= 5) ||
                      (p.part == HeadPart::side && p.ring <= 1) || (p.part == HeadPart::eye && p.ring == 6) ||
                      (p.part == HeadPart::nose && p.ring == 3) || p.part == HeadPart::chin;
    if (skin && cage.positions[v].x > 0.0)
      cage.positions[v] += plan.cheek_puff(cage.positions[v].x, cage.positions[v].y);
  }
}

void relax_cheek(HeadCage& cage) {
  // Taubin's pairs of steps, inwards and a little further outwards, smooth without shrinking (A signal processing
  // approach to fair surface design, 1995).
  constexpr int pairs = 4;
  constexpr double steps[] = {0.45, -0.47};
  std::vector<std::vector<std::uint32_t>> around(cage.positions.size());
  for (const CageQuad& quad : cage.quads)
    for (std::size_t i = 0; i < 4; ++i) {
      // Every edge inside is met from two quads, once each way.
      around[quad.corners[i]].push_back(quad.corners[(i + 1) % 4]);
      around[quad.corners[(i + 1) % 4]].push_back(quad.corners[i]);
    }
  for (int round = 0; round < 2 * pairs; ++round) {
    const std::vector<Vec3> before = cage.positions;
    for (std::size_t v = 0; v < before.size(); ++v) {
      if (!is_relaxed(cage.names[v])) continue;
      Vec3 mean(0.0);
      for (const std::uint32_t u : around[v]) mean += before[u] / double(around[v].size());
      cage.positions[v] += steps[round % 2] * (mean - before[v]);
    }
  }
}

CagePoint cheek_point(int column, int row) {
  constexpr int rim[columns] = {13, 12, 11, 10};
  if (row == 0) return eye_point(6, rim[column]);
  if (column > 0) return {HeadPart::cheek, column, row};
  if (row <= 3) return nose_point(3, row + 4);
  if (row <= 8) return mouth_point(6, row - 1);
  return chin_point(0, row - 8);
}

void add_cheek(const HeadPlan& plan, HeadCage& cage) {
  add_chin(plan, cage);
  constexpr double edges[columns] = {0.0, 0.22, 0.42, 0.60};
  for (int column = 1; column < columns; ++column) {
    for (int row = 1; row < last_row; ++row) cage.put(cheek_point(column, row), cheek_place(plan, cage, column, row));
    cage.put(cheek_point(column, last_row), plan.jaw_edge(edges[column]));
  }
  for (int column = 0; column + 1 < columns; ++column) {
    for (int row = 0; row < last_row; ++row)
      cage.quad(cheek_point(column, row), cheek_point(column, row + 1), cheek_point(column + 1, row + 1),
                cheek_point(column + 1, row));
    const auto chin = [](int c, int row) { return row == 0 ? mouth_point(6, 7 + c) : chin_point(c, row); };
    for (int row = 0; row < 2; ++row)
      cage.quad(chin(column + 1, row), chin(column + 1, row + 1), chin(column, row + 1), chin(column, row));
  }
}

}  // namespace sinew
