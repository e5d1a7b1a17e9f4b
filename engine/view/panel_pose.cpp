#include <imgui.h>
#include <imgui_stdlib.h>

#include "engine/core/text.h"
#include "engine/rig/joint_limits.h"
#include "engine/view/fitted_text.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

void draw_sliders(const Document& document, ViewState& state) {
  if (state.joint.empty()) {
    ImGui::TextDisabled("choose a joint to turn it");
    return;
  }
  const Character& character = document.scene().characters[state.character];
  // Keys may have come under another of its names, or gone, since it was chosen.
  state.joint = called_joint(document.stage().characters[state.character], state.joint);
  const auto ask = [&](const std::string& label, const std::string& merge, auto change) {
    Scene scene = document.scene();
    change(scene.characters[state.character]);
    state.ask(std::move(scene), label + state.joint, merge);
  };
  const double frame = state.playback.shown();
  Vec3 degrees = joint_degrees(character, state.joint, frame);
  const auto track = character.keys.find(state.joint);
  const std::size_t keys = track == character.keys.end() ? 0 : track->second.keys.size();
  draw_fitted_text(state.joint, FittedEnd::last);
  const StagedCharacter& staged = document.stage().characters[state.character];
  const auto node = find_joint(*staged.model, staged.humanoid, state.joint);
  const auto limits = node ? joint_limits(*staged.model, staged.humanoid, staged.rest.global, *node) : std::nullopt;
  for (int axis = 0; axis < 3; ++axis) {
    float value = static_cast<float>(degrees[axis]);
    ImGui::SetNextItemWidth(-30.0f);
    static constexpr const char* labels[] = {"x", "y", "z"};
    const DegreeRange range = limits ? number_range(*limits, degrees, axis) : DegreeRange{};
    if (ImGui::SliderFloat(labels[axis], &value, static_cast<float>(range.low), static_cast<float>(range.high),
                           "%.1f deg", limits ? ImGuiSliderFlags_AlwaysClamp : ImGuiSliderFlags_None)) {
      degrees[axis] = value;
      ask("turn ", "turn " + state.joint,
          [&](Character& changed) { set_joint_degrees(changed, state.joint, frame, degrees); });
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) state.edit_ended = true;
  }
  if (ImGui::Button("Key here"))
    ask("key for ", "", [&](Character& changed) { add_joint_key(changed, state.joint, frame); });
  show_tip("K: keeps these angles at this frame; turn the joint at another frame to move it");
  ImGui::SameLine();
  ImGui::BeginDisabled(keys == 0);
  if (ImGui::Button("Remove key"))
    ask("remove a key of ", "", [&](Character& changed) { remove_joint_key(changed, state.joint, frame); });
  ImGui::SameLine();
  if (ImGui::Button("Reset")) ask("reset ", "", [&](Character& changed) { changed.keys.erase(state.joint); });
  ImGui::EndDisabled();
  ImGui::TextDisabled("%zu %s", keys, keys == 1 ? "value for all frames" : "keys");
}

}  // namespace

void draw_pose(const Document& document, ViewState& state) {
  const Stage& stage = document.stage();
  ImGui::Checkbox("rings", &state.gizmo);
  show_tip("about the chosen joint: drag to turn it, Shift for steps of five degrees");
  ImGui::SameLine();
  ImGui::Checkbox("reach", &state.reach);
  show_tip("handles at wrists and ankles: drag them and the limb follows");
  draw_sliders(document, state);
  ImGui::Separator();
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##filter", "find a joint", &state.filter);
  ImGui::BeginChild("joints");
  for (std::size_t c = 0; c < stage.characters.size(); ++c) {
    if (stage.characters.size() > 1) draw_fitted_text(stage.characters[c].scene.model.string(), FittedEnd::last);
    for (const ListedJoint& joint : listed_joints(stage.characters[c])) {
      if (!state.filter.empty() && lower(joint.shown).find(lower(state.filter)) == std::string::npos) continue;
      const bool chosen = c == state.character && joint.name == state.joint;
      const bool moved = stage.characters[c].scene.keys.contains(joint.name);
      const std::string text =
          std::string(static_cast<std::size_t>(joint.depth), ' ') + joint.shown + (moved ? " *" : "");
      const std::string shown = fitted_text(text, ImGui::GetContentRegionAvail().x);
      const std::string label = shown + "##" + std::to_string(c) + joint.name;
      if (chosen && std::exchange(state.show_joint, false)) ImGui::SetScrollHereY();
      if (ImGui::Selectable(label.c_str(), chosen)) {
        state.character = c;
        state.joint = chosen ? "" : joint.name;
      }
      if (shown != text) show_tip(joint.shown);
    }
  }
  ImGui::EndChild();
}

}  // namespace sinew
