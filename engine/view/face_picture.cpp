#include "engine/view/face_picture.h"

#include <cmath>
#include <numbers>

namespace sinew {
namespace {

using C = FaceChannel;

constexpr Vec2 right{1.0, 0.0}, up{0.0, 1.0};
/// Lids, as shares of the ball's radius: half an opening's width, how far each lid stands from the middle.
constexpr double lid_width = 0.86, lid_height = 0.38;
/// An adult's, in drawing units (engine/face/head_measures.json).
constexpr double nose_base = 1.0, lip_contact = 0.66, mouth_half_width = 0.4, upper_lip = 0.115, lower_lip = 0.14;

double known(double height, double otherwise) { return std::isfinite(height) ? height : otherwise; }

class Painter {
 public:
  Painter(const ShownFace& face, const FaceGuides& guides) : face_(face), guides_(guides) {}

  FacePicture paint() {
    for (const bool left : {true, false}) {
      brow(left);
      eye(left);
      cheek(left);
    }
    nose();
    mouth();
    outline();
    return std::move(out_);
  }

 private:
  double value(C c) const { return channel(face_.shown, c); }

  void brow(bool left) {
    const FaceRig& rig = face_.sizes;
    const C across = left ? C::brow_left_right : C::brow_right_right, rise = left ? C::brow_left_up : C::brow_right_up,
            turn = left ? C::brow_left_turn : C::brow_right_turn;
    // Lines on the left brow, mirrored for the right one; the end that the turn lifts is the free one.
    const double side = left ? 1.0 : -1.0, outward = side * value(turn);
    const double slope = std::tan(outward * degrees_to_radians);
    const double pivot = outward > 0.0 ? rig.brow_inner : rig.brow_outer;
    const auto moved = [&](const Vec2& p) {
      return Vec2(side * p.x + value(across), p.y + slope * (p.x - pivot) + value(rise));
    };
    // The outline's points come in pairs, one at each edge.
    FacePicture::Brow& edges = out_.brows.emplace_back();
    Vec2 middle(0.0);
    for (std::size_t i = 0; i < rig.brow_outline.size(); ++i) {
      const Vec2& p = rig.brow_outline[i];
      (i % 2 == 0 ? edges.one : edges.other).push_back(moved(p));
      middle += p / static_cast<double>(rig.brow_outline.size());
    }
    if (edges.one.empty()) middle = {0.5 * (rig.brow_inner + rig.brow_outer), rig.eye_centres[0].y + 0.3};
    out_.handles.push_back({left ? "left brow" : "right brow", moved(middle), {{across, right, 1.0}, {rise, up, 1.0}}});
    // The brow turns about one end or the other; the handle, about the middle.
    const double lever = std::max(rig.brow_outer + 0.07 - middle.x, 0.05);
    out_.handles.push_back({left ? "left brow's turn" : "right brow's turn",
                            {side * (middle.x + lever) + value(across), middle.y + value(rise) + slope * lever},
                            {{turn, up, side / lever / degrees_to_radians}}});
  }

  void eye(bool left) {
    const FaceRig& rig = face_.sizes;
    const double r = rig.eye_radius;
    const Vec2 centre(rig.eye_centres[left ? 0 : 1]);
    const C upper = left ? C::upper_lid_left : C::upper_lid_right,
            lower = left ? C::lower_lid_left : C::lower_lid_right, yaw = left ? C::eye_left_yaw : C::eye_right_yaw,
            pitch = left ? C::eye_left_pitch : C::eye_right_pitch;
    const double top = lid_height * r * (1.0 - 2.0 * value(upper)),
                 bottom = lid_height * r * (2.0 * value(lower) - 1.0);
    FacePicture::Eye& eye = out_.eyes.emplace_back();
    constexpr int pieces = 12;
    for (int i = 0; i <= pieces; ++i) {
      const double x = 2.0 * i / pieces - 1.0, bow = 1.0 - x * x;
      eye.upper.push_back(centre + Vec2(lid_width * r * x, top * bow));
      eye.lower.push_back(centre + Vec2(lid_width * r * x, bottom * bow));
    }
    eye.iris =
        centre + r * Vec2(std::sin(value(yaw) * degrees_to_radians), std::sin(value(pitch) * degrees_to_radians));
    eye.iris_radius = 0.36 * r;
    const double degrees_a_unit = 1.0 / (r * degrees_to_radians), close_a_unit = 0.5 / (lid_height * r);
    // The lids' handles keep off the iris' and off each other.
    const Vec2 off(0.0, 0.075);
    out_.handles.push_back(
        {left ? "left gaze" : "right gaze", eye.iris, {{yaw, right, degrees_a_unit}, {pitch, up, degrees_a_unit}}});
    out_.handles.push_back(
        {left ? "left upper lid" : "right upper lid", centre + Vec2(0.0, top) + off, {{upper, up, -close_a_unit}}});
    out_.handles.push_back(
        {left ? "left lower lid" : "right lower lid", centre + Vec2(0.0, bottom) - off, {{lower, up, close_a_unit}}});
  }

  void cheek(bool left) {
    const C rise = left ? C::cheek_left_up : C::cheek_right_up;
    const Vec2 at((left ? 0.68 : -0.68) * face_.sizes.mouth_scale, nose_height() + 0.08 + value(rise));
    out_.handles.push_back({left ? "left cheek" : "right cheek", at, {{rise, up, 1.0}}});
  }

  double nose_height() const { return known(guides_.nose_base, nose_base); }
  double contact() const { return known(guides_.lip_contact, lip_contact); }

  void nose() {
    const double wrinkle = value(C::nose_wrinkle), base = nose_height() + 0.4 * wrinkle;
    const double width = 0.21 * face_.sizes.mouth_scale;
    out_.nose = {{-0.05, base + 0.42},         {-0.06, base + 0.25}, {-width, base + 0.1},        {-width, base + 0.02},
                 {-0.45 * width, base - 0.01}, {0.0, base - 0.05},   {0.45 * width, base - 0.01}, {width, base + 0.02},
                 {width, base + 0.1},          {0.06, base + 0.25},  {0.05, base + 0.42}};
    out_.handles.push_back({"nose", {0.0, nose_height() + 0.16 + wrinkle}, {{C::nose_wrinkle, up, 1.0}}});
  }

  void mouth() {
    const double y = contact(), scale = face_.sizes.mouth_scale, narrow = 1.0 - 0.35 * value(C::lip_pucker);
    const double thin = 1.0 - 0.55 * value(C::lip_press), open = value(C::jaw_drop) * (1.0 - value(C::lip_seal));
    const double wide = mouth_half_width * scale * narrow;
    const auto corner = [&](bool left) {
      const C across = left ? C::corner_left_right : C::corner_right_right,
              rise = left ? C::corner_left_up : C::corner_right_up;
      return Vec2((left ? wide : -wide) + value(across), y - 0.3 * open + value(rise));
    };
    const Vec2 viewers_left = corner(false), viewers_right = corner(true);
    const double inner_top = y + value(C::upper_lip_up), inner_bottom = y + value(C::lower_lip_up) - 0.85 * open;
    const double outer_top = inner_top + upper_lip * scale * thin,
                 outer_bottom = inner_bottom - lower_lip * scale * thin;
    const auto lips = [&](double top, double bottom, double inset) {
      std::vector<Vec2> line;
      constexpr int pieces = 16;
      const Vec2 a = viewers_left + Vec2(inset, 0.0), b = viewers_right - Vec2(inset, 0.0);
      for (const bool over : {true, false})
        for (int i = 0; i < pieces; ++i) {
          const double t = over ? double(i) / pieces : 1.0 - double(i) / pieces, bow = 4.0 * t * (1.0 - t);
          const Vec2 chord = glm::mix(a, b, t), middle = glm::mix(a, b, 0.5);
          line.emplace_back(chord.x, chord.y + bow * ((over ? top : bottom) - middle.y));
        }
      return line;
    };
    out_.lip_outer = lips(outer_top, outer_bottom, 0.0);
    out_.lip_inner = lips(inner_top, inner_bottom, 0.05 * scale);
    for (const bool left : {true, false})
      out_.handles.push_back({left ? "left corner of the mouth" : "right corner of the mouth",
                              corner(left),
                              {{left ? C::corner_left_right : C::corner_right_right, right, 1.0},
                               {left ? C::corner_left_up : C::corner_right_up, up, 1.0}}});
    out_.handles.push_back({"upper lip", {0.0, outer_top + 0.02}, {{C::upper_lip_up, up, 1.0}}});
    out_.handles.push_back({"lower lip", {0.0, outer_bottom - 0.02}, {{C::lower_lip_up, up, 1.0}}});
  }

  void outline() {
    const double drop = value(C::jaw_drop), wide = face_.sizes.mouth_scale;
    constexpr int pieces = 32;
    const double high = face_.sizes.eye_centres[0].y + 0.45, deep = -drop;
    for (int i = 0; i <= pieces; ++i) {
      // Half an ellipse that is squarer at the jaw.
      const double a = std::numbers::pi * (1.0 + double(i) / pieces), c = std::cos(a), s = std::sin(a);
      out_.outline.emplace_back(1.02 * std::copysign(std::pow(std::abs(c), 0.82), c) * std::max(wide, 0.9),
                                high + (high - deep) * s);
    }
    out_.handles.push_back({"jaw", {0.0, deep + 0.06}, {{C::jaw_drop, up, -1.0}}});
  }

  const ShownFace& face_;
  const FaceGuides& guides_;
  FacePicture out_;
};

}  // namespace

std::vector<ChannelGoal> FaceHandle::pulled(const ShownFace& face, const Vec2& by) const {
  std::vector<ChannelGoal> goals;
  for (const Lead& lead : leads)
    goals.push_back({lead.channel, channel(face.shown, lead.channel) + lead.gain * glm::dot(by, lead.way)});
  return goals;
}

std::vector<Vec2> FaceHandle::reach(const ShownFace& face) const {
  std::vector<Vec2> corners{at};
  for (const Lead& lead : leads) {
    const ChannelRange range = channel_range(face, lead.channel);
    const double now = channel(face.shown, lead.channel);
    std::vector<Vec2> further;
    for (const double end : {range.low, range.high})
      for (const Vec2& corner : corners) further.push_back(corner + (end - now) / lead.gain * lead.way);
    corners = std::move(further);
  }
  if (corners.size() == 4) std::swap(corners[2], corners[3]);  // round the area
  return corners;
}

FacePicture face_picture(const ShownFace& face, const FaceGuides& guides) { return Painter(face, guides).paint(); }

}  // namespace sinew
