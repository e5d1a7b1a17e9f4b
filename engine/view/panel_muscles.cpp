#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "engine/rig/joint_angle.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

constexpr ImU32 curve_colour = IM_COL32(238, 140, 89, 255), grid = IM_COL32(255, 255, 255, 26),
                mark = IM_COL32(255, 226, 120, 255);

/// Height over the driver's angle, straight at the left, and where it stands now.
void draw_curve(const Muscle& muscle, double strength, double angle) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, 84.0f);
  ImGui::InvisibleButton("curve", size);
  const auto activation = [&](double degrees) {
    return muscle_activation(degrees, muscle.rest_angle, muscle.reference_angle);
  };
  const double highest = std::max({1.0, activation(0.0), activation(180.0), 1e-9}) * 1.1;
  const auto at = [&](double degrees, double height) {
    return ImVec2(corner.x + size.x * static_cast<float>((180.0 - degrees) / 180.0),
                  corner.y + size.y * static_cast<float>(1.0 - std::clamp(height / highest, 0.0, 1.0)));
  };
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg), 3.0f);
  for (const int degrees : {150, 120, 90, 60, 30}) draw.AddLine(at(degrees, 0.0), at(degrees, highest), grid);
  draw.AddLine(at(180.0, 1.0), at(0.0, 1.0), grid);
  std::vector<ImVec2> points;
  for (int degrees = 180; degrees >= 0; degrees -= 2) points.push_back(at(degrees, activation(degrees)));
  draw.AddPolyline(points.data(), static_cast<int>(points.size()), curve_colour, 0, 2.0f);
  draw.AddLine(at(angle, 0.0), at(angle, highest), mark);
  draw.AddCircleFilled(at(angle, activation(angle)), 4.0f, mark);
  const std::string now = fmt::format("{:.0f}\u00b0: {:.4f}", angle, strength * muscle.peak * activation(angle));
  const float width = ImGui::CalcTextSize(now.c_str()).x;
  // The label stands where the curve is low: beside the straight joint, or the bent one for muscles that it stretches.
  const bool left = muscle.reference_angle < muscle.rest_angle;
  draw.AddText({left ? corner.x + 6.0f : corner.x + size.x - width - 6.0f, corner.y + 4.0f}, mark, now.c_str());
  show_tip("height of the swelling over the joint's angle; the thin line is the peak");
  ImGui::TextDisabled("180\u00b0 straight");
  const std::string closed = "closed 0\u00b0";
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(closed.c_str()).x);
  ImGui::TextDisabled("%s", closed.c_str());
}

/// Numbers of one muscle, to be dragged.
class MuscleFields {
 public:
  MuscleFields(const Document& document, ViewState& state, const MuscleNumber& number, const Muscle& muscle)
      : document_(document), state_(state), number_(number), muscle_(muscle) {}

  void draw() {
    length("peak", muscle_.peak, [](MuscleSpec& spec, double v) { spec.peak = v; });
    length("sigma along", muscle_.sigma.x, [&](MuscleSpec& spec, double v) { spec.sigma = Vec2(v, muscle_.sigma.y); });
    length("sigma across", muscle_.sigma.y, [&](MuscleSpec& spec, double v) { spec.sigma = Vec2(muscle_.sigma.x, v); });
    constexpr double gap = 0.02, edge = 1.0;  // the region may reach half a bone beyond either end
    field("from", muscle_.from, 0.005f, -0.5 * edge, muscle_.to - gap, "%.2f",
          [](MuscleSpec& spec, double v) { spec.from = v; });
    field("to", muscle_.to, 0.005f, muscle_.from + gap, 1.5 * edge, "%.2f",
          [](MuscleSpec& spec, double v) { spec.to = v; });
    field("spread", muscle_.spread, 0.5f, 1.0, 180.0, "%.0f\u00b0",
          [](MuscleSpec& spec, double v) { spec.spread = v; });
  }

 private:
  /// Each step is a share of the length itself, whatever the model's unit.
  template <class Set>
  void length(const char* label, double value, Set set) {
    constexpr float share_a_pixel = 0.005f, least = 1e-5f;
    field(label, value, std::max(share_a_pixel * static_cast<float>(std::abs(value)), least), double(least), 1e6,
          "%.4f", set);
  }
  template <class Set>
  void field(const char* label, double value, float speed, double low, double high, const char* format, Set set) {
    float shown = static_cast<float>(value);
    ImGui::SetNextItemWidth(120.0f);
    if (ImGui::DragFloat(label, &shown, speed, static_cast<float>(low), static_cast<float>(high), format,
                         ImGuiSliderFlags_AlwaysClamp)) {
      Scene scene = document_.scene();
      set(scene.characters[number_.character].muscles[number_.muscle], static_cast<double>(shown));
      state_.ask(std::move(scene), muscle_.name + " " + label, muscle_.name + label);
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) state_.edit_ended = true;
  }

  const Document& document_;
  ViewState& state_;
  MuscleNumber number_;
  const Muscle& muscle_;
};

void draw_muscle(const Document& document, ViewState& state, const MuscleNumber& number) {
  const PlacedMuscle& placed = document.stage().characters[number.character].muscles[number.muscle];
  const CharacterState& character = state.states[number.character];
  bool kept = state.kept_muscle == number;
  if (ImGui::Checkbox("show region", &kept)) state.kept_muscle = kept ? std::optional(number) : std::nullopt;
  show_tip("on the skin; it shows by itself while the pointer is on the muscle's name");
  ImGui::SameLine();
  if (ImGui::SmallButton("Remove")) {
    Scene scene = document.scene();
    std::vector<MuscleSpec>& muscles = scene.characters[number.character].muscles;
    muscles.erase(muscles.begin() + static_cast<std::ptrdiff_t>(number.muscle));
    state.ask(std::move(scene), "remove " + placed.muscle.name);
    state.kept_muscle.reset();
  }
  draw_curve(placed.muscle, document.stage().strength, placed.driver.degrees(character.global));
  MuscleFields(document, state, number, placed.muscle).draw();
}

}  // namespace

void draw_muscles(const Document& document, ViewState& state) {
  const Stage& stage = document.stage();
  // Before the first picture, and after characters came or went, there is nothing to tell yet.
  if (state.states.size() != stage.characters.size()) return;
  for (std::size_t c = 0; c < stage.characters.size(); ++c) {
    const std::vector<PlacedMuscle>& muscles = stage.characters[c].muscles;
    if (state.states[c].activations.size() != muscles.size()) continue;
    for (std::size_t m = 0; m < muscles.size(); ++m) {
      const double activation = state.states[c].activations[m];
      ImGui::PushID(static_cast<int>(100 * c + m));
      ImGui::AlignTextToFramePadding();
      const bool open = ImGui::TreeNode(muscles[m].muscle.name.c_str());
      if (ImGui::IsItemHovered()) state.extras.muscle = MuscleNumber{c, m};
      ImGui::SameLine(170.0f);
      ImGui::ProgressBar(static_cast<float>(std::clamp(activation, 0.0, 1.0)), {-1.0f, 0.0f},
                         fmt::format("{:.2f}", activation).c_str());
      if (open) {
        draw_muscle(document, state, {c, m});
        ImGui::TreePop();
      }
      ImGui::PopID();
    }
  }
}

}  // namespace sinew
