#include "engine/app/complete_stage.h"

#include <nlohmann/json.hpp>

#include "engine/core/files.h"
#include "engine/io/scene_file.h"
#include "engine/model/scene_words.h"
#include "engine/rig/clip_sampling.h"

namespace sinew {
namespace {

/// --pose turns the joint of that name in every character that has it.
Result<void> add_poses(Stage& stage, const std::vector<PoseOption>& poses) {
  for (const PoseOption& pose : poses) {
    std::optional<Error> unknown;
    bool found = false;
    for (StagedCharacter& character : stage.characters) {
      const auto node = find_joint(*character.model, character.humanoid, pose.joint);
      if (!node) {
        unknown = node.error();
        continue;
      }
      character.tracks.push_back({*node, Keyed<Vec3>::constant(pose.degrees)});
      found = true;
    }
    if (!found)
      return bad_input("--pose {}: {}", pose.joint, unknown ? unknown->message : "the scene has no character");
  }
  return {};
}

/// What of the faces is held at limits, once a channel.
void note_held(Stage& stage) {
  for (StagedCharacter& character : stage.characters) {
    character.face.held = held_over(character.face, character.mesh, stage.range.first, stage.range.last);
    for (const auto& [held, frame] : character.face.held)
      stage.problems.push_back(fmt::format("{}: {} is held at {:.4g}, asked for {:.4g} (frame {})",
                                           character.scene.model.string(), channel_word(held.channel), held.held,
                                           held.asked, frame));
  }
}

/// From frame 0 to the last frame that a clip or a key has.
FrameSpan natural_range(const Stage& stage) {
  double last = 0.0;
  const auto reach = [&](const auto& keyed) { last = std::max(last, std::ceil(keyed.keys.back().frame)); };
  const Camera& camera = stage.scene.camera;
  reach(camera.orbit);
  if (camera.target) reach(*camera.target);
  if (camera.distance) reach(*camera.distance);
  for (const StagedCharacter& character : stage.characters) {
    reach(character.scene.position);
    reach(character.scene.turn);
    // A duration that is a whole number of frames up to rounding must not grow by one.
    if (character.clip >= 0)
      last = std::max(last, std::ceil(character.model->clips[character.clip].duration * stage.scene.fps - 1e-6));
    if (character.motion) last = std::max(last, std::ceil(last_frame(*character.motion, stage.scene.fps) - 1e-6));
    for (const StagedMotion& emotion : character.emotions) reach(emotion.use.weight);
    for (const StagedCharacter::JointTrack& track : character.tracks) reach(track.degrees);
    last = std::max(last, std::ceil(reach_of(character.face.track).second));
    if (character.scene.head) reach(character.scene.head->age);
  }
  return {0, static_cast<int>(std::clamp(last, 0.0, 1e7))};
}

}  // namespace

std::string hash_scene(const Stage& stage, const SceneOptions& options) {
  nlohmann::ordered_json json;
  Scene scene = stage.scene;
  scene.frames = stage.range;
  // Where a model lies does not change what is shown; what is in it does.
  for (std::size_t i = 0; i < scene.characters.size(); ++i) {
    scene.characters[i].model = stage.characters[i].model_hash;
    if (const auto& motion = stage.characters[i].motion)
      scene.characters[i].motion->source = LibraryClip{motion->content_hash};
  }
  json["scene"] = scene_text(scene, {});
  for (const StagedCharacter& character : stage.characters) {
    json["clips"].push_back(character.clip);
    for (const StagedMotion& emotion : character.emotions) json["emotions"].push_back(emotion.content_hash);
    for (const PlacedMuscle& placed : character.muscles) json["muscles"].push_back(placed.muscle.name);
  }
  for (const PoseOption& pose : options.poses)
    json["poses"].push_back({pose.joint, pose.degrees.x, pose.degrees.y, pose.degrees.z});
  json["strength"] = stage.strength;
  return sha256(json.dump());
}

Result<void> complete_stage(Stage& stage, const SceneOptions& options) {
  if (auto ok = add_poses(stage, options.poses); !ok) return bad_input("{}: {}", stage.source, ok.error().message);
  stage.range = stage.scene.frames.value_or(natural_range(stage));
  note_held(stage);
  stage.scene_hash = hash_scene(stage, options);
  return {};
}

}  // namespace sinew
