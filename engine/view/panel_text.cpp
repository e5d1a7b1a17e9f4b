#include <imgui.h>

#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

bool begins_letter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

}  // namespace

std::string fitted_text(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  std::size_t least = 0, most = text.size();
  const auto cut = [&](std::size_t length) {
    while (length > 0 && length < text.size() && !begins_letter(text[length])) --length;
    return text.substr(0, length) + "...";
  };
  while (least + 1 < most) {
    const std::size_t middle = (least + most) / 2;
    (ImGui::CalcTextSize(cut(middle).c_str()).x <= width ? least : most) = middle;
  }
  return cut(least);
}

void show_fitted(const std::string& text, float width) {
  const std::string shown = fitted_text(text, width);
  ImGui::TextUnformatted(shown.c_str());
  if (shown != text) show_tip(text);
}

}  // namespace sinew
