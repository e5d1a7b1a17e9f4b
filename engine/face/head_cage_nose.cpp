/// The nose: ridge, tip, wings and nostrils.

#include "engine/face/head_cage_parts.h"

namespace sinew {
namespace {

constexpr int rows = 8;

/// What bounds the nose beside ring 1: the eye's rim above, the wing below.
CagePoint beside(int row) {
  constexpr int rim[] = {2, 1, 0, 15, 14};
  return row <= 4 ? eye_point(6, rim[row]) : nose_point(2, row);
}

/// The ridge from the root to the tip: straight with a slight dip.
struct Ridge {
  double top, bottom, root, tip;
  double depth(double y) const { return root + (tip - 0.015 - root) * std::pow((top - y) / (top - bottom), 1.25); }
};

void add_ridge(const HeadPlan& plan, HeadCage& cage) {
  const HeadMeasures& m = plan.m;
  const double rise = plan.brow - plan.eye, tip_height = plan.nose + m.nose_tip_rise;
  const double tip = plan.nose_base + m.nose_length;
  const Ridge ridge{plan.eye, tip_height, plan.nasion, tip};
  const double below_eye = cage.at(eye_point(6, 15)).y, above_wing = cage.at(eye_point(6, 14)).y;
  const double wing = glm::mix(tip_height, above_wing, 0.42);
  const Vec2 middle[rows] = {{plan.brow + 0.03, plan.loft.front(plan.brow + 0.03) + 0.012},
                             {plan.eye + 0.5 * rise, plan.nasion + 0.008},
                             {plan.eye, plan.nasion},
                             {below_eye, ridge.depth(below_eye)},
                             {above_wing, ridge.depth(above_wing)},
                             {wing, ridge.depth(wing) + 0.01},
                             {tip_height, tip},
                             {plan.nose + 0.045, tip - 0.055}};
  const double b = m.bridge_width;
  const double x[rows] = {0.105, 0.085, 0.95 * b, b, 1.05 * b, 1.25 * b, 1.35 * b, 0.95 * b};
  constexpr double back[rows] = {0.008, 0.012, 0.018, 0.022, 0.024, 0.03, 0.045, 0.03};
  for (int i = 0; i < rows; ++i) {
    cage.put(nose_point(0, i), {0.0, middle[i].x, middle[i].y});
    cage.put(nose_point(1, i), {x[i], middle[i].x - (i == 7 ? 0.012 : 0.0), middle[i].y - back[i]});
  }
}

void add_wing(const HeadPlan& plan, HeadCage& cage) {
  const double w = plan.m.nose_width, n = plan.nose, base = plan.nose_base;
  const double tip_height = n + plan.m.nose_tip_rise, top = cage.at(eye_point(6, 13)).y;
  cage.put(nose_point(2, 5), {0.68 * w, cage.at(nose_point(0, 5)).y + 0.005, base});
  cage.put(nose_point(2, 6), {0.95 * w, tip_height - 0.035, base + 0.015});
  cage.put(nose_point(2, 7), {0.88 * w, n + 0.03, base});
  // The crease's rows keep between the eye's rim and the nose's base, however near these are.
  const double heights[] = {glm::mix(top, n, 0.27), glm::mix(top, n, 0.58), glm::mix(top, n, 0.87)};
  cage.put(nose_point(3, 5), {1.08 * w, heights[0], plan.loft.depth(1.08 * w, heights[0]) + 0.015});
  cage.put(nose_point(3, 6), {1.09 * w, heights[1], plan.loft.depth(1.10 * w, heights[1]) - 0.01});
  cage.put(nose_point(3, 7), {1.06 * w, heights[2], plan.loft.depth(1.05 * w, n)});
}

}  // namespace

void add_nose(const HeadPlan& plan, HeadCage& cage) {
  add_ridge(plan, cage);
  add_wing(plan, cage);
  for (int i = 0; i + 1 < rows; ++i) {
    cage.quad(nose_point(0, i), nose_point(0, i + 1), nose_point(1, i + 1), nose_point(1, i));
    cage.quad(nose_point(1, i), nose_point(1, i + 1), beside(i + 1), beside(i));
  }
  const auto crease = [](int row) { return row == 4 ? eye_point(6, 13) : nose_point(3, row); };
  for (int i = 4; i + 1 < rows; ++i) cage.quad(beside(i), beside(i + 1), crease(i + 1), crease(i));
}

void add_nostril(HeadCage& cage) {
  const CagePoint rim[] = {nose_point(1, 7), mouth_point(6, 1), mouth_point(6, 2), nose_point(2, 7)};
  Vec3 middle(0.0);
  for (const CagePoint& p : rim) middle += 0.25 * cage.at(p);
  const auto inner = [](int ring, int i) { return CagePoint{HeadPart::nostril, ring, i % 4}; };
  for (int i = 0; i < 4; ++i) {
    const Vec3 out = cage.at(rim[i]) - middle;
    cage.put(inner(0, i), middle + 0.66 * out + Vec3(0.0, 0.012, 0.0));
    cage.put(inner(1, i), middle + 0.45 * out + Vec3(-0.005, 0.085, -0.01));
  }
  for (int i = 0; i < 4; ++i) {
    cage.quad(rim[i], rim[(i + 1) % 4], inner(0, i + 1), inner(0, i));
    cage.quad(inner(0, i), inner(0, i + 1), inner(1, i + 1), inner(1, i), SkinKind::nostril);
  }
  cage.quad(inner(1, 0), inner(1, 1), inner(1, 2), inner(1, 3), SkinKind::nostril);
}

}  // namespace sinew
