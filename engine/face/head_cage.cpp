#include "engine/face/head_cage.h"

#include <cassert>

#include "engine/face/head_cage_parts.h"

namespace sinew {
namespace {

constexpr double adult_eye_radius = 0.30, adult_mouth_width = 0.40, adult_eye_to_nose = 0.75;
/// How far the underside of the chin lies behind its front.
constexpr double chin_underside = 0.12;

}  // namespace

HeadPlan::HeadPlan(const HeadMeasures& measures) : m(measures), loft(measures) {
  brow = m.brow_height;
  eye = m.eye_height;
  nose = m.nose_height;
  mouth = m.mouth_height;
  eye_scale = m.eye_radius / adult_eye_radius;
  lower_scale = std::min(eye_scale, (eye - nose) / adult_eye_to_nose);
  mouth_scale = m.mouth_width / adult_mouth_width;
  eye_centre = {m.eye_spacing, eye, m.eye_depth - m.eye_radius};
  nasion = loft.front(eye) + m.nasion_depth;
  nose_base = loft.front(nose) + 0.115;
  lip_line = loft.front(mouth) + m.lip_depth;
  corner = loft.depth(m.mouth_width, mouth) + 0.035;
}

double HeadPlan::cheek_bone(double x, double y) const {
  constexpr double reach = 0.26;
  const double across = (x - 1.1 * m.eye_spacing) / reach, up = (y - glm::mix(nose, eye, 0.16)) / reach;
  return m.cheek_bone * std::exp(-across * across - up * up);
}

Vec3 HeadPlan::cheek_puff(double x, double y) const {
  const double across = (x - 1.5 * m.eye_spacing) / 0.46, up = (y - glm::mix(mouth, nose, 0.35)) / 0.42;
  return m.cheek_puff * std::exp(-across * across - up * up) * Vec3(0.75, 0.0, 0.65);
}

Vec3 HeadPlan::chin_edge(int column) const {
  const double w = m.chin_width, z = m.chin_depth - chin_underside;
  const std::array<Vec3, 4> edge = {
      Vec3{0.0, 0.0, z}, {0.42 * w, 0.0, z - 0.01}, {0.80 * w, 0.022, z - 0.055}, {1.16 * w, 0.075, z - 0.16}};
  return edge[static_cast<std::size_t>(column)];
}

Vec3 HeadPlan::jaw_edge(double t) const {
  const Vec3 from = chin_edge(3), to = jaw_angle();
  const Vec3 control = 0.5 * (from + to) + Vec3(0.10, -0.045, 0.12);
  return (1 - t) * (1 - t) * from + 2 * t * (1 - t) * control + t * t * to;
}

std::uint32_t HeadCage::put(const CagePoint& name, const Vec3& position) {
  const auto [place, is_new] = indices_.try_emplace(name, static_cast<std::uint32_t>(positions.size()));
  assert(is_new);
  positions.push_back(position);
  names.push_back(name);
  return place->second;
}

void HeadCage::quad(const CagePoint& a, const CagePoint& b, const CagePoint& c, const CagePoint& d, SkinKind kind) {
  quads.push_back({{index(a), index(b), index(c), index(d)}, kind});
}

HeadCage build_head_cage(const HeadPlan& plan) {
  HeadCage cage;
  add_eye(plan, cage);
  add_nose(plan, cage);
  add_mouth(plan, cage);
  add_nostril(cage);
  add_cheek(plan, cage);
  add_forehead(plan, cage);
  add_sides(plan, cage);
  add_cap(plan, cage);
  add_ear(plan, cage);
  add_neck(plan, cage);
  puff_cheek(plan, cage);
  relax_cheek(cage);
  return cage;
}

}  // namespace sinew
