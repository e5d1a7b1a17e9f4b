#pragma once
/// What a model or a scene holds: `sinew info`.

#include "engine/app/stage.h"

namespace sinew {

/// The numbers that `info` reports, summed over the characters of a scene.
struct Description {
  std::size_t vertices = 0, triangles = 0;
  std::size_t joints = 0;          ///< distinct nodes that a skin names
  std::size_t max_influences = 0;  ///< the most non-zero weights of any vertex
  std::size_t morph_targets = 0;   ///< by mesh, however many nodes draw it
  Bounds bounds;                   ///< of the rest pose, world space at the first frame
};

Description describe(const Stage& stage);

}  // namespace sinew
