#pragma once
/// What is drawn over a picture of a stage: skeletons, muscles and faces as they stand at a frame.

#include "engine/app/figure_look.h"
#include "engine/app/stage.h"
#include "engine/render/overlay.h"

namespace sinew {

/// A muscle of a stage.
struct MuscleNumber {
  std::size_t character = 0, muscle = 0;
  bool operator==(const MuscleNumber&) const = default;
};

/// What the overlays ask for, and the muscles that are `also` to be seen. Wires are not among it: they are drawn with
/// the surface.
OverlayContent overlay_content(const Stage& stage, const SceneOptions& scene, const OverlayOptions& overlay, int frame,
                               std::span<const MuscleNumber> also = {});

}  // namespace sinew
