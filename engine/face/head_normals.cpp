#include "engine/face/head_normals.h"

#include <algorithm>

#include "engine/deform/face.h"

namespace sinew {
namespace {

using C = FaceChannel;

/// Channels that bring one signal to its limit and leave all others alone.
FaceChannels at_limit(const FaceRig& face, std::size_t signal) {
  const FaceLimits& l = face.limits;
  FaceChannels out{};
  const auto set = [&](C c, double x) { channel(out, c) = x; };
  if (signal >= 2 * face_side_signals) {
    switch (static_cast<FaceMiddleSignal>(signal - 2 * face_side_signals)) {
      case FaceMiddleSignal::upper_lip_up:
        set(C::upper_lip_up, l.lip_up);
        break;
      case FaceMiddleSignal::lower_lip_up:
        set(C::lower_lip_up, l.lip_up);
        break;
      case FaceMiddleSignal::lower_lip_down:
        set(C::lower_lip_up, -l.lip_down);
        break;
      case FaceMiddleSignal::pucker:
        set(C::lip_pucker, 1.0);
        break;
      case FaceMiddleSignal::press:
        set(C::lip_press, 1.0);
        break;
      case FaceMiddleSignal::nose:
        set(C::nose_wrinkle, l.nose_wrinkle);
        break;
      case FaceMiddleSignal::jaw:
        set(C::jaw_drop, l.chin_drop);
        break;
    }
    return out;
  }
  const bool left = signal < face_side_signals;
  const double outward = left ? 1.0 : -1.0;
  switch (static_cast<FaceSignal>(signal % face_side_signals)) {
    case FaceSignal::brow_out:
      set(left ? C::brow_left_right : C::brow_right_right, outward * l.eyebrow_out_horizontal);
      break;
    case FaceSignal::brow_in:
      set(left ? C::brow_left_right : C::brow_right_right, -outward * l.eyebrow_in_horizontal);
      break;
    case FaceSignal::brow_up:
      set(left ? C::brow_left_up : C::brow_right_up, l.eyebrow_up_vertical);
      break;
    case FaceSignal::brow_down:
      set(left ? C::brow_left_up : C::brow_right_up, -l.eyebrow_down_vertical);
      break;
    case FaceSignal::brow_turn_outer:
      set(left ? C::brow_left_turn : C::brow_right_turn, outward * l.eyebrow_rotate_range);
      break;
    case FaceSignal::brow_turn_inner:
      set(left ? C::brow_left_turn : C::brow_right_turn, -outward * l.eyebrow_rotate_range);
      break;
    case FaceSignal::corner_out:
      set(left ? C::corner_left_right : C::corner_right_right, outward * l.corner_out);
      break;
    case FaceSignal::corner_in:
      set(left ? C::corner_left_right : C::corner_right_right, -outward * l.corner_in);
      break;
    case FaceSignal::corner_up:
      set(left ? C::corner_left_up : C::corner_right_up, l.corner_up);
      break;
    case FaceSignal::corner_down:
      set(left ? C::corner_left_up : C::corner_right_up, -l.corner_down);
      break;
    case FaceSignal::cheek_up:
      set(left ? C::cheek_left_up : C::cheek_right_up, l.cheek_up);
      break;
    case FaceSignal::lid_close:
      set(left ? C::upper_lid_left : C::upper_lid_right, 1.0);
      break;
    case FaceSignal::lid_wide:
      set(left ? C::upper_lid_left : C::upper_lid_right, -l.eyelid_upper_wide);
      break;
    case FaceSignal::lid_lower:
      set(left ? C::lower_lid_left : C::lower_lid_right, l.eyelid_lower_up);
      break;
  }
  return out;
}

Vec3 turned_back(const FaceRig& face, const FaceState& state, std::size_t v, const Vec3& normal) {
  const FaceVertex& vertex = face.vertices[v];
  double angle = vertex.jaw * state.jaw_angle;
  if (vertex.eye >= 0 && !vertex.ball) {
    const auto eye = static_cast<std::size_t>(vertex.eye);
    angle += vertex.close_upper * state.upper_lid[eye] - vertex.close_lower * state.lower_lid[eye];
  }
  const double c = std::cos(angle), s = std::sin(angle);
  return {normal.x, normal.y * c + normal.z * s, normal.z * c - normal.y * s};
}

}  // namespace

std::vector<Vec3> head_normals(const Head& head, const std::vector<Vec3>& positions) {
  std::vector<Vec3> sums(positions.size(), Vec3(0.0));
  for (const HeadTriangle& t : head.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& here = positions[t.corners[i]];
      const Vec3 next = positions[t.corners[(i + 1) % 3]] - here, last = positions[t.corners[(i + 2) % 3]] - here;
      const double size = glm::length(next) * glm::length(last);
      if (size <= 0.0) continue;
      const double angle = std::acos(std::clamp(glm::dot(next, last) / size, -1.0, 1.0));
      sums[t.corners[i]] += angle * unit_or(glm::cross(next, last), Vec3(0.0));
    }
  std::vector<Vec3> out(positions.size());
  for (std::size_t v = 0; v < out.size(); ++v) out[v] = unit_or(sums[v], Vec3(0.0, 0.0, 1.0));
  return out;
}

void add_normal_deltas(Head& head) {
  constexpr double nothing = 1e-4;
  FaceRig& face = head.face;
  std::vector<std::vector<FaceDelta>> added(head.positions.size());
  for (std::size_t v = 0; v < added.size(); ++v)
    added[v].assign(face.deltas.begin() + face.first[v], face.deltas.begin() + face.first[v + 1]);
  for (std::size_t signal = 0; signal < face_signals; ++signal) {
    const FaceChannels channels = at_limit(face, signal);
    const FaceState state = face_state(face, channels);
    const double amount = state.signals[signal];
    if (amount == 0.0) continue;
    const std::vector<Vec3> normals = head_normals(head, posed_positions(head, channels));
    for (std::size_t v = 0; v < normals.size(); ++v) {
      // Teeth and tongue only turn.
      if (face.vertices[v].ball || (v >= head.skin_vertices && added[v].empty())) continue;
      const Vec3 change = turned_back(face, state, v, normals[v]) - head.normals[v];
      if (glm::length(change) < nothing) continue;
      const auto entry = std::ranges::find(added[v], signal, &FaceDelta::signal);
      if (entry != added[v].end())
        entry->normal = change / amount;
      else
        added[v].push_back({static_cast<std::uint32_t>(signal), Vec3(0.0), change / amount});
    }
  }
  face.deltas.clear();
  face.first.assign(1, 0);
  for (const auto& run : added) {
    face.deltas.insert(face.deltas.end(), run.begin(), run.end());
    face.first.push_back(static_cast<std::uint32_t>(face.deltas.size()));
  }
}

}  // namespace sinew
