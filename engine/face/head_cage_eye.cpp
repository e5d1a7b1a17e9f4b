/// The eye: socket, fold and lids as seven rings, the inner ones on spheres about the eyeball.

#include "engine/face/head_cage_parts.h"

namespace sinew {
namespace {

constexpr double pi = std::numbers::pi;

Vec3 on_sphere(const Vec3& centre, double radius, double azimuth, double elevation) {
  return centre + radius * Vec3(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                                std::cos(azimuth) * std::cos(elevation));
}

/// The socket's rim as it is drawn from the front.
std::array<Vec2, eye_places> rim_outline(const HeadPlan& plan) {
  const double x = plan.m.eye_spacing, e = plan.eye, b = plan.brow, rise = b - e;
  const double s = plan.eye_scale, low = plan.lower_scale, inner = 0.175 * x / 0.5;
  const double outer = x + 0.48 * (0.6 + 0.4 * s) * (0.35 + 0.65 * plan.loft.width_factor(e));
  return {Vec2{inner * 0.95, e},           {inner * 0.98, e + 0.5 * rise}, {inner * 1.06, e + 1.06 * rise},
          {x - 0.15 * s, b + 0.09},        {x + 0.05 * s, b + 0.135},      {x + 0.24 * s, b + 0.105},
          {outer - 0.07, b - 0.01},        {outer, e + 0.45 * rise},       {outer + 0.015, e - 0.03},
          {outer - 0.005, e - 0.18 * low}, {outer - 0.08, e - 0.32 * low}, {x + 0.24 * s, e - 0.40 * low},
          {x + 0.04 * s, e - 0.42 * low},  {x - 0.15 * s, e - 0.40 * low}, {inner * 1.15, e - 0.33 * low},
          {inner * 1.03, e - 0.17 * low}};
}

void add_rim(const HeadPlan& plan, HeadCage& cage) {
  const std::array<Vec2, eye_places> outline = rim_outline(plan);
  const double beside_nasion = plan.nasion - 0.115;
  constexpr double ridge[] = {1.0, 0.9, 0.8, 0.6};
  for (int k = 0; k < eye_places; ++k) {
    const Vec2 p = outline[static_cast<std::size_t>(k)];
    double z = plan.loft.depth(p.x, p.y);
    if (k == 0) z = beside_nasion;
    if (k == 1) z = beside_nasion + 0.03;
    if (k == 15) z = beside_nasion + 0.02;
    if (k == 14) z += 0.02;
    if (k >= 3 && k <= 6) z += plan.m.brow_ridge * ridge[k - 3];
    if (k >= 10 && k <= 13) z += plan.cheek_bone(p.x, p.y);
    cage.put(eye_point(6, k), {p, z});
  }
}

/// Ring 5: half way between fold and rim, above hanging over the fold.
Vec3 fold_over(const HeadPlan& plan, const Vec3& fold, const Vec3& rim, int k, double bow) {
  const bool upper = k > 0 && k < 8;
  Vec3 p = glm::mix(fold, rim, upper ? 0.36 : 0.5);
  if (upper) p.z = glm::mix(fold.z, rim.z, 0.62) + 0.035 * bow;
  if (k == 0 || k == 1 || k == 15) {
    // Else the corner beside the nose is a dark canyon.
    p = 0.5 * (fold + rim);
    p.z += 0.035;
  }
  if (k >= 9 && k <= 14)
    p.z += 0.012 * std::pow(plan.m.lid_thickness, 3) + plan.m.lid_puff * std::sin(pi * (k - 8) / 7.0);
  return p;
}

void add_lid_rings(const HeadPlan& plan, int k, HeadCage& cage) {
  const LidAngle margin = lid_margin(plan, k);
  const double r = plan.m.eye_radius, root = std::sqrt(plan.eye_scale), thick = plan.m.lid_thickness;
  const double away = k == 0 || k == 8 ? 0.0 : (k < 8 ? 1.0 : -1.0);
  const double corner = k == 0 ? -1.0 : (k == 8 ? 1.0 : 0.0);
  const double spread = 2 * margin.along - 1, bow = std::sin(pi * margin.along);
  const bool upper = away > 0;
  const auto ring = [&](int number, double radius, double azimuth_degrees, double elevation_degrees) {
    cage.put(eye_point(number, k),
             on_sphere(plan.eye_centre, radius, margin.azimuth + azimuth_degrees * degrees_to_radians,
                       margin.elevation + away * elevation_degrees * degrees_to_radians));
  };
  ring(0, r - 0.035, 0, 0);
  ring(1, r + 0.010, 0, 0);
  ring(2, r + 0.048 * root * thick, 1.5 * corner, 2.2);
  ring(3, r + (upper ? 0.056 : 0.046) * root * thick, 7 * corner + 2 * spread, 3 + (upper ? 9 : 6) * bow);
  ring(4, r + (upper ? 0.040 : (k == 0 ? 0.075 : 0.058)) * root, 9 * corner + 4 * spread,
       4.5 + (upper ? 13.5 : 13) * bow);
  cage.put(eye_point(5, k), fold_over(plan, cage.at(eye_point(4, k)), cage.at(eye_point(6, k)), k, bow));
}

}  // namespace

LidAngle lid_margin(const HeadPlan& plan, int place) {
  const HeadMeasures& m = plan.m;
  // The margin lies on the lid, a little outside the ball.
  const auto angle = [&](double length) { return std::asin(std::clamp(length / (1.06 * m.eye_radius), -0.95, 0.95)); };
  double t = place <= 8 ? place / 8.0 : (16 - place) / 8.0;
  t = 0.45 * t + 0.55 * (0.5 - 0.5 * std::cos(pi * t));  // denser towards the corners
  LidAngle out{glm::mix(angle(m.lid_inner), angle(m.lid_outer), t),
               glm::mix(angle(m.lid_inner_rise), angle(m.lid_outer_rise), t), t};
  if (place > 0 && place < 8) out.elevation += angle(m.lid_upper) * std::pow(std::sin(pi * std::pow(t, 0.88)), 0.8);
  if (place > 8) out.elevation -= angle(m.lid_lower) * std::pow(std::sin(pi * std::pow(t, 1.2)), 0.85);
  return out;
}

void add_eye(const HeadPlan& plan, HeadCage& cage) {
  add_rim(plan, cage);
  for (int k = 0; k < eye_places; ++k) add_lid_rings(plan, k, cage);
  for (int ring = 0; ring < 6; ++ring)
    for (int k = 0; k < eye_places; ++k)
      cage.quad(eye_point(ring, k), eye_point(ring, k + 1), eye_point(ring + 1, k + 1), eye_point(ring + 1, k),
                ring == 1 && k > 0 && k < 8 ? SkinKind::lash : SkinKind::skin);
}

}  // namespace sinew
