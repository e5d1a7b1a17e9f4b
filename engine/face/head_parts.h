#pragma once
/// What stands in and on the skin of a head: eyeballs, brows, teeth, tongue. Vertices and triangles are the same for
/// all measures.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/face/head_cage.h"

namespace sinew {

/// What a triangle of a head is covered with, skin first.
enum class HeadMaterial : std::uint8_t {
  skin,
  lip,
  mouth,
  nostril,
  lash,
  sclera,
  limbus,
  iris,
  pupil,
  brow,
  teeth,
  gum,
  tongue
};
constexpr std::size_t head_materials = 13;

struct HeadTriangle {
  std::array<std::uint32_t, 3> corners;  ///< counter-clockwise seen from outside
  HeadMaterial material;
};

struct HeadSurface {
  std::vector<Vec3> positions;
  std::vector<HeadTriangle> triangles;

  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, HeadMaterial material);
  /// The same on the other side of the mid line.
  HeadSurface mirrored() const;
};

/// The left eye, looking forward: rings cut exactly where pupil and iris end, so that their edges are round.
HeadSurface build_eyeball(const HeadPlan& plan);

/// The left brow as a tapering roll on the skin.
struct Brow {
  HeadSurface surface;
  std::vector<std::array<std::uint32_t, 6>> anchors;  ///< [vertices] the skin's vertices that carry each
  std::vector<std::array<double, 6>> anchor_weights;  ///< sums of 1
  std::vector<Vec2> outline;                          ///< points round it, from the front
};
/// `skin`: vertices of the whole head's skin.
Brow build_brow(const HeadPlan& plan, std::span<const Vec3> skin);

/// Upper or lower row of teeth with its gum: one band, barely notched. "Do not overdraw them."
HeadSurface build_teeth(const HeadPlan& plan, bool upper);
HeadSurface build_tongue(const HeadPlan& plan);

}  // namespace sinew
