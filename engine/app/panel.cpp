#include "engine/app/panel.h"

#include <set>

namespace sinew {
namespace {

/// Of the panel's height and width.
constexpr double inset_share = 0.36;

Vec3 joint_position(const Stage& stage, const ZoomTarget& zoom, int frame) {
  const CharacterState state = character_state(stage, zoom.character, frame);
  return Vec3(character_placement(stage, zoom.character, frame) * state.global[zoom.node][3]);
}

/// World transforms of all nodes at a frame.
std::vector<Mat4> world_transforms(const Stage& stage, std::size_t character, int frame, const CharacterState& state) {
  const Mat4 placement = character_placement(stage, character, frame);
  std::vector<Mat4> world;
  for (const Mat4& global : state.global) world.push_back(placement * global);
  return world;
}

SkeletonOverlay skeleton_overlay(const StagedCharacter& character, std::vector<Mat4> world) {
  SkeletonOverlay overlay;
  overlay.global = std::move(world);
  std::set<int> joints;
  for (const Skin& skin : character.model->skins) joints.insert(skin.joints.begin(), skin.joints.end());
  for (std::size_t i = 0; i < character.model->nodes.size(); ++i) {
    overlay.parents.push_back(character.model->nodes[i].parent);
    overlay.joints.push_back(joints.contains(static_cast<int>(i)));
    overlay.names.push_back(character.model->nodes[i].name);
  }
  return overlay;
}

}  // namespace

Result<ZoomTarget> find_zoom(const Stage& stage, const std::string& joint) {
  std::optional<Error> unknown;
  for (std::size_t i = 0; i < stage.characters.size(); ++i) {
    const StagedCharacter& character = stage.characters[i];
    const auto node = find_joint(*character.model, character.humanoid, joint);
    if (!node) {
      unknown = node.error();
      continue;
    }
    const Vec3 here(character.rest.global[*node][3]);
    double segment = 0.0;
    const Node& found = character.model->nodes[*node];
    if (found.parent >= 0) segment = glm::length(here - Vec3(character.rest.global[found.parent][3]));
    for (const int child : found.children)
      segment = std::max(segment, glm::length(here - Vec3(character.rest.global[child][3])));
    if (segment <= 0.0) segment = 0.1 * rest_bounds(stage).diagonal();
    return ZoomTarget{i, *node, 0.75 * segment};
  }
  return bad_input("--zoom {}: {}", joint, unknown ? unknown->message : "the scene has no character");
}

Result<PanelMaker> PanelMaker::create(Device& device, const Stage& stage, const SceneOptions& scene,
                                      const LookOptions& look, const FigureOptions& figure,
                                      std::vector<std::string>& problems) {
  LookOptions whole_look = look;
  whole_look.wire = figure.overlay.wire;
  auto main = FrameMaker::create(device, stage, scene, whole_look, problems);
  if (!main) return pass_on(std::move(main));
  PanelMaker panel(stage, std::move(*main), scene, figure);
  if (figure.zoom.empty()) return panel;
  auto zoom = find_zoom(stage, figure.zoom);
  if (!zoom) return pass_on(std::move(zoom));
  panel.zoom_ = *zoom;
  LookOptions near_look = whole_look;
  const int side = static_cast<int>(inset_share * std::min(look.size.width, look.size.height));
  near_look.size = {std::max(side, 1), std::max(side, 1)};
  std::vector<std::string> repeated;
  auto near = FrameMaker::create(device, stage, scene, near_look, repeated);
  if (!near) return pass_on(std::move(near));
  panel.near_ = std::move(*near);
  return panel;
}

OverlayContent PanelMaker::content(int frame) const {
  OverlayContent content;
  content.axes = figure_.overlay.axes;
  Bounds box;
  for (std::size_t i = 0; i < stage_->characters.size(); ++i) {
    const StagedCharacter& character = stage_->characters[i];
    const CharacterState state = character_state(*stage_, i, frame);
    const std::vector<Mat4> world = world_transforms(*stage_, i, frame, state);
    if (figure_.overlay.skeleton) content.skeletons.push_back(skeleton_overlay(character, world));
    if (!figure_.overlay.muscles && !figure_.overlay.box) continue;
    const DeformedVertices deformed = deform_on_cpu(character, state, scene_.deformer, scene_.bulge);
    for (const Vec3& p : deformed.positions) box.add(p);
    if (!figure_.overlay.muscles) continue;
    for (std::size_t m = 0; m < character.muscles.size(); ++m) {
      const PlacedMuscle& placed = character.muscles[m];
      const Mat4 rest_to_world = world[placed.muscle.bone] * glm::inverse(character.rest.global[placed.muscle.bone]);
      content.muscles.push_back(posed_muscle(placed.muscle, placed.region, rest_to_world, deformed.positions,
                                             deformed.normals, state.activations[m]));
    }
  }
  if (figure_.overlay.box && !box.empty()) content.box = box;
  return content;
}

Result<Picture> PanelMaker::inset(int frame, double orbit, const Font* font) {
  Shot shot = near_->shot(frame, orbit);
  const Vec3 target = joint_position(*stage_, zoom_, frame);
  const double distance = zoom_.reach / std::tan(0.5 * vertical_field_of_view_degrees * degrees_to_radians);
  const Vec3 moved = target + distance * shot.viewpoint.back - shot.viewpoint.eye;
  shot.viewpoint.eye += moved;
  // Whatever stands between the camera and the joint, or behind it, is seen as in the whole picture.
  shot.viewpoint.near_plane = 0.02 * distance;
  shot.viewpoint.far_plane += glm::length(moved) + distance;
  auto picture = near_->picture(frame, shot);
  if (picture && figure_.overlay.painted())
    if (auto ok = draw_overlay(*picture, font, shot.viewpoint, content(frame)); !ok) return pass_on(std::move(ok));
  return picture;
}

Result<Picture> PanelMaker::picture(int frame, double orbit, const Font* font) {
  const Shot shot = main_.shot(frame, orbit);
  auto picture = main_.picture(frame, shot);
  if (!picture) return picture;
  if (figure_.overlay.painted())
    if (auto ok = draw_overlay(*picture, font, shot.viewpoint, content(frame)); !ok) return pass_on(std::move(ok));
  if (!near_) return picture;
  auto near = inset(frame, orbit, font);
  if (!near) return near;
  if (auto ok = add_inset(*picture, *near, {.label = figure_.zoom}, font); !ok) return pass_on(std::move(ok));
  return picture;
}

}  // namespace sinew
