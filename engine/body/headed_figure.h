#pragma once
/// A figure with a face: the head that drawing rules make, on the neck of the figure that measures make
/// (engine/definitions.md 15).

#include "engine/body/figure.h"
#include "engine/face/head.h"

namespace sinew {

struct HeadedFigure {
  Model model;                 ///< one mesh: the figure's skin first, then the head's primitives as head_model has them
  Head head;                   ///< as it came to stand: its neck is the figure's, what lay below is gone; drawing units
  Vec3 origin{0.0};            ///< where the head's origin stands at rest, metres
  std::uint32_t first_vertex;  ///< of the head's, counted over all primitives

  /// Its regions, for all of the model's vertices, primitives one after another.
  CharacterFace face() const;
};

/// The figure wears this head, as tall as its own was; `with_shapes`: with the morph targets that `head_shapes` makes.
/// Skin below the cut keeps the figure's numbers to the bit; no step and no gap shows at the neck. Fails as
/// build_figure and HeadMaker::head do.
Result<HeadedFigure> build_headed_figure(const BodyOptions& options, const HeadMeasures& measures,
                                         int level = default_head_level, bool with_shapes = false);

}  // namespace sinew
