#include <filesystem>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "engine/view/fitted_text.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

constexpr float open_width = 420.0f;

void draw_open(ViewState& state) {
  if (ImGui::Button("Open")) {
    if (state.open_field.empty()) state.open_field = (state.folder / "").string();
    ImGui::OpenPopup("open a file");
  }
  show_tip("a model, motion or scene; or drop a file onto the window");
  if (!ImGui::BeginPopup("open a file")) return;
  if (is_escaped()) ImGui::CloseCurrentPopup();
  const auto ask = [&](const std::string& file) {
    state.open = file;
    ImGui::CloseCurrentPopup();
  };
  ImGui::SetNextItemWidth(open_width);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputText("##path", &state.open_field, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  if (ImGui::Button("Open##it") || entered) ask(state.open_field);
  if (!state.recent.empty()) ImGui::TextDisabled("recent");
  for (const std::string& file : state.recent) {
    const std::string shown = fitted_text(file, open_width, FittedEnd::last);
    if (ImGui::Selectable((shown + "##" + file).c_str())) ask(file);
    if (shown != file) show_tip(file);
  }
  ImGui::EndPopup();
}

void draw_history(const Document& document, ViewState& state) {
  ImGui::SameLine();
  const ClipEditor* clip = state.edited_clip();
  ImGui::BeginDisabled(clip == nullptr && !document.can_undo());
  if (ImGui::Button("Undo")) state.undo = true;
  ImGui::EndDisabled();
  show_tip(clip != nullptr       ? "Ctrl+Z: edit of " + clip->name()
           : document.can_undo() ? "Ctrl+Z: " + document.undo_label()
                                 : "nothing to undo");
  ImGui::SameLine();
  ImGui::BeginDisabled(!document.can_redo());
  if (ImGui::Button("Redo")) state.redo = true;
  ImGui::EndDisabled();
  show_tip(document.can_redo() ? "Ctrl+Y: " + document.redo_label() : "nothing to redo");
  ImGui::SameLine();
  if (ImGui::Button("Command")) state.copy_command = true;
  show_tip("copies the sinew render command that makes this picture");
}

/// What stands at the end of a row is so wide.
constexpr float buttons_width = 116.0f;

/// A file's name, with room for buttons after it.
void draw_name(const char* id, std::string& name) {
  ImGui::SetNextItemWidth(-buttons_width);
  ImGui::InputText(id, &name);
  ImGui::SameLine();
}

void draw_saving(ViewState& state) {
  draw_name("##save_as", state.save_as);
  const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  if (ImGui::Button("Save", {half, 0.0f})) state.save = true;
  show_tip("Ctrl+S: writes the scene file");
  ImGui::SameLine();
  if (ImGui::Button("Photo", {half, 0.0f})) state.screenshot = true;
  show_tip("P: the picture without the panels, as PNG beside the scene");
}

void draw_recording(ViewState& state) {
  ImGui::BeginDisabled(state.records);
  draw_name("##film", state.film);
  if (ImGui::Button("Record", {-1.0f, 0.0f})) state.record = true;
  ImGui::EndDisabled();
  show_tip("Ctrl+R: all frames, as sinew render does: .mp4, .webm, .gif, or pictures x_####.png");
}

void draw_disk_change(ViewState& state) {
  if (!state.changed_on_disk) return;
  ImGui::TextColored({1.0f, 0.80f, 0.45f, 1.0f}, "The file on the disk has changed.");
  if (ImGui::Button("Read it, drop my edits")) state.reload = true;
  ImGui::SameLine();
  if (ImGui::Button("Keep mine")) state.changed_on_disk = false;
}

}  // namespace

void draw_file(const Document& document, ViewState& state) {
  const Stage& stage = document.stage();
  const std::string vertices = fmt::format("{} vertices", stage.vertices());
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(vertices.c_str()).x - spacing;
  const std::string name = std::filesystem::path(state.file).filename().string() + (document.is_changed() ? " *" : "");
  ImGui::TextUnformatted(fitted_text(name, room, FittedEnd::last).c_str());
  show_tip(state.file);
  ImGui::SameLine();
  ImGui::TextDisabled("%s", vertices.c_str());
  show_tip(fmt::format("{} triangles", stage.triangles()));
  draw_open(state);
  draw_history(document, state);
  draw_saving(state);
  draw_recording(state);
  draw_disk_change(state);
}

}  // namespace sinew
