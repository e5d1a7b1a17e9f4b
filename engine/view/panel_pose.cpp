#include <map>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "engine/core/text.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

constexpr float widest_turn = 180.0f;

void draw_sliders(const Document& document, ViewState& state) {
  if (state.joint.empty()) {
    ImGui::TextDisabled("choose a joint to turn it");
    return;
  }
  const Character& character = document.scene().characters[state.character];
  const auto ask = [&](const std::string& label, const std::string& merge, auto change) {
    Scene scene = document.scene();
    change(scene.characters[state.character]);
    state.ask(std::move(scene), label + state.joint, merge);
  };
  const double frame = state.playback.shown();
  Vec3 degrees = joint_degrees(character, state.joint, frame);
  const auto track = character.keys.find(state.joint);
  const std::size_t keys = track == character.keys.end() ? 0 : track->second.keys.size();
  ImGui::Text("%s", state.joint.c_str());
  for (int axis = 0; axis < 3; ++axis) {
    float value = static_cast<float>(degrees[axis]);
    ImGui::SetNextItemWidth(-30.0f);
    static constexpr const char* labels[] = {"x", "y", "z"};
    if (ImGui::SliderFloat(labels[axis], &value, -widest_turn, widest_turn, "%.1f deg")) {
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

std::vector<ListedJoint> listed_joints(const StagedCharacter& character) {
  const Model& model = *character.model;
  std::vector<bool> is_joint(model.nodes.size(), false);
  for (const PaletteSource& entry : character.mesh.palette)
    if (entry.node >= 0) is_joint[static_cast<std::size_t>(entry.node)] = true;
  // A joint goes on being called what the scene calls it.
  std::map<int, std::string> called;
  for (const auto& [name, track] : character.scene.keys)
    if (const auto node = find_joint(model, character.humanoid, name)) called[*node] = name;
  std::vector<int> depth(model.nodes.size(), 0);
  std::vector<ListedJoint> out;
  for (const int node : character.order) {
    const auto n = static_cast<std::size_t>(node);
    const int parent = model.nodes[n].parent;
    depth[n] =
        parent < 0 ? 0 : depth[static_cast<std::size_t>(parent)] + (is_joint[static_cast<std::size_t>(parent)] ? 1 : 0);
    if (!is_joint[n] || model.nodes[n].name.empty()) continue;
    ListedJoint joint{model.nodes[n].name, model.nodes[n].name, depth[n]};
    for (std::size_t bone = 0; bone < character.humanoid.node.size(); ++bone)
      if (character.humanoid.node[bone] == node) {
        const std::string humanoid(humanoid_name(static_cast<HumanoidBone>(bone)));
        if (humanoid != joint.name) joint.shown += "  (" + humanoid + ")";
      }
    if (const auto name = called.find(node); name != called.end()) joint.name = name->second;
    out.push_back(std::move(joint));
  }
  return out;
}

void draw_pose(const Document& document, ViewState& state) {
  const Stage& stage = document.stage();
  draw_sliders(document, state);
  ImGui::Separator();
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##filter", "find a joint", &state.filter);
  ImGui::BeginChild("joints");
  for (std::size_t c = 0; c < stage.characters.size(); ++c) {
    if (stage.characters.size() > 1) ImGui::TextDisabled("%s", stage.characters[c].scene.model.string().c_str());
    for (const ListedJoint& joint : listed_joints(stage.characters[c])) {
      if (!state.filter.empty() && lower(joint.shown).find(lower(state.filter)) == std::string::npos) continue;
      const bool chosen = c == state.character && joint.name == state.joint;
      const bool moved = stage.characters[c].scene.keys.contains(joint.name);
      const std::string label = std::string(static_cast<std::size_t>(joint.depth), ' ') + joint.shown +
                                (moved ? " *" : "") + "##" + std::to_string(c) + joint.name;
      if (ImGui::Selectable(label.c_str(), chosen)) {
        state.character = c;
        state.joint = chosen ? "" : joint.name;
      }
    }
  }
  ImGui::EndChild();
}

}  // namespace sinew
