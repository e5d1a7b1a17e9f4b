#include "engine/view/interface_changes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include <imgui.h>

namespace sinew {
namespace {

constexpr int tile_width = 32, tile_height = 16;

std::uint64_t mixed(std::uint64_t sum, std::uint64_t word) {
  sum = (sum ^ word) * 0x9E3779B97F4A7C15u;
  return sum ^ (sum >> 29);
}

std::uint64_t two_words(float a, float b) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(a)} << 32 | std::bit_cast<std::uint32_t>(b);
}

std::uint64_t mixed(std::uint64_t sum, const ImDrawVert& vertex) {
  sum = mixed(sum, two_words(vertex.pos.x, vertex.pos.y));
  return mixed(mixed(sum, two_words(vertex.uv.x, vertex.uv.y)), vertex.col);
}

}  // namespace

PixelBox uncovered(int width, int height, std::span<const DockedPanel> docked) {
  PixelBox free{0, 0, width, height};
  // A panel may reach across only what others have left.
  for (std::size_t pass = 0; pass <= docked.size(); ++pass)
    for (const DockedPanel& panel : docked) {
      const PixelBox& box = panel.place;
      if (box.empty() || free.empty()) continue;
      if (box.top <= free.top && box.bottom >= free.bottom) {
        if (box.left <= free.left) free.left = std::max(free.left, box.right);
        if (box.right >= free.right) free.right = std::min(free.right, box.left);
      }
      if (box.left <= free.left && box.right >= free.right) {
        if (box.top <= free.top) free.top = std::max(free.top, box.bottom);
        if (box.bottom >= free.bottom) free.bottom = std::min(free.bottom, box.top);
      }
    }
  return free.empty() ? PixelBox{} : free;
}

PixelBox InterfaceChanges::take(std::span<const ImDrawList* const> lists, const PixelBox& panel) {
  if (panel.empty()) return {};
  const int columns = (panel.right - panel.left + tile_width - 1) / tile_width;
  const int rows = (panel.bottom - panel.top + tile_height - 1) / tile_height;
  std::vector<std::uint64_t> tiles(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 1);
  for (const ImDrawList* list : lists)
    for (const ImDrawCmd& command : list->CmdBuffer) {
      const ImVec4& clip = command.ClipRect;
      std::uint64_t state = mixed(mixed(0, two_words(clip.x, clip.y)), two_words(clip.z, clip.w));
      state = mixed(state, reinterpret_cast<std::uintptr_t>(command.TextureId));
      for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
        const auto corner = [&](unsigned k) -> const ImDrawVert& {
          return list->VtxBuffer[static_cast<int>(command.VtxOffset +
                                                  list->IdxBuffer[static_cast<int>(command.IdxOffset + i + k)])];
        };
        const ImDrawVert &a = corner(0), &b = corner(1), &c = corner(2);
        const std::uint64_t triangle = mixed(mixed(mixed(state, a), b), c);
        const float left = std::max(std::min({a.pos.x, b.pos.x, c.pos.x}), clip.x);
        const float right = std::min(std::max({a.pos.x, b.pos.x, c.pos.x}), clip.z);
        const float top = std::max(std::min({a.pos.y, b.pos.y, c.pos.y}), clip.y);
        const float bottom = std::min(std::max({a.pos.y, b.pos.y, c.pos.y}), clip.w);
        if (!(left <= right && top <= bottom)) continue;
        const auto tile = [](float at, int origin, int size, int count) {
          return std::clamp(static_cast<int>(std::floor((at - static_cast<float>(origin)) / static_cast<float>(size))),
                            0, count - 1);
        };
        const int first = tile(left, panel.left, tile_width, columns);
        const int last = tile(right, panel.left, tile_width, columns);
        for (int y = tile(top, panel.top, tile_height, rows); y <= tile(bottom, panel.top, tile_height, rows); ++y)
          for (int x = first; x <= last; ++x) {
            std::uint64_t& sum = tiles[static_cast<std::size_t>(y * columns + x)];
            sum = mixed(sum, triangle);
          }
      }
    }
  PixelBox changed{panel.right, panel.bottom, panel.left, panel.top};
  const bool known = panel == panel_ && tiles.size() == tiles_.size();
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const auto i = static_cast<std::size_t>(y * columns + x);
      if (known && tiles[i] == tiles_[i]) continue;
      const int left = panel.left + x * tile_width, top = panel.top + y * tile_height;
      changed = {std::min(changed.left, left), std::min(changed.top, top),
                 std::max(changed.right, std::min(left + tile_width, panel.right)),
                 std::max(changed.bottom, std::min(top + tile_height, panel.bottom))};
    }
  panel_ = panel;
  tiles_ = std::move(tiles);
  return changed.empty() ? PixelBox{} : changed;
}

}  // namespace sinew
