#pragma once
/// Sliders of a face. ImGui's calls inside.

#include <imgui.h>

#include "engine/view/panels.h"

namespace sinew {

/// Sliders in columns: `draw(i)` makes the slider of each.
template <class Draw>
void in_columns(const char* id, std::size_t count, Draw draw, int columns = 2) {
  if (!ImGui::BeginTable(id, columns, ImGuiTableFlags_SizingStretchSame)) return;
  for (std::size_t i = 0; i < count; ++i) {
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::PushID(static_cast<int>(i));
    draw(i);
    ImGui::PopID();
  }
  ImGui::EndTable();
}

/// A slider with its name inside; true while it is moved.
bool named_slider(const std::string& name, double& value, double low, double high, ViewState& state);

/// One a scene's expression. `abilities`: of a face by morph targets; null: it can show all.
void draw_expressions(const Document& document, ViewState& state, std::size_t character, const ShownFace& face,
                      const TargetAbilities* abilities);

/// All of a face by morph targets: expressions, and the regions that its targets can move.
void draw_target_face(const Document& document, ViewState& state, std::size_t character, const ShownFace& face);

}  // namespace sinew
