#include "engine/app/stage.h"

#include <set>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/rig/clip_sampling.h"

namespace sinew {
namespace {

/// Up to this many frames a range's bounds are taken from every frame; beyond it from so many evenly spaced ones, and
/// from every key of the scene.
constexpr int most_bounds_samples = 256;

Mat4 placement(const Character& character, double frame) {
  const Mat4 moved = glm::translate(Mat4(1.0), character.position.value_at(frame));
  return glm::rotate(moved, character.turn.value_at(frame) * degrees_to_radians, Vec3(0, 1, 0));
}

Bounds bounds_of(const std::vector<Vec3>& points) {
  Bounds bounds;
  for (const Vec3& p : points) bounds.add(p);
  return bounds;
}

template <class T>
void add_key_frames(const Keyed<T>& keyed, const FrameSpan& range, std::set<int>& frames) {
  for (const auto& key : keyed.keys)
    if (key.frame >= range.first && key.frame <= range.last) frames.insert(static_cast<int>(std::round(key.frame)));
}

/// The frames from which a character's bounds are taken.
std::set<int> bounds_frames(const FrameSpan& range, const StagedCharacter& character) {
  std::set<int> frames;
  const int length = range.last - range.first;
  const int samples = std::max(std::min(length, most_bounds_samples - 1), 1);
  for (int i = 0; i <= samples; ++i)
    frames.insert(range.first + static_cast<int>(std::round(double(length) * i / samples)));
  if (length < most_bounds_samples) return frames;
  add_key_frames(character.scene.position, range, frames);
  add_key_frames(character.scene.turn, range, frames);
  for (const StagedCharacter::JointTrack& track : character.tracks) add_key_frames(track.degrees, range, frames);
  for (const FaceTrack::Keys& keys : character.face.track.keys) add_key_frames(keys.strength, range, frames);
  for (const FaceTrack::Region& region : character.face.track.regions) add_key_frames(region.numbers, range, frames);
  return frames;
}

}  // namespace

std::size_t Stage::vertices() const {
  std::size_t sum = 0;
  for (const StagedCharacter& character : characters) sum += character.mesh.vertices();
  return sum;
}

std::size_t Stage::triangles() const {
  std::size_t sum = 0;
  for (const StagedCharacter& character : characters) sum += character.mesh.triangles.size() / 3;
  return sum;
}

Mat4 character_placement(const Stage& stage, std::size_t character, double frame) {
  return placement(stage.characters[character].scene, frame);
}

Pose character_pose(const Stage& stage, std::size_t index, double frame) {
  const StagedCharacter& character = stage.characters[index];
  Pose pose = rest_pose(*character.model);
  if (character.clip >= 0) sample_clip(character.model->clips[character.clip], frame / stage.scene.fps, pose);
  if (character.motion) play_motion(*character.motion, frame, stage.scene.fps, pose);
  for (const StagedMotion& emotion : character.emotions) play_motion(emotion, frame, stage.scene.fps, pose);
  for (const StagedCharacter::JointTrack& track : character.tracks) {
    const auto turn = track.added ? turn_joint_further : turn_joint;
    turn(*character.model, character.rest_rotations, track.node, track.degrees.value_at(frame), pose);
  }
  return pose;
}

CharacterState character_state(const Stage& stage, std::size_t index, double frame) {
  const StagedCharacter& character = stage.characters[index];
  const Pose pose = character_pose(stage, index, frame);
  CharacterState state;
  state.global = global_transforms(*character.model, character.order, pose);
  state.palette = palette_transforms(character.mesh, state.global, placement(character.scene, frame));
  state.morph_weights = morph_slot_weights(character.mesh, pose);
  state.mesh = mesh_at(character.face, character.mesh, frame);
  state.face = face_state_at(character.face, state.mesh ? *state.mesh : character.mesh, frame);
  if (character.face.targets) character.face.targets->add_weights(character.face.track, frame, state.morph_weights);
  for (const PlacedMuscle& placed : character.muscles) {
    const double angle = placed.driver.degrees(state.global);
    state.activations.push_back(stage.strength * muscle_activation(placed.muscle, angle));
  }
  return state;
}

DeformedVertices deform_on_cpu(const StagedCharacter& character, const CharacterState& state, Deformer deformer,
                               BulgeMode bulge) {
  std::vector<ActiveMuscle> active;
  for (std::size_t i = 0; i < character.muscles.size(); ++i)
    active.push_back({character.muscles[i].muscle, character.muscles[i].region, state.activations[i]});
  return deform_reference(
      state.mesh ? *state.mesh : character.mesh, character.rest,
      {state.palette, state.morph_weights, active, deformer, bulge, state.face ? &*state.face : nullptr});
}

Bounds rest_bounds(const Stage& stage) {
  Bounds bounds;
  for (const StagedCharacter& character : stage.characters) {
    const Mat4 at_first = placement(character.scene, stage.range.first);
    for (const Vec3& p : character.rest.positions) bounds.add(Vec3(at_first * Vec4(p, 1.0)));
  }
  return bounds;
}

Bounds stage_bounds(const Stage& stage) {
  TaskWatch unwatched;
  return *stage_bounds(stage, unwatched);
}

Result<Bounds> stage_bounds(const Stage& stage, TaskWatch& watch) {
  Bounds bounds = rest_bounds(stage);
  for (std::size_t c = 0; c < stage.characters.size(); ++c) {
    const StagedCharacter& character = stage.characters[c];
    const std::set<int> frames = bounds_frames(stage.range, character);
    watch.add(frames.size());
    for (const int frame : frames) {
      if (auto ok = watch.check(); !ok) return pass_on(std::move(ok));
      const CharacterState state = character_state(stage, c, frame);
      bounds.add(bounds_of(deform_on_cpu(character, state, Deformer::ssd, BulgeMode::off).positions));
      watch.advance();
    }
  }
  if (bounds.empty()) bounds.add(Vec3(0.0));
  return bounds;
}

Result<void> check_not_an_input(const Stage& stage, const std::string& output) {
  std::vector<std::filesystem::path> inputs{stage.source};
  for (const StagedCharacter& character : stage.characters) {
    inputs.push_back(character.scene.model);
    if (character.motion) inputs.push_back(character.motion->file);
    if (character.scene.head) inputs.push_back(character.scene.head->file);
    for (const StagedMotion& emotion : character.emotions) inputs.push_back(emotion.file);
  }
  std::error_code error;
  for (const std::filesystem::path& input : inputs)
    if (std::filesystem::equivalent(input, output, error))
      return failure(ErrorKind::cannot_write, "{}: is read by this very command; write to another file", output);
  return {};
}

std::vector<int> selected_frames(const Stage& stage, const SceneOptions& options, bool one_picture) {
  if (options.frames) return *options.frames;
  std::vector<int> frames{stage.range.first};
  if (!one_picture)
    for (int frame = stage.range.first + 1; frame <= stage.range.last; ++frame) frames.push_back(frame);
  return frames;
}

}  // namespace sinew
