#include "engine/view/fitted_text.h"

#include <imgui.h>

namespace sinew {
namespace {

bool begins_a_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

}  // namespace

std::string fitted_text(const std::string& text, float width, FittedEnd kept) {
  const auto fits = [&](const std::string& part) { return ImGui::CalcTextSize(part.c_str()).x <= width; };
  if (fits(text)) return text;
  static const std::string ellipsis = "...";  // the font's usual range has no sign for it
  std::string part = text;
  while (!part.empty()) {
    if (kept == FittedEnd::first) {
      while (!part.empty() && !begins_a_character(part.back())) part.pop_back();
      if (!part.empty()) part.pop_back();
      if (fits(part + ellipsis)) return part + ellipsis;
    } else {
      part.erase(0, 1);
      while (!part.empty() && !begins_a_character(part.front())) part.erase(0, 1);
      if (fits(ellipsis + part)) return ellipsis + part;
    }
  }
  return ellipsis;
}

void draw_fitted_text(const std::string& text, FittedEnd kept, float width) {
  const std::string shown = fitted_text(text, width > 0.0f ? width : ImGui::GetContentRegionAvail().x, kept);
  ImGui::TextUnformatted(shown.c_str());
  if (shown != text && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
}

}  // namespace sinew
