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

/// Puts an overlay into the list or takes it out of it.
void set_overlay(Look& look, Overlay overlay, bool shown) {
  std::erase(look.overlay, overlay);
  if (shown) look.overlay.push_back(overlay);
  // All edges are the seen ones and more.
  if (shown && overlay == Overlay::wire) std::erase(look.overlay, Overlay::wire_all);
  if (shown && overlay == Overlay::wire_all) std::erase(look.overlay, Overlay::wire);
  // A comparison with the picture without overlays needs some.
  if (look.overlay.empty() && look.compare == CompareWith::overlay) look.compare = CompareWith::none;
}

template <class Ask>
void draw_overlays(bool with_face, Look& look, const Ask& ask) {
  static constexpr Overlay shown[] = {Overlay::skeleton, Overlay::bones,  Overlay::muscles,    Overlay::wire,
                                      Overlay::wire_all, Overlay::arrows, Overlay::projection, Overlay::box,
                                      Overlay::axes,     Overlay::guides, Overlay::regions};
  if (ImGui::BeginTable("overlays", 3, ImGuiTableFlags_SizingStretchProp)) {
    for (const Overlay overlay : shown) {
      const std::string name = overlay_names()[static_cast<std::size_t>(overlay)];
      bool on = std::ranges::find(look.overlay, overlay) != look.overlay.end();
      ImGui::TableNextColumn();
      const bool of_face = overlay == Overlay::guides || overlay == Overlay::regions;
      ImGui::BeginDisabled(of_face && !with_face && !on);
      const bool changed = ImGui::Checkbox(name.c_str(), &on);
      ImGui::EndDisabled();
      if (!changed) continue;
      set_overlay(look, overlay, on);
      ask(("overlay " + name).c_str());
    }
    ImGui::EndTable();
  }
  int compare = static_cast<int>(look.compare);
  if (choose("compare", comparison_names(), compare)) {
    look.compare = static_cast<CompareWith>(compare);
    if (look.compare != CompareWith::overlay || !look.overlay.empty()) ask("compare");
  }
  show_tip("drag the line in the picture; overlay: with and without what is drawn over it");
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
  draw_overlays(has_face_regions(document), look, ask);
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

}  // namespace sinew
