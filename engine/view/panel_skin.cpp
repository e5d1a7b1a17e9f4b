#include <imgui.h>
#include <imgui_stdlib.h>

#include "engine/model/scene_words.h"
#include "engine/view/fitted_text.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

constexpr float label_width = 84.0f;

/// A label, then room for a field up to the end of the row.
void label(const char* words) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words);
  ImGui::SameLine(label_width);
  ImGui::SetNextItemWidth(-1.0f);
}

std::string told(const Model& model) {
  std::size_t joints = 0;
  for (const Skin& skin : model.skins) joints += skin.joints.size();
  if (model.skins.empty()) return "no skin weights: it stands still";
  return fmt::format("{} joints move it", joints);
}

}  // namespace

void follow_model(SkinPanel& panel, const std::string& model, bool has_skin) {
  const std::string mesh = is_built_in_model(model) ? "" : model;
  if (mesh == panel.mesh) return;
  panel.mesh = mesh;
  panel.opens = !mesh.empty() && !has_skin;
  panel.skeleton = has_skin ? mesh : "";
  const std::filesystem::path file = mesh;
  panel.output = mesh.empty() ? "" : (file.parent_path() / (file.stem().string() + "_bound.glb")).string();
}

bool stands_still(const StagedCharacter& character) {
  return !is_built_in_model(character.scene.model.string()) && character.model->skins.empty() &&
         character.model->clips.empty();
}

void draw_skin(const Document& document, ViewState& state) {
  SkinPanel& panel = state.skin;
  const auto& characters = document.stage().characters;
  if (state.character >= characters.size()) return;
  const StagedCharacter& character = characters[state.character];
  follow_model(panel, character.scene.model.string(), !character.model->skins.empty());
  if (std::exchange(panel.opens, false)) ImGui::SetNextItemOpen(true);
  if (!ImGui::CollapsingHeader("Skin")) return;
  if (panel.mesh.empty()) {
    ImGui::TextDisabled("built-in characters bring their weights");
    return;
  }
  draw_fitted_text(character.scene.model.filename().string() + ": " + told(*character.model), FittedEnd::first,
                   ImGui::GetContentRegionAvail().x);
  label("skeleton");
  ImGui::InputTextWithHint("##skeleton", "a .glb with joints", &panel.skeleton);
  show_tip("the file whose joints stand in the mesh: " + panel.skeleton);
  label("voxels");
  ImGui::DragInt("##voxels", &panel.resolution, 1.0f, 16, 384, "%d", ImGuiSliderFlags_AlwaysClamp);
  show_tip("along the longest side: finer ones part limbs that are close, and take longer");
  label("influences");
  ImGui::DragInt("##influences", &panel.influences, 0.05f, 1, 8, "%d", ImGuiSliderFlags_AlwaysClamp);
  show_tip("at most so many joints a vertex");
  label("writes");
  ImGui::InputText("##bound", &panel.output);
  show_tip(panel.output);
  ImGui::BeginDisabled(panel.binds || panel.skeleton.empty() || panel.output.empty());
  if (ImGui::Button(panel.binds ? "binding ..." : "Bind", {-1.0f, 0.0f})) panel.bind = true;
  ImGui::EndDisabled();
  show_tip(panel.skeleton.empty() ? "name the file with the skeleton first"
                                  : "makes skin weights, as sinew bind does, and shows the new file");
}

}  // namespace sinew
