#pragma once
/// Tubes of known shape for the meters.

#include <functional>

#include "engine/body/limb_surface.h"
#include "tests/support/test_character.h"
#include "tests/support/tube.h"

namespace sinew::test {

/// The tube of tests/support/tube.h, as a surface to measure; `shaped` moves every vertex first.
class MeasuredTube {
 public:
  explicit MeasuredTube(const TubeShape& shape, const std::function<Vec3(const Vec3&)>& shaped = {})
      : MeasuredTube(tube(shape), shaped) {}
  explicit MeasuredTube(Model model, const std::function<Vec3(const Vec3&)>& shaped = {})
      : character(std::move(model)),
        triangles(welded_triangles(character.mesh, character.rest)),
        positions(character.rest.positions) {
    if (shaped)
      for (Vec3& p : positions) p = shaped(p);
  }

  PosedSurface surface() const {
    return {character.model, character.mesh, triangles, positions, character.rest.global};
  }

  TestCharacter character;
  std::vector<std::uint32_t> triangles;
  std::vector<Vec3> positions;
};

/// A second skin, moved and scaled across y, on one node of its own beside the first.
inline Model with_second_tube(Model model, const TubeShape& shape, const Vec3& moved, int on_node) {
  Primitive other = tube_surface(shape);
  for (std::size_t v = 0; v < other.positions.size(); ++v) other.positions[v] += moved;
  Influences weights;
  for (std::size_t v = 0; v < other.positions.size(); ++v)
    weights.add_vertex({{static_cast<std::uint32_t>(on_node), 1.0}});
  other.influences = weights;
  model.meshes[0].primitives.push_back(other);
  return model;
}

}  // namespace sinew::test
