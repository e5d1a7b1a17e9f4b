#include <algorithm>
#include <array>

#include <imgui.h>

#include "engine/model/scene_words.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

/// One of a list of words; true where another was chosen.
template <class Words>
bool choose(const char* label, const Words& words, int& chosen) {
  bool changed = false;
  if (ImGui::BeginCombo(label, std::string(words[static_cast<std::size_t>(chosen)]).c_str())) {
    for (int i = 0; i < static_cast<int>(std::size(words)); ++i)
      if (ImGui::Selectable(std::string(words[static_cast<std::size_t>(i)]).c_str(), i == chosen)) {
        changed = i != chosen;
        chosen = i;
      }
    ImGui::EndCombo();
  }
  return changed;
}

}  // namespace

void draw_look(const Document& document, ViewState& state) {
  Scene scene = document.scene();
  Look& look = scene.look;
  int shading = static_cast<int>(look.shading);
  if (choose("shading", shading_names(), shading)) {
    look.shading = static_cast<Shading>(shading);
    if (look.shading == Shading::weights) look.joint = state.joint;
    if (look.shading != Shading::weights) look.joint.clear();
    if (look.shading == Shading::weights && look.joint.empty()) {
      state.message = "choose a joint first: its weights are shown";
      state.is_error = true;
      return;
    }
    state.ask(scene, "shading");
  }
  if (ImGui::Checkbox("shadows", &look.shadows)) state.ask(scene, "shadows");
  ImGui::SameLine();
  bool floor = look.floor.value_or(look.background.alpha != 0);
  if (ImGui::Checkbox("floor", &floor)) {
    look.floor = floor;
    state.ask(scene, "floor");
  }
  std::array<float, 3> colour{look.background.red / 255.0f, look.background.green / 255.0f,
                              look.background.blue / 255.0f};
  if (ImGui::ColorEdit3("background", colour.data(), ImGuiColorEditFlags_NoInputs)) {
    const auto level = [](float share) { return static_cast<std::uint8_t>(std::lround(255.0f * share)); };
    look.background = {level(colour[0]), level(colour[1]), level(colour[2]), 255};
    state.ask(scene, "background", "background");
  }
  if (ImGui::IsItemDeactivatedAfterEdit()) state.edit_ended = true;
  for (const auto& [name, view] :
       {std::pair{"front", View::front}, {"left", View::left}, {"top", View::top}, {"3/4", View::three_quarter}}) {
    if (ImGui::SmallButton(name)) state.view = view;
    ImGui::SameLine();
  }
  if (ImGui::SmallButton("all")) state.frame_all = true;
  show_tip("F: frames everything");
}

void draw_deformer(const Document& document, ViewState& state) {
  SceneOptions options = document.options();
  static constexpr const char* deformers[] = {"rigid", "ssd"};
  static constexpr BulgeMode modes[] = {BulgeMode::on, BulgeMode::off, BulgeMode::paper};
  const std::array bulges{bulge_name(modes[0]), bulge_name(modes[1]), bulge_name(modes[2])};
  int deformer = options.deformer == Deformer::rigid ? 0 : 1;
  if (choose("deformer", deformers, deformer)) {
    options.deformer = deformer == 0 ? Deformer::rigid : Deformer::ssd;
    state.options = options;
  }
  int bulge = static_cast<int>(std::ranges::find(modes, options.bulge) - modes);
  if (choose("bulge", bulges, bulge)) {
    options.bulge = modes[bulge];
    state.options = options;
  }
  float strength = static_cast<float>(options.strength);
  if (ImGui::SliderFloat("strength", &strength, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp)) {
    options.strength = strength;
    state.options = options;
  }
  show_tip("of all muscles");
}

void draw_muscles(const Document& document, ViewState& state) {
  const Stage& stage = document.stage();
  const int frame = state.playback.shown();
  for (std::size_t c = 0; c < stage.characters.size(); ++c) {
    const StagedCharacter& character = stage.characters[c];
    if (character.muscles.empty()) continue;
    const CharacterState now = character_state(stage, c, frame);
    for (std::size_t m = 0; m < character.muscles.size(); ++m) {
      const Muscle& muscle = character.muscles[m].muscle;
      ImGui::PushID(static_cast<int>(100 * c + m));
      if (ImGui::TreeNode(muscle.name.c_str())) {
        Scene scene = document.scene();
        MuscleSpec& spec = scene.characters[c].muscles[m];
        const auto slider = [&](const char* label, double value, double low, double high, auto set) {
          float shown = static_cast<float>(value);
          ImGui::SetNextItemWidth(150.0f);
          if (ImGui::SliderFloat(label, &shown, static_cast<float>(low), static_cast<float>(high), "%.3f")) {
            set(static_cast<double>(shown));
            state.ask(scene, muscle.name + " " + label, muscle.name + label);
          }
          if (ImGui::IsItemDeactivatedAfterEdit()) state.edit_ended = true;
        };
        const double unit = std::max(std::abs(muscle.peak), 1e-3);
        slider("peak", muscle.peak, 0.0, 3.0 * unit, [&](double v) { spec.peak = v; });
        slider("sigma along", muscle.sigma.x, 0.2 * muscle.sigma.x + 1e-4, 3.0 * muscle.sigma.x,
               [&](double v) { spec.sigma = Vec2(v, muscle.sigma.y); });
        slider("sigma across", muscle.sigma.y, 0.2 * muscle.sigma.y + 1e-4, 3.0 * muscle.sigma.y,
               [&](double v) { spec.sigma = Vec2(muscle.sigma.x, v); });
        ImGui::TreePop();
      }
      ImGui::SameLine(170.0f);
      ImGui::ProgressBar(static_cast<float>(std::clamp(now.activations[m], 0.0, 1.0)), {-1.0f, 0.0f},
                         fmt::format("{:.2f}", now.activations[m]).c_str());
      ImGui::PopID();
    }
  }
}

}  // namespace sinew
