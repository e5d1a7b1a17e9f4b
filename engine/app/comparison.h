#pragma once
/// The two sides of a comparison within one scene.

#include <array>

#include "engine/app/figure_look.h"
#include "engine/app/options.h"

namespace sinew {

struct ComparedSide {
  SceneOptions scene;
  OverlayOptions overlay;
  std::string label;
};

/// What stands left and right where a scene shown with these is compared. `with` is not none.
std::array<ComparedSide, 2> compared_sides(CompareWith with, const SceneOptions& scene, const OverlayOptions& overlay);

}  // namespace sinew
