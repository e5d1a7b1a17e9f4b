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
  Look look = document.scene().look;
  const auto ask = [&](const char* label, const char* merge = "") {
    Scene scene = document.scene();
    scene.look = look;
    state.ask(std::move(scene), label, merge);
  };
  int shading = static_cast<int>(look.shading);
  if (choose("shading", shading_names(), shading)) {
    look.shading = static_cast<Shading>(shading);
    look.joint = look.shading == Shading::weights ? state.joint : "";
    if (look.shading == Shading::weights && look.joint.empty()) {
      state.message = "choose a joint first: its weights are shown";
      state.is_error = true;
    } else {
      ask("shading");
    }
  }
  if (ImGui::Checkbox("shadows", &look.shadows)) ask("shadows");
  ImGui::SameLine();
  bool floor = look.floor.value_or(look.background.alpha != 0);
  if (ImGui::Checkbox("floor", &floor)) {
    look.floor = floor;
    ask("floor");
  }
  std::array<float, 3> colour{look.background.red / 255.0f, look.background.green / 255.0f,
                              look.background.blue / 255.0f};
  if (ImGui::ColorEdit3("background", colour.data(), ImGuiColorEditFlags_NoInputs)) {
    const auto level = [](float share) { return static_cast<std::uint8_t>(std::lround(255.0f * share)); };
    look.background = {level(colour[0]), level(colour[1]), level(colour[2]), 255};
    ask("background", "background");
  }
  if (ImGui::IsItemDeactivatedAfterEdit()) state.edit_ended = true;
  for (const auto& [name, view] :
       {std::pair{"front", View::front}, {"left", View::left}, {"top", View::top}, {"3/4", View::three_quarter}}) {
    if (ImGui::SmallButton(name)) state.view = view;
    ImGui::SameLine();
  }
  if (ImGui::SmallButton("all")) state.frame_all = true;
  show_tip("F: frames everything");
  ImGui::SameLine();
  const bool parallel = document.scene().camera.projection == Projection::orthographic;
  if (ImGui::SmallButton(parallel ? "parallel" : "persp")) state.toggle_projection = true;
  show_tip("5: perspective or parallel rays");
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

namespace {

/// Lengths of one muscle, to be dragged. Each step is a share of the length itself, whatever the model's unit.
void draw_muscle(const Document& document, std::size_t character, std::size_t number, const Muscle& muscle,
                 ViewState& state) {
  const auto length = [&](const char* label, double value, auto set) {
    constexpr float share_a_pixel = 0.005f, least = 1e-5f;
    float shown = static_cast<float>(value);
    ImGui::SetNextItemWidth(150.0f);
    const float speed = std::max(share_a_pixel * std::abs(shown), least);
    if (ImGui::DragFloat(label, &shown, speed, least, 1e6f, "%.4f", ImGuiSliderFlags_AlwaysClamp)) {
      Scene scene = document.scene();
      set(scene.characters[character].muscles[number], static_cast<double>(shown));
      state.ask(std::move(scene), muscle.name + " " + label, muscle.name + label);
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) state.edit_ended = true;
  };
  length("peak", muscle.peak, [](MuscleSpec& spec, double v) { spec.peak = v; });
  length("sigma along", muscle.sigma.x, [&](MuscleSpec& spec, double v) { spec.sigma = Vec2(v, muscle.sigma.y); });
  length("sigma across", muscle.sigma.y, [&](MuscleSpec& spec, double v) { spec.sigma = Vec2(muscle.sigma.x, v); });
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
      const bool open = ImGui::TreeNode(muscles[m].muscle.name.c_str());
      ImGui::SameLine(170.0f);
      ImGui::ProgressBar(static_cast<float>(std::clamp(activation, 0.0, 1.0)), {-1.0f, 0.0f},
                         fmt::format("{:.2f}", activation).c_str());
      if (open) {
        draw_muscle(document, c, m, muscles[m].muscle, state);
        ImGui::TreePop();
      }
      ImGui::PopID();
    }
  }
}

}  // namespace sinew
