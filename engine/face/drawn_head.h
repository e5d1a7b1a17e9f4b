#pragma once
/// `builtin:head` as a scene asks for it: a model with its face, and both at every age that the scene shows.

#include <string>
#include <vector>

#include "engine/face/head.h"
#include "engine/model/character_mesh.h"

namespace sinew {

/// The measures that a scene asks for at a frame. Fails as DrawnHead::make does.
Result<HeadMeasures> head_measures(const HeadSpec& spec, double frame);

class DrawnHead {
 public:
  /// `frame`: at whose age the model is made. Fails as bad_input, as read_file() does where there is no such file of
  /// measures; the message begins with the place in the spec, such as "/skull: ".
  static Result<DrawnHead> make(const HeadSpec& spec, double frame);

  const Model& model() const { return model_; }
  /// Of the model's vertices, as character_mesh() has them.
  const CharacterFace& face() const { return face_; }
  /// Whether it grows older or younger in the scene.
  bool changes() const { return stops_.size() > 1; }
  /// The measures it was made from, for whoever asks whether two heads are the same.
  const std::string& measures() const { return measures_; }

  /// Puts the positions, normals and face of the age at a frame into a mesh that was made from the model. Heads every
  /// 1/16 of the way from adult to infant are drawn, and what lies between them is linear.
  void age(double frame, CharacterMesh& mesh) const;
  /// The face of the age at a frame without its vertices: what limits and amounts go by. Of heads that change.
  FaceRig sizes(double frame) const;

 private:
  /// A head drawn at one age; all have deltas of the same signals at the same vertices.
  struct Stop {
    double age = 0.0;
    std::vector<Vec3> positions, normals;  ///< [vertices of the model] metres
    CharacterFace face;
  };

  /// The stops around a frame's age, and how far it is from the first (0) to the second (1).
  struct Span {
    const Stop *older, *younger;
    double t;
  };
  Span span_at(double frame) const;
  CharacterFace face_at(double frame) const;

  Model model_;
  CharacterFace face_;
  Keyed<double> ages_;
  std::vector<Stop> stops_;  ///< ages rising
  std::string measures_;
};

}  // namespace sinew
