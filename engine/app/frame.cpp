#include "engine/app/frame.h"

#include "engine/app/device_state.h"

namespace sinew {
namespace {

ViewDirection direction(View view) {
  switch (view) {
    case View::front:
      return {0.0, 0.0};
    case View::left:
      return {90.0, 0.0};
    case View::back:
      return {180.0, 0.0};
    case View::right:
      return {270.0, 0.0};
    case View::top:
      return {0.0, 90.0};
    case View::three_quarter:
      return {35.0, 12.0};
  }
  return {};
}

std::array<float, 4> background_words(const Colour& colour) {
  if (colour.alpha == 0) return {0, 0, 0, 0};
  return {colour.red / 255.0f, colour.green / 255.0f, colour.blue / 255.0f, 1.0f};
}

double largest_bulge(const Stage& stage) {
  double largest = 0.0;
  for (const StagedCharacter& character : stage.characters)
    for (const PlacedMuscle& placed : character.muscles)
      if (placed.muscle.on) largest = std::max(largest, placed.muscle.peak);
  return largest;
}

/// How much each vertex follows a node.
std::vector<double> weights_of(const CharacterMesh& mesh, int node) {
  std::vector<double> weights(mesh.vertices(), 0.0);
  for (std::size_t v = 0; v < mesh.vertices(); ++v)
    for (std::uint32_t i = mesh.influences.first[v]; i < mesh.influences.first[v + 1]; ++i)
      if (mesh.palette[mesh.influences.entries[i].joint].node == node) weights[v] += mesh.influences.entries[i].weight;
  return weights;
}

/// What Shading::weights shows of each character: nothing where another shading is asked for, zeros where a character
/// lacks the joint. Fails as bad_input where none has it.
Result<std::vector<std::vector<double>>> shown_weights(const Stage& stage, const LookOptions& look) {
  std::vector<std::vector<double>> shown(stage.characters.size());
  const bool asked = look.shading.value_or(stage.scene.look.shading) == Shading::weights;
  const std::string& joint = look.joint.empty() ? stage.scene.look.joint : look.joint;
  if (joint.empty() && asked)
    return failure(ErrorKind::usage,
                   "--shading weights: whose? Name a joint with --joint, such as --joint leftLowerArm");
  if (joint.empty()) return shown;
  std::optional<Error> unknown;
  bool found = false;
  for (std::size_t i = 0; i < stage.characters.size(); ++i) {
    const StagedCharacter& character = stage.characters[i];
    const auto node = find_joint(*character.model, character.humanoid, joint);
    if (!node) unknown = node.error();
    found = found || node;
    if (asked) shown[i] = weights_of(character.mesh, node ? *node : -1);
  }
  if (!found) return bad_input("--joint {}: {}", joint, unknown ? unknown->message : "the scene has no character");
  return shown;
}

}  // namespace

FrameMaker::FrameMaker(Renderer renderer, const Stage& stage, const LookOptions& look, const Bounds& bounds,
                       double floor)
    : renderer_(std::move(renderer)), stage_(&stage), look_(look), bounds_(bounds), floor_(floor) {}

Result<FrameMaker> FrameMaker::create(Device& device, const Stage& stage, const SceneOptions& scene,
                                      const LookOptions& look, std::vector<std::string>& problems) {
  auto renderer =
      Renderer::create(device, {look.size.width, look.size.height, look.samples, look.wire, look.for_window});
  if (!renderer) return pass_on(std::move(renderer));
  const GpuDeformerOptions options{.deformer = scene.deformer, .bulge = scene.bulge};
  auto weights = shown_weights(stage, look);
  if (!weights) return pass_on(std::move(weights));
  for (std::size_t i = 0; i < stage.characters.size(); ++i) {
    const StagedCharacter& c = stage.characters[i];
    if (auto ok = renderer->add_character(*c.model, c.mesh, c.rest, c.muscles, options, {(*weights)[i]}, problems); !ok)
      return pass_on(std::move(ok));
  }
  const Bounds rest = rest_bounds(stage);
  return FrameMaker(std::move(*renderer), stage, look, stage.bounds ? *stage.bounds : stage_bounds(stage),
                    rest.empty() ? 0.0 : rest.low.y);
}

Result<Picture> FrameMaker::picture(int frame) { return picture(frame, shot(frame)); }

Result<Picture> FrameMaker::picture(int frame, const Shot& shot) {
  if (auto ok = upload(pose(frame)); !ok) return pass_on(std::move(ok));
  return renderer_.draw(shot);
}

std::vector<CharacterState> FrameMaker::pose(int frame) const {
  std::vector<CharacterState> states;
  for (std::size_t i = 0; i < stage_->characters.size(); ++i) states.push_back(character_state(*stage_, i, frame));
  return states;
}

Result<void> FrameMaker::upload(const std::vector<CharacterState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i)
    if (auto ok = load_state(stage_->characters[i], states[i], renderer_.deformer(i)); !ok) return ok;
  return {};
}

CameraPlace FrameMaker::camera_place(int frame) const {
  // A view that was asked for on the command line stands in place of all that the scene says about its camera.
  Camera camera = stage_->scene.camera;
  if (look_.view) {
    camera = {};
    camera.view = *look_.view;
  }
  ViewDirection towards = direction(camera.view);
  if (camera.elevation) towards.elevation = *camera.elevation;
  towards.azimuth += look_.orbit.value_or(camera.orbit.value_at(frame));
  const Rays rays = camera.projection == Projection::orthographic ? Rays::parallel : Rays::from_eye;
  CameraPlace place{towards, rays, {}, {}};
  if (camera.target) place.target = camera.target->value_at(frame);
  if (camera.distance) place.distance = camera.distance->value_at(frame);
  return place;
}

Viewpoint FrameMaker::viewpoint(int frame, double orbit) const {
  CameraPlace place = camera_place(frame);
  place.direction.azimuth += orbit;
  const Viewpoint framed =
      frame_box(bounds_, place.direction, double(look_.size.width) / look_.size.height, place.rays);
  if (!place.target && !place.distance) return framed;
  return look_at(place.target.value_or(bounds_.centre()),
                 place.distance.value_or(glm::length(framed.eye - bounds_.centre())), bounds_, place.direction,
                 place.rays);
}

Result<void> FrameMaker::draw_for_window(int frame, const std::vector<CharacterState>& states) {
  if (auto ok = upload(states); !ok) return ok;
  return renderer_.draw_for_window(shot(frame));
}

Result<void> FrameMaker::resize(const PictureSize& size) {
  if (auto ok = renderer_.resize(size.width, size.height); !ok) return ok;
  look_.size = size;
  return {};
}

void FrameMaker::follow_stage() {
  const Bounds rest = rest_bounds(*stage_);
  floor_ = rest.empty() ? 0.0 : rest.low.y;
  bounds_ = stage_->bounds ? *stage_->bounds : stage_bounds(*stage_);
}

Result<void> FrameMaker::follow_muscles() {
  for (std::size_t i = 0; i < stage_->characters.size(); ++i) {
    const StagedCharacter& c = stage_->characters[i];
    if (auto ok = renderer_.deformer(i).set_muscles(c.mesh, c.rest, c.muscles); !ok) return ok;
  }
  return {};
}

Shot FrameMaker::shot(int frame, double orbit) const {
  Shot shot;
  shot.viewpoint = viewpoint(frame, orbit);
  shot.shading = look_.shading.value_or(stage_->scene.look.shading);
  const Colour background = look_.background.value_or(stage_->scene.look.background);
  shot.background = background_words(background);
  shot.largest_bulge = largest_bulge(*stage_);
  shot.scene = bounds_;
  shot.shadows = look_.shadows.value_or(stage_->scene.look.shadows);
  const std::optional<bool> floor = look_.floor ? look_.floor : stage_->scene.look.floor;
  shot.ground = floor_;
  if (floor.value_or(background.alpha != 0)) shot.floor = floor_;
  return shot;
}

}  // namespace sinew
