#include "engine/deform/face.h"

#include <algorithm>

#include "engine/core/parallel.h"

namespace sinew {
namespace {

/// Turns p about the x axis through the origin; y towards z for positive angles.
Vec3 turned_x(const Vec3& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {p.x, p.y * c - p.z * s, p.y * s + p.z * c};
}

Vec3 turned_y(const Vec3& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {p.x * c + p.z * s, p.y, p.z * c - p.x * s};
}

Vec3 posed_vertex(const FaceRig& rig, const FaceState& state, std::size_t v, const Vec3& rest) {
  const FaceVertex& vertex = rig.vertices[v];
  if (vertex.ball) {
    const Vec3& centre = rig.eye_centres[static_cast<std::size_t>(vertex.eye)];
    const Vec2& gaze = state.gaze[static_cast<std::size_t>(vertex.eye)];
    return centre + state.eye_share * turned_y(turned_x(rest - centre, -gaze.y), gaze.x);
  }
  Vec3 p = rest;
  const double jaw = glm::mix(vertex.jaw, vertex.jaw_sealed, state.seal);
  if (jaw != 0.0 && state.jaw_angle != 0.0) {
    p = rig.hinge + turned_x(p - rig.hinge, jaw * state.jaw_angle);
    p.z += jaw * state.jaw_forward;
  }
  for (std::uint32_t i = rig.first[v]; i < rig.first[v + 1]; ++i)
    p += state.signals[rig.deltas[i].signal] * rig.deltas[i].position;
  if (vertex.eye < 0) return p;
  const auto eye = static_cast<std::size_t>(vertex.eye);
  const double angle = vertex.close_upper * state.upper_lid[eye] - vertex.close_lower * state.lower_lid[eye];
  Vec3 from_centre = p - rig.eye_centres[eye];
  if (angle != 0.0) from_centre = turned_x(from_centre, angle);
  const double distance = glm::length(from_centre);
  if (distance < vertex.least_distance) from_centre *= vertex.least_distance / distance;
  return rig.eye_centres[eye] + from_centre;
}

Vec3 posed_normal(const FaceRig& rig, const FaceState& state, std::size_t v, const Vec3& rest) {
  Vec3 n = rest;
  for (std::uint32_t i = rig.first[v]; i < rig.first[v + 1]; ++i)
    n += state.signals[rig.deltas[i].signal] * rig.deltas[i].normal;
  return unit_or(turned_with_face(rig, state, v, n), rest);
}

}  // namespace

Vec3 turned_with_face(const FaceRig& rig, const FaceState& state, std::size_t v, const Vec3& direction) {
  const FaceVertex& vertex = rig.vertices[v];
  if (vertex.ball) {
    const Vec2& gaze = state.gaze[static_cast<std::size_t>(vertex.eye)];
    return turned_y(turned_x(direction, -gaze.y), gaze.x);
  }
  Vec3 turned = turned_x(direction, glm::mix(vertex.jaw, vertex.jaw_sealed, state.seal) * state.jaw_angle);
  if (vertex.eye < 0) return turned;
  const auto eye = static_cast<std::size_t>(vertex.eye);
  return turned_x(turned, vertex.close_upper * state.upper_lid[eye] - vertex.close_lower * state.lower_lid[eye]);
}

FaceState face_state(const FaceRig& rig, const FaceChannels& channels) {
  using C = FaceChannel;
  const auto value = [&](C c) { return channel(channels, c); };
  FaceState out;
  const auto side = [&](FaceSignal signal, std::size_t s) -> double& { return out.signals[signal_index(signal, s)]; };
  const auto split = [&](double x, FaceSignal positive, FaceSignal negative, std::size_t s) {
    side(positive, s) = std::max(0.0, x);
    side(negative, s) = std::max(0.0, -x);
  };
  for (std::size_t s = 0; s < 2; ++s) {
    // Outward is the viewer's right on the character's left side.
    const double outward = s == 0 ? 1.0 : -1.0;
    split(outward * value(s == 0 ? C::brow_left_right : C::brow_right_right), FaceSignal::brow_out, FaceSignal::brow_in,
          s);
    split(value(s == 0 ? C::brow_left_up : C::brow_right_up), FaceSignal::brow_up, FaceSignal::brow_down, s);
    // Counter-clockwise raises the outer end of the left brow, clockwise that of the right.
    const double turn = outward * value(s == 0 ? C::brow_left_turn : C::brow_right_turn) * degrees_to_radians;
    split(std::tan(turn), FaceSignal::brow_turn_outer, FaceSignal::brow_turn_inner, s);
    split(outward * value(s == 0 ? C::corner_left_right : C::corner_right_right), FaceSignal::corner_out,
          FaceSignal::corner_in, s);
    split(value(s == 0 ? C::corner_left_up : C::corner_right_up), FaceSignal::corner_up, FaceSignal::corner_down, s);
    side(FaceSignal::cheek_up, s) = value(s == 0 ? C::cheek_left_up : C::cheek_right_up);
    out.upper_lid[s] = value(s == 0 ? C::upper_lid_left : C::upper_lid_right);
    out.lower_lid[s] = value(s == 0 ? C::lower_lid_left : C::lower_lid_right);
    split(out.upper_lid[s], FaceSignal::lid_close, FaceSignal::lid_wide, s);
    side(FaceSignal::lid_lower, s) = out.lower_lid[s];
    out.gaze[s] = degrees_to_radians * Vec2(value(s == 0 ? C::eye_left_yaw : C::eye_right_yaw),
                                            value(s == 0 ? C::eye_left_pitch : C::eye_right_pitch));
  }
  const auto middle = [&](FaceMiddleSignal signal) -> double& { return out.signals[signal_index(signal)]; };
  middle(FaceMiddleSignal::upper_lip_up) = value(C::upper_lip_up);
  middle(FaceMiddleSignal::lower_lip_up) = std::max(0.0, value(C::lower_lip_up));
  middle(FaceMiddleSignal::lower_lip_down) = std::max(0.0, -value(C::lower_lip_up));
  middle(FaceMiddleSignal::pucker) = value(C::lip_pucker);
  middle(FaceMiddleSignal::press) = value(C::lip_press);
  middle(FaceMiddleSignal::nose) = value(C::nose_wrinkle);
  middle(FaceMiddleSignal::jaw) = value(C::jaw_drop);

  constexpr double given_back = 0.45;
  out.jaw_angle = value(C::jaw_drop) / rig.chin_reach;
  const double rest_angle = std::atan2(-rig.chin_fall, rig.chin_reach);
  const double swing =
      std::hypot(rig.chin_reach, rig.chin_fall) * (std::cos(rest_angle) - std::cos(rest_angle - out.jaw_angle));
  out.jaw_forward = given_back * swing;
  out.seal = value(C::lip_seal);
  return out;
}

Result<void> FaceJob::validate() const {
  const std::size_t n = rig.vertices.size();
  if (rig.first.size() != n + 1) return bad_input("first has {} entries for {} vertices", rig.first.size(), n);
  if (rest.size() != n) return bad_input("rest has {} of {} vertices", rest.size(), n);
  if (posed.size() != n) return bad_input("posed has {} of {} vertices", posed.size(), n);
  if (normals.empty()) return {};
  if (normals.size() != n) return bad_input("normals has {} of {} vertices", normals.size(), n);
  if (rest_normals.size() != n) return bad_input("rest_normals has {} of {} vertices", rest_normals.size(), n);
  return {};
}

void FaceJob::run() const {
  parallel_for(rest.size(), [&](std::size_t v) {
    posed[v] = posed_vertex(rig, state, v, rest[v]);
    if (!normals.empty()) normals[v] = posed_normal(rig, state, v, rest_normals[v]);
  });
}

}  // namespace sinew
