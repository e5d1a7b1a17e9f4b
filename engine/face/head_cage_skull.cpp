/// Forehead, sides, back and crown: all on the bare skull.

#include "engine/face/head_cage_parts.h"

namespace sinew {
namespace {

constexpr int forehead_places = 7;

/// Row 0 of the forehead: the brows.
CagePoint brow_point(int place) { return place < 2 ? nose_point(place, 0) : eye_point(6, place); }

double hair_row_height() { return 2.74; }
/// Between brows and hair.
double middle_row_height(const HeadPlan& plan) { return glm::mix(plan.brow, hair_row_height(), 0.42) + 0.06; }

double theta_of(const Vec3& p) { return std::atan2(p.x, p.z) * radians_to_degrees; }

/// Heights of the side's rows at the ear.
std::array<double, side_rows> ear_row_heights(const HeadPlan& plan) {
  std::array<double, side_rows> y{};
  const double top = plan.m.ear_top + 0.015, bottom = plan.m.ear_bottom - 0.015;
  y[0] = hair_row_height();
  y[1] = middle_row_height(plan);
  y[2] = std::max(plan.brow + 0.16, top + 0.14);
  for (int r = ear_first_row; r <= ear_last_row; ++r)
    y[r] = glm::mix(top, bottom, double(r - ear_first_row) / (ear_last_row - ear_first_row));
  for (int r = ear_last_row + 1; r < side_rows; ++r)
    y[r] = glm::mix(bottom, plan.m.jaw_height, double(r - ear_last_row) / (side_rows - 1 - ear_last_row));
  return y;
}

/// Heights of the rows at the back: denser towards the nape, so that no kink stands where rows meet the ear's.
std::array<double, side_rows> back_row_heights(const HeadPlan& plan) {
  const double nape = 0.50 + plan.m.neck_rise;
  std::array<double, side_rows> y{};
  double sum = 0.0;
  for (int r = 0; r + 1 < side_rows; ++r) y[r + 1] = sum += 0.7 + 1.9 * std::exp(-r / 2.2);
  for (double& height : y) height = glm::mix(hair_row_height(), nape, height / sum);
  return y;
}

/// Columns 1, 2, 3: before the ear, under it, behind it.
std::array<Vec3, 3> ear_columns(const HeadPlan& plan, int row, const std::array<double, side_rows>& heights) {
  const HeadLoft& loft = plan.loft;
  const double depths[] = {plan.m.ear_depth + 0.28, plan.m.ear_depth - 0.01, plan.m.ear_depth - 0.26};
  std::array<Vec3, 3> out;
  if (row <= ear_last_row) {
    const double y = std::max(heights[row], 0.3);
    constexpr double above_ear[] = {74.0, 91.0, 108.0}, share[] = {0.65, 0.6, 0.6};
    for (std::size_t i = 0; i < 3; ++i) {
      const double theta = loft.theta_of_depth(depths[i], y);
      out[i] = loft.at(row <= 1 ? glm::mix(theta, above_ear[i], share[i]) : theta, y);
    }
    return out;
  }
  // The jaw's branch, from the lobe to its angle, and the neck behind.
  const double t = double(row - ear_last_row) / (side_rows - 1 - ear_last_row), y = heights[ear_last_row];
  const Vec3 ends[] = {plan.jaw_edge(0.93), plan.jaw_angle() + Vec3(-0.035, 0.09, -0.17),
                       plan.jaw_angle() + Vec3(-0.10, 0.06, -0.42)};
  constexpr double bulge[] = {0.03, -0.02, -0.03};
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = glm::mix(loft.at(loft.theta_of_depth(depths[i], y), y), ends[i], t);
    out[i].x += bulge[i] * std::sin(std::numbers::pi * t);
  }
  return out;
}

/// Column 0: between the face and the column before the ear.
Vec3 temple(const HeadPlan& plan, const Vec3& front, const Vec3& ear, int row) {
  if (row == side_rows - 1) return plan.jaw_edge(0.78);
  const Vec3 middle = 0.5 * (front + ear), jaw = middle + Vec3(0.035, 0.0, 0.03);
  if (middle.y <= plan.m.jaw_height + 0.03) return jaw;
  const Vec3 skull = plan.loft.at(0.5 * (theta_of(front) + theta_of(ear)), std::max(middle.y, 0.2));
  const double low = std::max(0, row - (side_rows - 4)) / 3.0;
  return glm::mix(skull, jaw, 0.6 * low);
}

}  // namespace

CagePoint side_front(int row) {
  if (row == 0) return forehead_point(2, 6);
  if (row == 1) return forehead_point(1, 6);
  if (row <= 6) return eye_point(6, row + 4);
  return cheek_point(3, row - 6);
}

void add_forehead(const HeadPlan& plan, HeadCage& cage) {
  constexpr double theta[] = {0, 8, 17, 27, 37, 47, 57};
  for (int i = 0; i < forehead_places; ++i) {
    const Vec3& below = cage.at(brow_point(i));
    const double own = std::asin(std::min(1.0, below.x / std::hypot(below.x, below.z))) * radians_to_degrees;
    Vec3 low = plan.loft.at(glm::mix(own, theta[i], 0.45), middle_row_height(plan));
    Vec3 high = plan.loft.at(glm::mix(own, theta[i], 0.85), hair_row_height());
    if (i == 0) low.x = high.x = 0.0;
    cage.put(forehead_point(1, i), low);
    cage.put(forehead_point(2, i), high);
  }
  for (int i = 0; i + 1 < forehead_places; ++i) {
    cage.quad(forehead_point(2, i), forehead_point(1, i), forehead_point(1, i + 1), forehead_point(2, i + 1));
    cage.quad(forehead_point(1, i), brow_point(i), brow_point(i + 1), forehead_point(1, i + 1));
  }
}

void add_sides(const HeadPlan& plan, HeadCage& cage) {
  const auto heights = ear_row_heights(plan), back = back_row_heights(plan);
  constexpr double theta[] = {125, 145, 163, 180}, own[] = {0.6, 0.85, 1.0, 1.0};
  for (int row = 0; row < side_rows; ++row) {
    const auto ear = ear_columns(plan, row, heights);
    cage.put(side_point(0, row), temple(plan, cage.at(side_front(row)), ear[0], row));
    for (int i = 0; i < 3; ++i) {
      const bool in_hole = i == 1 && row > ear_first_row && row < ear_last_row;
      if (!in_hole) cage.put(side_point(1 + i, row), ear[static_cast<std::size_t>(i)]);
    }
    for (int i = 0; i < 4; ++i) {
      Vec3 p = plan.loft.at(theta[i], std::max(glm::mix(heights[row], back[row], own[i]), 0.2));
      if (i == 3) p.x = 0.0;
      cage.put(side_point(4 + i, row), p);
    }
  }
  const auto column = [](int c, int row) { return c < 0 ? side_front(row) : side_point(c, row); };
  for (int row = 0; row + 1 < side_rows; ++row)
    for (int c = -1; c + 1 < side_columns; ++c) {
      const bool under_ear = (c == 1 || c == 2) && row >= ear_first_row && row < ear_last_row;
      if (!under_ear) cage.quad(column(c, row), column(c, row + 1), column(c + 1, row + 1), column(c + 1, row));
    }
}

void add_cap(const HeadPlan& plan, HeadCage& cage) {
  constexpr int columns = 4, rows = 6;
  // The ring that it closes: forehead, then the sides' first row.
  const auto ring = [](int i) {
    return i < forehead_places ? forehead_point(2, i) : side_point(i - forehead_places, 0);
  };
  const auto point = [&](int column, int row) {
    if (row == 0) return ring(column);
    if (row == rows) return ring(14 - column);
    if (column == columns) return ring(columns + row);
    return CagePoint{HeadPart::cap, column, row};
  };
  const auto flat = [&](int column, int row) {
    const Vec3& p = cage.at(point(column, row));
    return Vec2(p.x, p.z);
  };
  // The first row stands at the hair line, where that is far enough from the ring.
  const double depth = flat(0, 0).y - flat(0, rows).y;
  const double first = std::clamp((flat(0, 0).y - plan.loft.front(plan.m.hair_line)) / depth, 0.06, 0.15);
  for (int column = 0; column < columns; ++column)
    for (int row = 1; row < rows; ++row) {
      // A Coons patch seen from above; heights by the skull.
      const double a = column / double(columns), b = row / double(rows);
      const double u = 0.4 * a + 0.6 * std::sin(0.5 * std::numbers::pi * a);
      const double v = row == 1 ? first : 0.4 * b + 0.6 * (0.5 - 0.5 * std::cos(std::numbers::pi * b));
      const Vec2 middle(0.0, glm::mix(flat(0, 0).y, flat(0, rows).y, v));
      const Vec2 p = (1 - v) * flat(column, 0) + v * flat(column, rows) + (1 - u) * middle + u * flat(columns, row) -
                     ((1 - u) * (1 - v) * flat(0, 0) + u * (1 - v) * flat(columns, 0) + (1 - u) * v * flat(0, rows) +
                      u * v * flat(columns, rows));
      const double theta = std::atan2(p.x, p.y) * radians_to_degrees;
      const double y = plan.loft.height_of(theta, glm::length(p), hair_row_height());
      cage.put(point(column, row), {column == 0 ? 0.0 : p.x, y, p.y});
    }
  for (int column = 0; column < columns; ++column)
    for (int row = 0; row < rows; ++row)
      cage.quad(point(column, row + 1), point(column, row), point(column + 1, row), point(column + 1, row + 1));
}

}  // namespace sinew
