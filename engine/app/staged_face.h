#pragma once
/// How a scene moves a character's face: by regions, where its mesh has them, else by the model's own morph targets.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/face/drawn_head.h"
#include "engine/face/face_track.h"
#include "engine/face/landmarks.h"
#include "engine/face/target_face.h"

namespace sinew {

/// A channel that a scene asks to go further than it may, and where it asks the most.
struct HeldKey {
  HeldChannel held;
  int frame = 0;
};

struct StagedFace {
  FaceTrack track;
  std::shared_ptr<const DrawnHead> head;  ///< of builtin:head; it may change its age
  std::optional<CharacterFace> worn;      ///< of a figure that wears a head
  std::optional<TargetFace> targets;      ///< of a mesh without regions, where it is asked to move
  std::vector<HeldKey> held;              ///< over the scene's range
  Landmarks landmarks;                    ///< that its regions were laid on by; points of the model at rest
  std::vector<std::string> problems;      ///< of these, for people
};

/// Makes ready what `character` asks of its face. `mesh.face` is there already if the mesh has regions. Fails as
/// bad_input where there is nothing that could move; the message begins with the place in the character.
Result<void> stage_face(const Character& character, const Model& model, const CharacterMesh& mesh, StagedFace& face);

/// A head that changes its age: this frame's mesh. Null for all others.
std::shared_ptr<const CharacterMesh> mesh_at(const StagedFace& face, const CharacterMesh& mesh, double frame);

/// Why nothing of its face can be drawn over a picture: "" where it has regions.
std::string without_regions(const Model& model, const CharacterMesh& mesh);

/// The regions' state at a frame, held at their limits; `mesh` is the frame's. Nothing where it has no regions.
std::optional<FaceState> face_state_at(const StagedFace& face, const CharacterMesh& mesh, double frame);

/// The face at a frame without its vertices: what limits and amounts go by. The mesh has regions.
FaceRig face_sizes_at(const StagedFace& face, const CharacterMesh& mesh, double frame);

/// What is held at limits from `first` to `last`, each channel where it asks the most; long ranges are sampled.
std::vector<HeldKey> held_over(const StagedFace& face, const CharacterMesh& mesh, int first, int last);

}  // namespace sinew
