/// The mouth: lips as half rings from the inside out, the skin round them, and the bag behind.

#include "engine/face/head_cage_parts.h"

namespace sinew {
namespace {

constexpr int corner = 5, last = mouth_places - 1;

bool is_upper(int j) { return j <= corner; }
/// Steps from the middle, 0 to 5.
int step(int j) { return is_upper(j) ? j : last - j; }

/// Distance of a place from the middle.
double across(const HeadPlan& plan, int j) {
  constexpr double x[] = {0.0, 0.085, 0.185, 0.275, 0.35, 0.40};
  return x[step(j)] * plan.mouth_scale;
}

/// Depth of the line where the lips meet.
double contact_depth(const HeadPlan& plan, double x) {
  const double t = std::min(1.0, x / plan.m.mouth_width);
  return glm::mix(plan.lip_line, plan.corner, t * t);
}

void add_lips(const HeadPlan& plan, HeadCage& cage) {
  const double mw = plan.m.mouth_width, k = plan.mouth_scale, mouth = plan.mouth;
  constexpr double upper_border[] = {0.90, 1.03, 0.88, 0.62, 0.32};
  constexpr double lower_border[] = {1.0, 0.985, 0.90, 0.68, 0.36};
  for (int j = 0; j < mouth_places; ++j) {
    if (j == corner) {
      cage.put(mouth_point(0, j), {mw - 0.02, mouth, plan.corner - 0.30});
      cage.put(mouth_point(1, j), {mw - 0.03, mouth, plan.corner - 0.09});
      cage.put(mouth_point(2, j), {mw, mouth, plan.corner - 0.01});
      cage.put(mouth_point(3, j), {mw + 0.012, mouth, plan.corner});
      cage.put(mouth_point(4, j), {mw + 0.03, mouth, plan.corner + 0.002});
      continue;
    }
    const bool upper = is_upper(j);
    const int i = step(j);
    const double x = across(plan, j), z = contact_depth(plan, x), sign = upper ? 1.0 : -1.0;
    const double fade = 1.0 - i / 5.0, root = std::sqrt(fade);
    const double border = upper ? plan.m.upper_lip * upper_border[i] : -plan.m.lower_lip * lower_border[i];
    // The line of contact dips beside the middle, as a bow does.
    const double bow = 0.8 * (0.012 * std::cos(2 * std::numbers::pi * std::min(1.0, 1.2 * x / mw)) - 0.006);
    cage.put(mouth_point(0, j), {0.9 * x, mouth + sign * (0.16 * root + 0.02), z - 0.25});
    cage.put(mouth_point(1, j), {0.96 * x, mouth + sign * 0.03, z - 0.075});
    cage.put(mouth_point(2, j), {x, mouth + sign * 0.003 + bow, z});
    cage.put(mouth_point(3, j), {1.005 * x, mouth + 0.45 * border, z + (upper ? 0.055 : 0.062) * k * root});
    cage.put(mouth_point(4, j), {1.01 * x, mouth + border, z + (upper ? 0.045 : 0.012) * std::pow(fade, 0.6) * k});
  }
}

/// The outermost ring: under the nose, beside the corner, round the chin.
Vec3 outer_ring(const HeadPlan& plan, int j) {
  const double n = plan.nose, mouth = plan.mouth, mw = plan.m.mouth_width, nw = plan.m.nose_width;
  const double base = plan.nose_base, beside_wing = plan.loft.depth(1.05 * nw, n);
  switch (j) {
    case 0:
      return {0.0, n - 0.012, base};
    case 1:
      return {0.085 * nw / 0.26, n - 0.02, base - 0.015};
    case 2:
      return {0.72 * nw, n - 0.005, base - 0.045};
    case 3:
      return {1.05 * nw, n - 0.02, beside_wing + 0.005};
    case 4: {
      const double x = 1.17 * mw, y = glm::mix(mouth, n, 0.58);
      return {x, y, plan.loft.depth(x, y) + 0.015};
    }
    case corner:
      return {1.40 * mw, mouth + 0.01, plan.loft.depth(1.40 * mw, mouth + 0.01) + 0.004};
    case 6: {
      const double x = 1.22 * mw, y = 0.67 * mouth;
      return {x, y, plan.loft.depth(x, y)};
    }
    default: {
      constexpr double xs[] = {0.86, 0.56, 0.28, 0.0}, ys[] = {0.44, 0.40, 0.38, 0.375};
      const double x = xs[j - 7] * mw, y = ys[j - 7] * mouth;
      const double skull = plan.loft.depth(x, std::max(y, 0.4)), t = (x / mw) * (x / mw);
      const double chin = plan.m.chin_depth;
      const double z = j == 7 ? 0.5 * (chin - 0.1) + 0.5 * skull : glm::mix(chin + plan.m.chin_boss, skull, t);
      return {x, y, z};
    }
  }
}

/// Between border and outermost ring. The groove above the chin is flush with it: as a trench it would make a puppet.
Vec3 skin_ring(const HeadPlan& plan, const Vec3& border, const Vec3& outer, int j) {
  Vec3 p = glm::mix(border, outer, j <= 4 ? 0.5 : (j <= 6 ? 0.42 : 0.55));
  if (j <= 1) p.z -= 0.012 * (1 - j);
  if (j == 2 || j == 3) p.z += 0.006;
  if (j == corner) p.z -= 0.004;
  if (j >= 7) {
    const double to_corner = (last - j) / 3.0, middle = 1 - to_corner * to_corner;
    p.z = 0.5 * (border.z + outer.z) * (1 - 0.8 * middle) + plan.m.chin_depth * 0.8 * middle - 0.01 * middle;
  }
  return p;
}

/// Columns and rows of the bag's end; its outer points are those of ring 0.
void add_bag(const HeadPlan& plan, HeadCage& cage) {
  constexpr int columns = 3, rows = 4;
  const auto point = [](int column, int row) {
    if (row == 0) return mouth_point(0, column);
    if (row == rows) return mouth_point(0, last - column);
    if (column == columns) return mouth_point(0, columns + row);
    return CagePoint{HeadPart::bag, column, row};
  };
  for (int column = 0; column < columns; ++column)
    for (int row = 1; row < rows; ++row)
      cage.put(point(column, row), {0.9 * across(plan, column), plan.mouth + 0.17 - 0.085 * row, plan.corner - 0.55});
  for (int column = 0; column < columns; ++column)
    for (int row = 0; row < rows; ++row)
      cage.quad(point(column, row), point(column, row + 1), point(column + 1, row + 1), point(column + 1, row),
                SkinKind::mouth);
}

}  // namespace

void add_mouth(const HeadPlan& plan, HeadCage& cage) {
  add_lips(plan, cage);
  for (int j = 0; j < mouth_places; ++j) cage.put(mouth_point(6, j), outer_ring(plan, j));
  for (int j = 0; j < mouth_places; ++j)
    cage.put(mouth_point(5, j), skin_ring(plan, cage.at(mouth_point(4, j)), cage.at(mouth_point(6, j)), j));
  constexpr SkinKind kinds[] = {SkinKind::mouth, SkinKind::mouth, SkinKind::lip,
                                SkinKind::lip,   SkinKind::skin,  SkinKind::skin};
  for (int ring = 0; ring < 6; ++ring)
    for (int j = 0; j < last; ++j)
      cage.quad(mouth_point(ring + 1, j), mouth_point(ring + 1, j + 1), mouth_point(ring, j + 1), mouth_point(ring, j),
                kinds[ring]);
  add_bag(plan, cage);
  // From the nose's base to the ring; the nostril stands between.
  cage.quad(nose_point(0, 7), mouth_point(6, 0), mouth_point(6, 1), nose_point(1, 7));
  cage.quad(nose_point(2, 7), mouth_point(6, 2), mouth_point(6, 3), nose_point(3, 7));
}

}  // namespace sinew
