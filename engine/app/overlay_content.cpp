#include "engine/app/overlay_content.h"

#include <algorithm>
#include <set>

namespace sinew {
namespace {

/// World transforms of all nodes at a frame.
std::vector<Mat4> world_transforms(const Stage& stage, std::size_t character, int frame, const CharacterState& state) {
  const Mat4 placement = character_placement(stage, character, frame);
  std::vector<Mat4> world;
  for (const Mat4& global : state.global) world.push_back(placement * global);
  return world;
}

SkeletonOverlay skeleton_overlay(const StagedCharacter& character, std::vector<Mat4> world, bool named) {
  SkeletonOverlay overlay;
  overlay.global = std::move(world);
  std::set<int> joints;
  for (const Skin& skin : character.model->skins) joints.insert(skin.joints.begin(), skin.joints.end());
  for (std::size_t i = 0; i < character.model->nodes.size(); ++i) {
    overlay.parents.push_back(character.model->nodes[i].parent);
    overlay.joints.push_back(joints.contains(static_cast<int>(i)));
    if (named) overlay.names.push_back(character.model->nodes[i].name);
  }
  return overlay;
}

}  // namespace

OverlayContent overlay_content(const Stage& stage, const SceneOptions& scene, const OverlayOptions& overlay, int frame,
                               std::span<const MuscleNumber> also) {
  OverlayContent content;
  content.axes = overlay.axes;
  Bounds box;
  for (std::size_t i = 0; i < stage.characters.size(); ++i) {
    const StagedCharacter& character = stage.characters[i];
    const CharacterState state = character_state(stage, i, frame);
    const std::vector<Mat4> world = world_transforms(stage, i, frame, state);
    if (overlay.skeleton || overlay.bones)
      content.skeletons.push_back(skeleton_overlay(character, world, overlay.skeleton));
    const bool of_face = overlay.of_faces() && character.mesh.face;
    if (!overlay.of_muscles() && !overlay.box && !of_face && also.empty()) continue;
    const DeformedVertices deformed = deform_on_cpu(character, state, scene.deformer, scene.bulge);
    for (const Vec3& p : deformed.positions) box.add(p);
    if (of_face)
      content.faces.push_back(
          posed_face(character.mesh, deformed.positions, deformed.blend, overlay.guides, overlay.regions));
    for (std::size_t m = 0; m < character.muscles.size(); ++m) {
      const bool is_also = std::ranges::find(also, MuscleNumber{i, m}) != also.end();
      if (!overlay.of_muscles() && !is_also) continue;
      const PlacedMuscle& placed = character.muscles[m];
      const Mat4 rest_to_world = world[placed.muscle.bone] * glm::inverse(character.rest.global[placed.muscle.bone]);
      content.muscles.push_back(posed_muscle(placed.muscle, placed.region, rest_to_world, deformed.positions,
                                             deformed.normals, state.activations[m]));
      MuscleOverlay& shown = content.muscles.back();
      shown.gaussian = overlay.muscles || is_also;
      shown.arrows = overlay.arrows;
      shown.projection = overlay.projection;
    }
  }
  if (overlay.box && !box.empty()) content.box = box;
  return content;
}

}  // namespace sinew
