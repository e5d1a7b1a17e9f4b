#include "engine/app/panel.h"

#include <algorithm>

#include "engine/app/overlay_content.h"

namespace sinew {
namespace {

/// Of the panel's height and width: of an inset alone, and of one of two.
constexpr double inset_share = 0.36, paired_inset_share = 0.44;

/// The box of the skin that follows a joint, in the rest pose.
Bounds skin_of(const StagedCharacter& character, int node) {
  Bounds box;
  for (std::size_t v = 0; v < character.rest.positions.size(); ++v)
    if (character.mesh.bone(v) == node) box.add(character.rest.positions[v]);
  return box;
}

}  // namespace

PictureSize inset_size(const PictureSize& whole) {
  return {std::max(static_cast<int>(inset_share * whole.width), 1),
          std::max(static_cast<int>(inset_share * whole.height), 1)};
}

Vec3 zoom_position(const Stage& stage, const ZoomTarget& zoom, int frame) {
  const CharacterState state = character_state(stage, zoom.character, frame);
  return Vec3(character_placement(stage, zoom.character, frame) * state.global[zoom.node] * zoom.place);
}

Result<ZoomTarget> find_zoom(const Stage& stage, const std::string& name, std::optional<std::size_t> only) {
  std::optional<Error> unknown;
  for (std::size_t i = 0; i < stage.characters.size(); ++i) {
    if (only && i != *only) continue;
    const StagedCharacter& character = stage.characters[i];
    for (const PlacedMuscle& placed : character.muscles) {
      if (placed.muscle.name != name) continue;
      const Vec4 place = glm::inverse(character.rest.global[placed.muscle.bone]) * Vec4(placed.region.centre, 1.0);
      return ZoomTarget{i, placed.muscle.bone, place, 0.5 * placed.region.plane.length};
    }
    const auto node = find_joint(*character.model, character.humanoid, name);
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
    // A head or a chest is larger than the way to the joints beside it.
    const Bounds skin = skin_of(character, *node);
    if (0.6 * skin.diagonal() > 0.75 * segment)
      return ZoomTarget{i, *node, glm::inverse(character.rest.global[*node]) * Vec4(skin.centre(), 1.0),
                        0.6 * skin.diagonal()};
    return ZoomTarget{i, *node, Vec4(0.0, 0.0, 0.0, 1.0), 0.75 * segment};
  }
  return bad_input("--zoom {}: {}", name, unknown ? unknown->message : "the scene has no character");
}

Result<PanelMaker> PanelMaker::create(Device& device, const Stage& stage, const SceneOptions& scene,
                                      const LookOptions& look, const FigureLook& figure,
                                      std::vector<std::string>& problems) {
  LookOptions whole_look = look;
  whole_look.wire = figure.overlay.wire;
  auto main = FrameMaker::create(device, stage, scene, whole_look, problems);
  if (!main) return pass_on(std::move(main));
  if (figure.overlay.of_faces()) {
    const std::string asked = overlay_words({.guides = figure.overlay.guides, .regions = figure.overlay.regions});
    for (const StagedCharacter& character : stage.characters)
      if (const std::string why = without_regions(*character.model, character.mesh); !why.empty()) {
        std::string problem =
            fmt::format("{}: the overlay of {} shows nothing of it: {}", character.scene.model.string(), asked, why);
        if (std::ranges::find(problems, problem) == problems.end()) problems.push_back(std::move(problem));
      }
  }
  PanelMaker panel(stage, std::move(*main), scene, figure);
  panel.inset_label_ = figure.zoom;
  if (figure.zoom.empty()) return panel;
  auto zoom = find_zoom(stage, figure.zoom);
  if (!zoom) return pass_on(std::move(zoom));
  panel.zoom_ = *zoom;
  LookOptions near_look = whole_look;
  const bool paired = figure.compare_as == ComparisonPlace::inset && figure.compares();
  const double side = (paired ? paired_inset_share : inset_share) * std::min(look.size.width, look.size.height);
  near_look.size = {std::max(static_cast<int>(side), 1), std::max(static_cast<int>(side), 1)};
  std::vector<std::string> repeated;
  auto near = FrameMaker::create(device, stage, scene, near_look, repeated);
  if (!near) return pass_on(std::move(near));
  panel.near_ = std::move(*near);
  return panel;
}

OverlayContent PanelMaker::content(int frame) const { return overlay_content(*stage_, scene_, figure_.overlay, frame); }

Result<Picture> PanelMaker::near_picture(int frame, double orbit, const Font* font) {
  Shot shot = near_->shot(frame, orbit);
  const Vec3 target = zoom_position(*stage_, zoom_, frame);
  const double distance = zoom_.reach / std::tan(0.5 * vertical_field_of_view_degrees * degrees_to_radians);
  const Vec3 moved = target + distance * shot.viewpoint.back - shot.viewpoint.eye;
  shot.viewpoint.eye += moved;
  // Whatever stands between the camera and the joint, or behind it, is seen as in the whole picture.
  shot.viewpoint.near_plane = 0.02 * distance;
  shot.viewpoint.far_plane += glm::length(moved) + distance;
  if (shot.viewpoint.is_parallel()) {
    shot.viewpoint.parallel_height = 2.0 * zoom_.reach;
    shot.viewpoint.near_plane = -shot.viewpoint.far_plane;
  }
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
  auto near = near_picture(frame, orbit, font);
  if (!near) return near;
  if (auto ok = add_inset(*picture, *near, {.label = inset_label_}, font); !ok) return pass_on(std::move(ok));
  return picture;
}

}  // namespace sinew
