#include "engine/view/muscle_curve.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "engine/rig/joint_angle.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

constexpr ImU32 curve_ink = IM_COL32(238, 140, 89, 255), off_ink = IM_COL32(140, 146, 156, 255),
                grid = IM_COL32(255, 255, 255, 26), now_ink = IM_COL32(255, 226, 120, 255),
                mark_ink = IM_COL32(120, 190, 250, 255), bright = IM_COL32_WHITE;
constexpr float height = 84.0f, mark_reach = 7.0f;
constexpr double straight = 180.0;
constexpr MuscleAngle marks[] = {MuscleAngle::rest, MuscleAngle::reference};

/// The curve as it would be if the muscle were on.
class Curve {
 public:
  Curve(const Muscle& muscle, ImVec2 corner, float width) : muscle_(muscle), corner_(corner), width_(width) {
    highest_ = 1.1 * std::max({1.0, activation(0.0), activation(straight)});
  }

  double activation(double degrees) const {
    return muscle_activation(degrees, muscle_.rest_angle, muscle_.reference_angle);
  }
  ImVec2 at(double degrees, double share) const {
    return {corner_.x + width_ * static_cast<float>((straight - degrees) / straight),
            corner_.y + height * static_cast<float>(1.0 - std::clamp(share / highest_, 0.0, 1.0))};
  }
  ImVec2 top(double degrees) const { return at(degrees, highest_); }
  /// Half a degree is finer than anyone drags, and reads well in a file.
  double degrees(float x) const {
    return std::round(2.0 * std::clamp(straight * (1.0 - double(x - corner_.x) / width_), 0.0, straight)) / 2.0;
  }
  double angle(MuscleAngle mark) const {
    return mark == MuscleAngle::rest ? muscle_.rest_angle : muscle_.reference_angle;
  }
  /// The mark under the pointer.
  std::optional<MuscleAngle> near(float x) const {
    std::optional<MuscleAngle> nearest;
    float least = mark_reach;
    for (const MuscleAngle mark : marks)
      if (const float away = std::abs(at(angle(mark), 0.0).x - x); away <= least) least = away, nearest = mark;
    return nearest;
  }

 private:
  const Muscle& muscle_;
  ImVec2 corner_;
  float width_;
  double highest_ = 1.0;
};

void draw_marks(ImDrawList& draw, const Curve& curve, std::optional<MuscleAngle> chosen) {
  for (const MuscleAngle mark : marks) {
    const ImU32 ink = mark == chosen ? bright : mark_ink;
    const double degrees = curve.angle(mark);
    const ImVec2 foot = curve.at(degrees, 0.0), head = curve.at(degrees, curve.activation(degrees));
    draw.AddLine(foot, mark == MuscleAngle::rest ? curve.top(degrees) : head, (ink & ~IM_COL32_A_MASK) | 0x60000000u);
    draw.AddTriangleFilled({foot.x - 5.0f, foot.y}, {foot.x + 5.0f, foot.y}, {foot.x, foot.y - 8.0f}, ink);
    if (mark == MuscleAngle::reference) draw.AddCircle(head, 4.0f, ink, 0, 1.5f);
  }
}

void draw_axis_words() {
  ImGui::TextDisabled("180\u00b0 straight");
  const char* closed = "closed 0\u00b0";
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(closed).x);
  ImGui::TextDisabled("%s", closed);
}

std::string tip(std::optional<MuscleAngle> near) {
  if (near == MuscleAngle::rest) return "rest angle: nothing swells here; drag it";
  if (near == MuscleAngle::reference) return "reference angle: the whole peak is reached here; drag it";
  return "height of the swelling over the joint's angle; the thin line is the peak";
}

}  // namespace

MuscleCurveUse draw_muscle_curve(const Muscle& muscle, double strength, double degrees) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::InvisibleButton("curve", {width, height});
  const Curve curve(muscle, corner, width);
  const float pointer = ImGui::GetIO().MousePos.x;
  // Which mark is being dragged, from the press on: 0 none.
  int& held = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("held"), 0);
  std::optional<MuscleAngle> near;
  if (ImGui::IsItemHovered()) near = curve.near(pointer);
  if (ImGui::IsItemActivated()) held = near ? 1 + static_cast<int>(*near) : 0;
  MuscleCurveUse use;
  use.ended = ImGui::IsItemDeactivated() && held > 0;
  if (ImGui::IsItemActive() && held > 0) {
    near = marks[held - 1];
    if (ImGui::GetIO().MouseDelta.x != 0.0f) use.drag = {*near, curve.degrees(pointer)};
  }
  show_tip(tip(near));

  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(corner, {corner.x + width, corner.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg), 3.0f);
  for (const int line : {150, 120, 90, 60, 30}) draw.AddLine(curve.at(line, 0.0), curve.top(line), grid);
  draw.AddLine(curve.at(straight, 1.0), curve.at(0.0, 1.0), grid);
  std::vector<ImVec2> points;
  for (int i = 180; i >= 0; i -= 2) points.push_back(curve.at(i, curve.activation(i)));
  draw.AddPolyline(points.data(), static_cast<int>(points.size()), muscle.on ? curve_ink : off_ink, 0, 2.0f);
  draw_marks(draw, curve, near);
  draw.AddLine(curve.at(degrees, 0.0), curve.top(degrees), now_ink);
  draw.AddCircleFilled(curve.at(degrees, muscle_activation(muscle, degrees)), 4.0f, now_ink);
  const std::string now =
      fmt::format("{:.0f}\u00b0: {:.4f}", degrees, strength * muscle.peak * muscle_activation(muscle, degrees));
  // The label stands where the curve is low: beside the straight joint, or the bent one for muscles that it stretches.
  const bool left = muscle.reference_angle < muscle.rest_angle;
  const float label = ImGui::CalcTextSize(now.c_str()).x;
  draw.AddText({left ? corner.x + 6.0f : corner.x + width - label - 6.0f, corner.y + 4.0f}, now_ink, now.c_str());
  draw_axis_words();
  return use;
}

}  // namespace sinew
