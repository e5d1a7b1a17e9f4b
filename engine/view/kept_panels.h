#pragma once
/// The interface of one frame, parted into docked panels, whose pixels are kept and drawn again only where they have
/// changed, and all the rest, which is drawn every time. Vulkan types inside: engine/view's own.

#include <map>

#include "engine/view/interface_changes.h"
#include "engine/view/swapchain.h"

struct ImDrawData;

namespace sinew {

class KeptPanels {
 public:
  /// Fills in all of `content` but its picture. `docked`: in `width` x `height` pixels; what the returned calls draw
  /// lives until the next ImGui::NewFrame(). `generation`: Swapchain::generation().
  void take(const ImDrawData& data, std::span<const DockedPanel> docked, int width, int height, int generation,
            WindowContent& content);

 private:
  std::map<std::string, InterfaceChanges> changes_;  ///< by the panel's name
  int generation_ = -1;
};

}  // namespace sinew
