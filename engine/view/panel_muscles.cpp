#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "engine/model/scene_words.h"
#include "engine/view/fitted_text.h"
#include "engine/view/muscle_curve.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

MuscleSpec& spec_of(Scene& scene, const MuscleNumber& number) {
  return scene.characters[number.character].muscles[number.muscle];
}

/// Numbers of one muscle, to be dragged.
class MuscleFields {
 public:
  MuscleFields(const Document& document, ViewState& state, const MuscleNumber& number, const Muscle& muscle)
      : document_(document), state_(state), number_(number), muscle_(muscle) {}

  void draw() {
    length("peak", muscle_.peak, [](MuscleSpec& spec, double v) { spec.peak = v; });
    angle("rest angle", muscle_.rest_angle, MuscleAngle::rest);
    angle("reference angle", muscle_.reference_angle, MuscleAngle::reference);
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
  void turn(const MuscleAngleDrag& drag) {
    ask("angle", [&](MuscleSpec& spec) { set_muscle_angle(spec, muscle_, drag.which, drag.degrees); });
  }

 private:
  template <class Change>
  void ask(const char* label, Change change) {
    Scene scene = document_.scene();
    change(spec_of(scene, number_));
    state_.ask(std::move(scene), muscle_.name + " " + label, muscle_.name + label);
  }
  void angle(const char* label, double value, MuscleAngle which) {
    field(label, value, 0.5f, 0.0, 180.0, "%.1f\u00b0",
          [&](MuscleSpec& spec, double v) { set_muscle_angle(spec, muscle_, which, v); });
  }
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
                         ImGuiSliderFlags_AlwaysClamp))
      ask(label, [&](MuscleSpec& spec) { set(spec, static_cast<double>(shown)); });
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
  MuscleFields fields(document, state, number, placed.muscle);
  const MuscleCurveUse use =
      draw_muscle_curve(placed.muscle, document.stage().strength, placed.driver.degrees(character.global));
  if (use.drag) fields.turn(*use.drag);
  if (use.ended) state.edit_ended = true;
  fields.draw();
}

/// A muscle's row: its name, what it does now, whether it does anything.
void draw_row(const Document& document, ViewState& state, const MuscleNumber& number) {
  const PlacedMuscle& placed = document.stage().characters[number.character].muscles[number.muscle];
  const double activation = state.states[number.character].activations[number.muscle];
  constexpr float bar_at = 184.0f;
  const float box = ImGui::GetFrameHeight();
  ImGui::AlignTextToFramePadding();
  bool on = placed.muscle.on;
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(on ? ImGuiCol_Text : ImGuiCol_TextDisabled));
  const bool open = ImGui::TreeNode("row", "%s", placed.muscle.name.c_str());
  ImGui::PopStyleColor();
  if (ImGui::IsItemHovered()) state.extras.muscle = number;
  ImGui::SameLine(bar_at);
  ImGui::ProgressBar(static_cast<float>(std::clamp(activation, 0.0, 1.0)),
                     {ImGui::GetContentRegionAvail().x - box - ImGui::GetStyle().ItemSpacing.x, 0.0f},
                     on ? fmt::format("{:.2f}", activation).c_str() : "off");
  ImGui::SameLine();
  if (ImGui::Checkbox("##on", &on)) {
    Scene scene = document.scene();
    spec_of(scene, number).on = on;
    state.ask(std::move(scene), (on ? "switch on " : "switch off ") + placed.muscle.name);
  }
  show_tip("it swells; off: it stays in the scene, but does nothing");
  if (!open) return;
  draw_muscle(document, state, number);
  ImGui::TreePop();
}

void draw_presets(const Document& document, ViewState& state, std::size_t c) {
  if (!ImGui::BeginPopup("add a muscle")) return;
  if (is_escaped()) ImGui::CloseCurrentPopup();
  const Character& character = document.scene().characters[c];
  const auto& names = muscle_preset_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(names[i].c_str());
    for (const MuscleSide side : {MuscleSide::left, MuscleSide::right}) {
      ImGui::SameLine(side == MuscleSide::left ? 140.0f : 196.0f);
      const auto preset = static_cast<MusclePreset>(i);
      ImGui::BeginDisabled(has_muscle(character, preset, side));
      if (ImGui::Button(side == MuscleSide::left ? "left" : "right", {48.0f, 0.0f})) {
        Scene scene = document.scene();
        const auto added = add_muscle(scene.characters[c], document.stage().characters[c], preset, side);
        const std::string label = added ? "add " + muscle_name(scene.characters[c].muscles.back()) : "";
        added ? state.ask(std::move(scene), label) : state.tell(added.error());
        ImGui::CloseCurrentPopup();
      }
      ImGui::EndDisabled();
    }
    ImGui::PopID();
  }
  ImGui::EndPopup();
}

/// Buttons that give the chosen character muscles.
void draw_adding(const Document& document, ViewState& state) {
  const std::size_t c = state.character;
  if (c >= document.stage().characters.size()) return;
  const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  if (ImGui::Button("Add ...", {half, 0.0f})) ImGui::OpenPopup("add a muscle");
  show_tip("a muscle with all its numbers measured on the model");
  draw_presets(document, state, c);
  ImGui::SameLine();
  if (ImGui::Button("All that fit", {half, 0.0f})) {
    Scene scene = document.scene();
    const auto added = add_fitting_muscles(scene.characters[c], document.stage().characters[c]);
    if (!added) return state.tell(added.error());
    if (*added > 0) return state.ask(std::move(scene), fmt::format("add {} muscles", *added));
    state.message = "every muscle that fits is there already";
    state.is_error = false;
  }
  show_tip("what `sinew muscles --all` places; those that are there stay as they are");
}

}  // namespace

void draw_muscles(const Document& document, ViewState& state) {
  const Stage& stage = document.stage();
  // Before the first picture, and after characters came or went, there is nothing to tell yet.
  if (state.states.size() != stage.characters.size()) return;
  for (std::size_t c = 0; c < stage.characters.size(); ++c) {
    const std::vector<PlacedMuscle>& muscles = stage.characters[c].muscles;
    if (state.states[c].activations.size() != muscles.size()) continue;
    if (stage.characters.size() > 1) draw_fitted_text(stage.characters[c].scene.model.string(), FittedEnd::last);
    for (std::size_t m = 0; m < muscles.size(); ++m) {
      ImGui::PushID(static_cast<int>(100 * c + m));
      draw_row(document, state, {c, m});
      ImGui::PopID();
    }
  }
  draw_adding(document, state);
}

}  // namespace sinew
