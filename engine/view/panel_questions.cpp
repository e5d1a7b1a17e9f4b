#include <imgui.h>

#include "engine/view/fitted_text.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

constexpr float name_width = 420.0f, button_width = 120.0f;

/// A question in the middle of the window that must be answered first; true where its content is to be drawn, and then
/// ImGui::EndPopup() called.
bool begin_question(const char* name, bool asked) {
  if (asked && !ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  return ImGui::BeginPopupModal(name, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
}

/// A button that a key presses as well.
bool answer(const char* label, std::optional<ImGuiKey> key = {}) {
  const bool clicked = ImGui::Button(label, {button_width, 0.0f});
  return clicked || (key && ImGui::IsKeyPressed(ImGui::GetKeyIndex(*key), false));
}

}  // namespace

void draw_replacing(ViewState& state) {
  if (!begin_question("Replace the file?", state.replacing)) return;
  draw_fitted_text(state.save_as, FittedEnd::last, name_width);
  ImGui::TextDisabled("exists, and was neither opened nor saved here.");
  ImGui::Spacing();
  const bool yes = answer("Replace", ImGuiKey_Enter);
  ImGui::SameLine();
  const bool no = answer("Cancel", ImGuiKey_Escape);
  if (yes || no) {
    state.replacing = false;
    state.replace = yes;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void draw_leaving(ViewState& state) {
  if (!begin_question("Save the edits?", state.leaving && !state.replacing && !state.save)) return;
  draw_fitted_text(state.save_as, FittedEnd::last, name_width);
  ImGui::TextDisabled("%s", state.leaving && !state.leaving->file.empty() ? "is edited. Another file would drop that."
                                                                          : "is edited. Closing would drop that.");
  if (const ClipEditor* clip = state.motion.browser.editor(); clip != nullptr && clip->is_edited())
    ImGui::TextDisabled("Edits of clip %s are not saved: Motions does that, under a new name.", clip->name().c_str());
  ImGui::Spacing();
  if (state.leaving) state.leaving->shown = true;
  using Answer = ViewState::LeaveAnswer;
  Answer given = state.leaving ? Answer::none : Answer::stay;
  if (answer("Save", ImGuiKey_Enter)) given = Answer::save;
  ImGui::SameLine();
  if (answer("Don't save")) given = Answer::drop;
  ImGui::SameLine();
  if (answer("Cancel", ImGuiKey_Escape)) given = Answer::stay;
  if (given != Answer::none) {
    state.leave_answer = given;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace sinew
