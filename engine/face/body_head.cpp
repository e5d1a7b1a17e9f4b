#include "engine/face/body_head.h"

#include <algorithm>

namespace sinew {
namespace {

constexpr std::size_t slices = 300;

/// How wide the skin is from left to right, from the top down.
std::vector<double> widths(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles,
                           const Bounds& box) {
  std::vector<double> low(slices, INFINITY), high(slices, -INFINITY);
  const double step = (box.high.y - box.low.y) / slices;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
    for (std::size_t c = 0; c < 3; ++c) {
      Vec3 a = positions[triangles[i + c]], b = positions[triangles[i + (c + 1) % 3]];
      if (a.y < b.y) std::swap(a, b);
      const double first = std::ceil((box.high.y - a.y) / step - 0.5);
      for (auto k = static_cast<std::size_t>(std::max(0.0, first)); k < slices; ++k) {
        const double y = box.high.y - (static_cast<double>(k) + 0.5) * step;
        if (y < b.y || a.y == b.y) break;
        const double x = glm::mix(a.x, b.x, (a.y - y) / (a.y - b.y));
        low[k] = std::min(low[k], x);
        high[k] = std::max(high[k], x);
      }
    }
  std::vector<double> out;
  for (std::size_t k = 0; k < slices; ++k) out.push_back(std::max(0.0, high[k] - low[k]));
  return out;
}

}  // namespace

std::vector<bool> above_neck(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles) {
  // A grown body is eight heads high, a toddler four; shoulders are twice as wide as the head, a neck two thirds.
  constexpr std::size_t highest = slices / 20, lowest = slices * 2 / 5, shoulders = slices / 10;
  constexpr double narrower = 0.85, wider = 1.4, spread = 1.2;
  std::vector<bool> out(positions.size(), true);
  Bounds box;
  for (const std::uint32_t v : triangles) box.add(positions[v]);
  if (box.empty() || !(box.high.y > box.low.y)) return out;
  const std::vector<double> width = widths(positions, triangles, box);
  std::size_t neck = 0;
  for (std::size_t n = highest; n < lowest; ++n) {
    const auto at = [&](std::size_t k) { return width.begin() + static_cast<std::ptrdiff_t>(k); };
    const double head = *std::max_element(at(0), at(n)), below = *std::max_element(at(n), at(n + shoulders));
    if (width[n] < narrower * head && below > wider * head && (neck == 0 || width[n] < width[neck])) neck = n;
  }
  if (neck == 0) return out;
  // A chin that juts out hangs lower than where the neck is narrowest.
  for (const double narrowest = width[neck]; width[neck + 1] < spread * narrowest;) ++neck;
  const double y = box.high.y - (static_cast<double>(neck) + 0.5) * (box.high.y - box.low.y) / slices;
  for (std::size_t v = 0; v < positions.size(); ++v) out[v] = positions[v].y > y;
  return out;
}

}  // namespace sinew
