#pragma once
/// A scene made ready to play: files read, joints found, muscles placed. A frame's state is a pure function of the
/// stage and the frame's number. No Vulkan here.

#include <memory>
#include <string>
#include <vector>

#include "engine/app/motion_use.h"
#include "engine/app/options.h"
#include "engine/app/staged_face.h"
#include "engine/body/muscle_placement.h"
#include "engine/deform/reference.h"

namespace sinew {

/// A model and everything about it that no frame changes.
struct StagedCharacter {
  Character scene;  ///< what the scene says of it; its emotions' expressions are among the expressions
  std::shared_ptr<const Model> model;
  std::string model_hash;  ///< SHA-256 of all that it was read from, or the name of a built-in model
  std::vector<int> order;  ///< hierarchy_order
  std::vector<Quat> rest_rotations;
  Humanoid humanoid;
  CharacterMesh mesh;  ///< at the first frame: a head may change its age (CharacterState::mesh)
  RestShape rest;
  StagedFace face;
  std::vector<PlacedMuscle> muscles;
  int clip = -1;  ///< index into the model's clips, -1: none
  std::optional<StagedMotion> motion;
  std::vector<StagedMotion> emotions;  ///< one a cue, each over the one before

  /// A joint's angles over time.
  struct JointTrack {
    int node = -1;
    Keyed<Vec3> degrees;
    bool added = false;  ///< on top of the motion, not in its place
  };
  std::vector<JointTrack> tracks;  ///< the scene's keys, then --pose: the later wins
};

/// One character at one frame: what both deformers take.
struct CharacterState {
  std::vector<Mat4> global;                   ///< [nodes] before `placement`, model space
  std::vector<Mat34> palette;                 ///< [mesh.palette] world space
  std::vector<double> morph_weights;          ///< [mesh.morph_slots]
  std::vector<double> activations;            ///< [muscles] delta, times the strength
  std::optional<FaceState> face;              ///< of a mesh with a face
  std::shared_ptr<const CharacterMesh> mesh;  ///< in place of the character's, where this frame has one of its own
};

struct Stage {
  Scene scene;
  std::vector<StagedCharacter> characters;
  FrameSpan range;         ///< the scene's whole range
  double strength = 1.0;   ///< of all muscles
  bool is_scene = true;    ///< opened from a scene, not from a bare model
  std::string source;      ///< what was opened, for messages: a file, or "the embedded scene"
  std::string scene_hash;  ///< of what is shown: scene, models, clip, pose, fps, strength; no paths, no frames
  std::vector<std::string> problems;  ///< of all models, each with its file
  // What is kept for scenes to come, the latest first.
  std::vector<StagedCharacter> spare;       ///< models that no character of the scene uses now
  std::vector<StagedMotion> spare_motions;  ///< that no character plays now
  /// stage_bounds(), where whoever made the stage has found it already.
  std::optional<Bounds> bounds;

  std::size_t vertices() const;
  std::size_t triangles() const;
};

/// Opens a scene file, a bare model or the embedded default. Fails as bad_input, or as interrupted where the watch
/// stopped it; nothing is left half open.
Result<Stage> open_stage(const SceneOptions& options, TaskWatch& watch);
Result<Stage> open_stage(const SceneOptions& options);

/// Puts another scene on the stage: models and motions that it has already, some spare ones among them, are not made
/// again; missing_parts() tells which are. `options` as in open_stage(), but not its scene. Fails as open_stage() does
/// and then leaves the stage as it was.
Result<void> restage(Stage& stage, const Scene& scene, const SceneOptions& options);

/// The same for a scene that differs in the numbers of its muscles alone, of which it has as many: nothing else is made
/// anew. Fails as bad_input where one cannot be placed, and then leaves the stage as it was.
Result<void> restage_muscles(Stage& stage, const Scene& scene, const SceneOptions& options);

/// The stage's scene with everything spelled out that a bare model has by default: what it shows as a scene file does.
/// Fails as bad_input where a muscle's joint has no name.
Result<Scene> spelled_out_scene(const Stage& stage);

/// Where a character's joints and muscles stand at a frame.
CharacterState character_state(const Stage& stage, std::size_t character, double frame);

/// From model to world: the character's turn, then its position.
Mat4 character_placement(const Stage& stage, std::size_t character, double frame);

/// The pose alone, before forward kinematics.
Pose character_pose(const Stage& stage, std::size_t character, double frame);

/// The CPU's deformation of a character in a state.
DeformedVertices deform_on_cpu(const StagedCharacter& character, const CharacterState& state, Deformer deformer,
                               BulgeMode bulge);

/// The box round the rest pose, world space at the first frame of the range; empty where nothing is drawn.
Bounds rest_bounds(const Stage& stage);

/// The box round the rest pose and the scene's whole range, plain SSD, world space. Ranges of over 256 frames are
/// sampled at evenly spaced frames, both ends among them, and at the scene's keys.
Bounds stage_bounds(const Stage& stage);
/// The same, each frame an item of the watch more. Fails as interrupted.
Result<Bounds> stage_bounds(const Stage& stage, TaskWatch& watch);

/// Fails as cannot_write where `output` is one of the files that the stage was opened from.
Result<void> check_not_an_input(const Stage& stage, const std::string& output);

/// The frames that were asked for; else, for one picture, the first of the range; else the whole range.
std::vector<int> selected_frames(const Stage& stage, const SceneOptions& options, bool one_picture);

}  // namespace sinew
