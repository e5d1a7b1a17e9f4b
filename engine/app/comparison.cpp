#include "engine/app/comparison.h"

namespace sinew {

std::array<ComparedSide, 2> compared_sides(CompareWith with, const SceneOptions& scene, const OverlayOptions& overlay) {
  std::array<ComparedSide, 2> sides{ComparedSide{scene, overlay, ""}, ComparedSide{scene, overlay, ""}};
  if (with == CompareWith::bulge) {
    if (scene.bulge == BulgeMode::off) sides[0].scene.bulge = BulgeMode::on;
    sides[1].scene.bulge = BulgeMode::off;
    sides[0].label = "with bulge";
    sides[1].label = "without bulge";
  } else if (with == CompareWith::deformer) {
    sides[0].scene.deformer = Deformer::rigid;
    sides[1].scene.deformer = Deformer::ssd;
    for (ComparedSide& side : sides) side.label = deformer_name(side.scene.deformer);
  } else {
    sides[1].overlay = {};
    sides[0].label = overlay_words(overlay);
    sides[1].label = deformer_name(scene.deformer);
  }
  return sides;
}

}  // namespace sinew
