#pragma once
/// A face's channels and expressions as shapes for players that blend linearly. engine/definitions.md 15.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/face/expression.h"
#include "engine/model/character_mesh.h"

namespace sinew {

/// A shape that a face can take on: positions in drawing units and normals.
struct HeadShape {
  std::string name;
  std::vector<Vec3> positions;  ///< [vertices]
  std::vector<Vec3> normals;
};

/// A shape before it is made: the way from one state to another, of one half of the face or of both.
struct ShapeRecipe {
  std::string name;
  FaceChannels from{}, to{};
  FaceHalf half = FaceHalf::both;
};

/// One for each channel at each of its limits that it can reach alone (its name and "+" or "-", such as
/// "browLeft.up+"), then one for each expression, VRM preset and ARKit shape; `strict` leaves out of expressions what
/// the thesis does not have.
std::vector<ShapeRecipe> shape_recipes(const FaceRig& face, bool strict);

/// The name of the shape of a channel at its upper or lower limit.
std::string channel_shape_name(std::size_t channel, bool positive);

/// Shapes leave eyeballs at least this share of their size.
constexpr double least_eye_share = 0.75;

/// The shape of a recipe. `posed` gives the face in a state. Where lids shut, the eyeballs draw back a little with
/// them: a lid that moves straight instead of turning would dip below the ball half way.
HeadShape shape_of(const FaceRig& face, const HeadShape& rest, const ShapeRecipe& recipe,
                   const std::function<HeadShape(const FaceChannels&)>& posed);

/// Adds all shapes of the mesh's face, which has one, to the model that it was made from, as morph targets behind those
/// that are there. A mesh that several nodes draw gets them from the first.
void add_face_shapes(const CharacterMesh& mesh, Model& model);

}  // namespace sinew
