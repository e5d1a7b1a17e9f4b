#pragma once
/// A tube whose morph target moves every vertex and turns every normal its own way.

#include "tests/support/test_character.h"
#include "tests/support/tube.h"

namespace sinew::test {

/// `weight`: of its only target, "swell", in the rest pose.
inline Model swelling_tube(double weight, const TubeShape& shape = {}) {
  Model model = tube(shape);
  Primitive& skin = model.meshes[0].primitives[0];
  Random random(8);
  skin.morph_targets = {{"swell", {}, {}}};
  for (std::size_t v = 0; v < skin.positions.size(); ++v) {
    skin.morph_targets[0].positions.push_back(random.vector(0.05));
    skin.morph_targets[0].normals.push_back(random.vector(0.2));
  }
  model.meshes[0].morph_weights = {weight};
  return model;
}

}  // namespace sinew::test
