#pragma once
/// Which part of a panel looks otherwise than when it was last drawn: the interface is laid out anew for every frame,
/// but few of its pixels change. No Vulkan here.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

struct ImDrawList;

namespace sinew {

/// Whole pixels, or units of the interface, from the upper left corner: low ones included, high ones not.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
  bool empty() const { return right <= left || bottom <= top; }
  bool operator==(const PixelBox&) const = default;
};

/// An opaque panel that none but floating ones cover: its pixels are kept from frame to frame.
struct DockedPanel {
  std::string name;  ///< ImGui's name of its window
  PixelBox place;
};

/// What panels leave free of a window: those along its edges cut it short, others lie over it.
PixelBox uncovered(int width, int height, std::span<const DockedPanel> docked);

/// Remembers a panel in tiles.
class InterfaceChanges {
 public:
  /// The box round all tiles in which any triangle came, went or changed since the last call; the whole panel where it
  /// was never drawn or stands elsewhere. `lists`: in the order in which they are drawn.
  PixelBox take(std::span<const ImDrawList* const> lists, const PixelBox& panel);
  /// As if it was never drawn.
  void forget() { tiles_.clear(); }

 private:
  PixelBox panel_;
  std::vector<std::uint64_t> tiles_;  ///< one number of all that each shows, row by row
};

}  // namespace sinew
