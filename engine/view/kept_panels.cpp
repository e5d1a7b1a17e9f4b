#include "engine/view/kept_panels.h"

#include <algorithm>
#include <string_view>

#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

namespace sinew {
namespace {

using Lists = std::vector<ImDrawList*>;

/// The panel that a list belongs to, its children's included; its number, or that of none.
std::size_t owner(const ImDrawList& list, std::span<const DockedPanel> docked) {
  const std::string_view name = list._OwnerName ? list._OwnerName : "";
  for (std::size_t i = 0; i < docked.size(); ++i)
    if (name.substr(0, name.find('/')) == docked[i].name) return i;
  return docked.size();
}

/// Narrows what the lists draw to a box.
void clip(const Lists& lists, const PixelBox& box) {
  for (ImDrawList* list : lists)
    for (ImDrawCmd& command : list->CmdBuffer) {
      ImVec4& rect = command.ClipRect;
      rect.x = std::max(rect.x, static_cast<float>(box.left));
      rect.y = std::max(rect.y, static_cast<float>(box.top));
      rect.z = std::min(rect.z, static_cast<float>(box.right));
      rect.w = std::min(rect.w, static_cast<float>(box.bottom));
    }
}

/// Draws some of a frame's lists.
WindowContent::Draw draw_of(const ImDrawData& data, Lists lists) {
  if (lists.empty()) return {};
  return [part = data, lists = std::move(lists)](const vk::raii::CommandBuffer& commands) mutable {
    part.CmdLists = lists.data();
    part.CmdListsCount = static_cast<int>(lists.size());
    part.TotalIdxCount = part.TotalVtxCount = 0;
    for (const ImDrawList* list : lists) {
      part.TotalIdxCount += list->IdxBuffer.Size;
      part.TotalVtxCount += list->VtxBuffer.Size;
    }
    if (part.TotalVtxCount > 0) ImGui_ImplVulkan_RenderDrawData(&part, *commands);
  };
}

PixelBox within(const PixelBox& box, int width, int height) {
  return {std::max(box.left, 0), std::max(box.top, 0), std::min(box.right, width), std::min(box.bottom, height)};
}

}  // namespace

void KeptPanels::take(const ImDrawData& data, std::span<const DockedPanel> docked, int width, int height,
                      int generation, WindowContent& content) {
  if (generation != generation_) changes_.clear();
  generation_ = generation;
  Lists under, over;
  std::vector<Lists> of_panel(docked.size());
  bool panel_seen = false;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    ImDrawList* list = data.CmdLists[i];
    const std::size_t panel = owner(*list, docked);
    panel_seen = panel_seen || panel < docked.size();
    (panel < docked.size() ? of_panel[panel] : panel_seen ? over : under).push_back(list);
  }
  if (!panel_seen) std::swap(under, over);
  for (std::size_t i = 0; i < docked.size(); ++i) {
    const PixelBox place = within(docked[i].place, width, height);
    if (place.empty() || of_panel[i].empty()) continue;
    WindowContent::Panel panel;
    panel.place = vk::Rect2D({place.left, place.top}, {static_cast<std::uint32_t>(place.right - place.left),
                                                       static_cast<std::uint32_t>(place.bottom - place.top)});
    const PixelBox changed =
        changes_[docked[i].name].take(std::vector<const ImDrawList*>(of_panel[i].begin(), of_panel[i].end()), place);
    if (!changed.empty()) {
      clip(of_panel[i], changed);
      panel.redraw = draw_of(data, of_panel[i]);
    }
    content.panels.push_back(std::move(panel));
  }
  // A panel that goes and comes back finds other pixels in its place.
  std::erase_if(changes_, [&](const auto& known) {
    return std::ranges::find(docked, known.first, &DockedPanel::name) == docked.end();
  });
  content.under = draw_of(data, std::move(under));
  content.over = draw_of(data, std::move(over));
}

}  // namespace sinew
