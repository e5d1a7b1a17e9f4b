#pragma once
/// Faces on whole models: found by landmarks, written as morph targets.

#include <span>

#include "engine/face/face_transfer.h"
#include "engine/face/find_landmarks.h"
#include "engine/face/head_shapes.h"
#include "engine/model/character_mesh.h"
#include "engine/model/model.h"

namespace sinew {

/// A model, at rest, with a face.
struct ModelFace {
  CharacterMesh mesh;        ///< positions and normals at rest, in the model's space
  std::vector<Mat3> blend;   ///< [vertices] from the bind pose to rest
  TransferredFace transfer;  ///< of that mesh
};

/// Landmarks found on the model: at its humanoid head, or on the whole of a mesh without a skeleton. Points at rest.
/// Fails as find_landmarks does.
Result<FoundLandmarks> find_model_landmarks(const Model& model);

/// Lays the template's face on the model. `name`: the landmark file's, for messages. Fails as placed_landmarks and
/// transfer_face do.
Result<ModelFace> model_face(const Model& model, const LandmarkPlaces& landmarks, const std::string& name);

/// The face for the deformers, which move the bind pose. Fails as bad_input where the vertices that move lie in more
/// than one space, as those of rigid parts of their own do: such models take morph targets alone.
Result<CharacterFace> character_face(const ModelFace& face, const CharacterMesh& bind, const std::string& name);

/// Adds a morph target a shape to every mesh of which the face moves a vertex, and returns how many vertices move.
std::size_t add_face_targets(const ModelFace& face, std::span<const HeadShape> shapes, Model& model);

/// Puts a shape in place of the model's own rest: the face is baked in.
void set_face_shape(const ModelFace& face, const HeadShape& shape, Model& model);

}  // namespace sinew
