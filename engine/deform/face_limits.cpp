#include <algorithm>
#include <cmath>

#include "engine/deform/face.h"

namespace sinew {
namespace {

using C = FaceChannel;

/// How far the brow's outline goes above and below its rest extent when turned alone.
struct BrowReach {
  double above = 0.0, below = 0.0;
};

BrowReach brow_reach(const FaceRig& rig, double turn_outward_degrees) {
  const double slope = std::tan(turn_outward_degrees * degrees_to_radians);
  const double pivot = slope > 0 ? rig.brow_inner : rig.brow_outer;
  double rest_high = -INFINITY, rest_low = INFINITY, high = -INFINITY, low = INFINITY;
  for (const Vec2& p : rig.brow_outline) {
    const double y = p.y + slope * (p.x - pivot);
    rest_high = std::max(rest_high, p.y);
    rest_low = std::min(rest_low, p.y);
    high = std::max(high, y);
    low = std::min(low, y);
  }
  if (rig.brow_outline.empty()) return {};
  return {high - rest_high, rest_low - low};
}

class Holder {
 public:
  explicit Holder(const FaceChannels& asked) : out_{asked, {}}, asked_(asked) {}

  double value(C c) const { return channel(out_.channels, c); }
  void within(C c, double low, double high) {
    double& x = channel(out_.channels, c);
    x = std::isfinite(x) ? std::clamp(x, std::min(low, high), high) : 0.0;
  }
  HeldFace finish() {
    for (std::size_t i = 0; i < face_channels; ++i)
      if (!(out_.channels[i] == asked_[i])) out_.held.push_back({static_cast<C>(i), asked_[i], out_.channels[i]});
    return std::move(out_);
  }

 private:
  HeldFace out_;
  const FaceChannels& asked_;
};

void hold_brow(const FaceRig& rig, double outward, C right, C up, C turn, Holder& hold) {
  const FaceLimits& l = rig.limits;
  if (outward > 0)
    hold.within(right, -l.eyebrow_in_horizontal, l.eyebrow_out_horizontal);
  else
    hold.within(right, -l.eyebrow_out_horizontal, l.eyebrow_in_horizontal);
  hold.within(turn, -l.eyebrow_rotate_range, l.eyebrow_rotate_range);
  const BrowReach reach = brow_reach(rig, outward * hold.value(turn));
  hold.within(up, std::min(0.0, reach.below - l.eyebrow_down_vertical),
              std::max(0.0, l.eyebrow_up_vertical - reach.above));
}

}  // namespace

HeldFace hold_at_limits(const FaceRig& rig, const FaceChannels& channels) {
  const FaceLimits& l = rig.limits;
  Holder hold(channels);
  hold_brow(rig, 1.0, C::brow_left_right, C::brow_left_up, C::brow_left_turn, hold);
  hold_brow(rig, -1.0, C::brow_right_right, C::brow_right_up, C::brow_right_turn, hold);
  for (const auto& [upper, lower] :
       {std::pair{C::upper_lid_left, C::lower_lid_left}, std::pair{C::upper_lid_right, C::lower_lid_right}}) {
    hold.within(lower, 0.0, l.eyelid_lower_up);
    hold.within(upper, -l.eyelid_upper_wide, 1.0 - hold.value(lower));
  }
  for (const C yaw : {C::eye_left_yaw, C::eye_right_yaw}) hold.within(yaw, -l.eyeball_yaw, l.eyeball_yaw);
  for (const C pitch : {C::eye_left_pitch, C::eye_right_pitch}) hold.within(pitch, -l.eyeball_down, l.eyeball_up);
  hold.within(C::upper_lip_up, 0.0, l.lip_up);
  hold.within(C::lower_lip_up, -l.lip_down, hold.value(C::upper_lip_up));
  hold.within(C::corner_left_right, -l.corner_in, l.corner_out);
  hold.within(C::corner_right_right, -l.corner_out, l.corner_in);
  for (const C up : {C::corner_left_up, C::corner_right_up}) hold.within(up, -l.corner_down, l.corner_up);
  hold.within(C::jaw_drop, 0.0, l.chin_drop);
  for (const C cheek : {C::cheek_left_up, C::cheek_right_up}) hold.within(cheek, 0.0, l.cheek_up);
  hold.within(C::nose_wrinkle, 0.0, l.nose_wrinkle);
  for (const C share : {C::lip_pucker, C::lip_press, C::lip_seal}) hold.within(share, 0.0, 1.0);
  return hold.finish();
}

}  // namespace sinew
