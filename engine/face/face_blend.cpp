#include "engine/face/face_blend.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace sinew {
namespace {

constexpr double FaceLimits::*limits[] = {&FaceLimits::eyebrow_up_vertical,
                                          &FaceLimits::eyebrow_down_vertical,
                                          &FaceLimits::eyebrow_out_horizontal,
                                          &FaceLimits::eyebrow_in_horizontal,
                                          &FaceLimits::eyebrow_rotate_range,
                                          &FaceLimits::eyelid_upper_wide,
                                          &FaceLimits::eyelid_lower_up,
                                          &FaceLimits::eyeball_yaw,
                                          &FaceLimits::eyeball_up,
                                          &FaceLimits::eyeball_down,
                                          &FaceLimits::lip_up,
                                          &FaceLimits::lip_down,
                                          &FaceLimits::corner_out,
                                          &FaceLimits::corner_in,
                                          &FaceLimits::corner_up,
                                          &FaceLimits::corner_down,
                                          &FaceLimits::chin_drop,
                                          &FaceLimits::cheek_up,
                                          &FaceLimits::nose_wrinkle};
static_assert(sizeof(limits) / sizeof(limits[0]) * sizeof(double) == sizeof(FaceLimits));

constexpr double FaceVertex::*shares[] = {&FaceVertex::jaw, &FaceVertex::jaw_sealed, &FaceVertex::close_upper,
                                          &FaceVertex::close_lower, &FaceVertex::least_distance};
constexpr double FaceRig::*sizes[] = {&FaceRig::chin_reach, &FaceRig::chin_fall,   &FaceRig::eye_radius,
                                      &FaceRig::eye_scale,  &FaceRig::mouth_scale, &FaceRig::jaw_scale,
                                      &FaceRig::brow_inner, &FaceRig::brow_outer};

template <class Part, class Members>
void blend_members(const Part& b, double t, const Members& members, Part& to) {
  for (const auto member : members) to.*member = glm::mix(to.*member, b.*member, t);
}

}  // namespace

void give_same_signals(std::span<FaceRig* const> rigs) {
  if (rigs.empty()) return;
  const std::size_t vertices = rigs.front()->vertices.size();
  std::vector<std::set<std::uint32_t>> signals(vertices);
  for (const FaceRig* rig : rigs)
    for (std::size_t v = 0; v < vertices; ++v)
      for (std::uint32_t i = rig->first[v]; i < rig->first[v + 1]; ++i) signals[v].insert(rig->deltas[i].signal);
  for (FaceRig* rig : rigs) {
    FaceRig full = face_sizes(*rig);
    for (std::size_t v = 0; v < vertices; ++v) {
      std::vector<FaceDelta> run;
      for (const std::uint32_t signal : signals[v]) {
        const auto begin = rig->deltas.begin() + rig->first[v], end = rig->deltas.begin() + rig->first[v + 1];
        const auto found = std::find_if(begin, end, [&](const FaceDelta& delta) { return delta.signal == signal; });
        run.push_back(found != end ? *found : FaceDelta{signal, Vec3(0.0), Vec3(0.0)});
      }
      append_vertex(rig->vertices[v], run, full);
    }
    *rig = std::move(full);
  }
}

FaceRig blended_face(const FaceRig& a, const FaceRig& b, double t) {
  assert(a.deltas.size() == b.deltas.size() && a.vertices.size() == b.vertices.size());
  FaceRig out = a;
  for (std::size_t v = 0; v < out.vertices.size(); ++v) blend_members(b.vertices[v], t, shares, out.vertices[v]);
  for (std::size_t i = 0; i < out.deltas.size(); ++i) {
    out.deltas[i].position = glm::mix(a.deltas[i].position, b.deltas[i].position, t);
    out.deltas[i].normal = glm::mix(a.deltas[i].normal, b.deltas[i].normal, t);
  }
  blend_members(b, t, sizes, out);
  blend_members(b.limits, t, limits, out.limits);
  out.hinge = glm::mix(a.hinge, b.hinge, t);
  for (std::size_t eye = 0; eye < 2; ++eye) out.eye_centres[eye] = glm::mix(a.eye_centres[eye], b.eye_centres[eye], t);
  for (std::size_t i = 0; i < out.brow_outline.size(); ++i)
    out.brow_outline[i] = glm::mix(a.brow_outline[i], b.brow_outline[i], t);
  return out;
}

}  // namespace sinew
