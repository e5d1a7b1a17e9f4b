#include <imgui.h>

#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

constexpr float words_width = 260.0f, bar_width = 150.0f;
/// What is done within that time is not worth a flash on the screen.
constexpr double shown_after = 0.2;

}  // namespace

void draw_works(std::span<WorkBeside* const> works, const ViewState& state) {
  std::vector<WorkBeside*> shown;
  for (WorkBeside* work : works)
    if (work->running() && work->seconds() > shown_after) shown.push_back(work);
  if (shown.empty()) return;
  const ImVec2 whole = ImGui::GetIO().DisplaySize;
  const PixelBox free = uncovered(static_cast<int>(whole.x), static_cast<int>(whole.y), state.docked);
  ImGui::SetNextWindowPos({0.5f * static_cast<float>(free.left + free.right), static_cast<float>(free.bottom) - 10.0f},
                          ImGuiCond_Always, {0.5f, 1.0f});
  if (ImGui::Begin("works", nullptr,
                   ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab));
    for (std::size_t i = 0; i < shown.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      const float left = ImGui::GetCursorPosX();
      ImGui::AlignTextToFramePadding();
      show_fitted(shown[i]->what(), words_width);
      ImGui::SameLine(left + words_width + ImGui::GetStyle().ItemSpacing.x);
      const double share = shown[i]->share();
      ImGui::ProgressBar(static_cast<float>(share), {bar_width, 0.0f}, share > 0.0 ? nullptr : "");
      ImGui::SameLine();
      ImGui::BeginDisabled(shown[i]->is_cancelled());
      if (ImGui::Button("Stop")) shown[i]->cancel();
      ImGui::EndDisabled();
      ImGui::PopID();
    }
    ImGui::PopStyleColor();
  }
  ImGui::End();
}

}  // namespace sinew
