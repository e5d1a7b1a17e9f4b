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

}  // namespace

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
    for (int row = 1; row < last_row; ++row)
      cage.put(cheek_point(column, row), cheek_place(plan, cage, column, row));
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
