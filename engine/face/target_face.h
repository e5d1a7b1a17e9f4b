#pragma once
/// A face by a model's own morph targets, where they have names that are known of faces: our shapes' (head_shapes.h),
/// VRM's, ARKit's.

#include <map>
#include <optional>
#include <span>

#include "engine/face/face_track.h"
#include "engine/model/character_mesh.h"

namespace sinew {

class TargetFace {
 public:
  /// Nothing where no target has a known name. Upper and lower case do not matter, "_L" is "Left", and what stands
  /// before the last "." or ":" of a name may be another's.
  static std::optional<TargetFace> find(const Model& model, const CharacterMesh& mesh);

  /// The known names that it found.
  std::vector<std::string> names() const;

  /// What prepare() would not refuse: an expression, and a channel above (`up`) or below 0.
  bool can_show(const FacePreset& expression) const { return !expression_mix(expression).empty(); }
  bool can_move(std::size_t channel, bool up) const { return !channel_mix(channel, up).empty(); }
  /// By whose limits regions go: an adult's, without vertices.
  static const FaceRig& sizes();

  /// Makes ready what the track asks for: a target of an expression's name is that expression; else targets are mixed
  /// so that their regions come as near to what is wanted as weights from 0 to 1 can. Fails as bad_input where that is
  /// not near at all; the message begins with the place in the character, such as "/regions/nose: ".
  Result<void> prepare(const FaceTrack& track);

  /// Adds what the track shows at a frame to the weights [mesh.morph_slots]; what the face adds is held within 0 to 1.
  void add_weights(const FaceTrack& track, double frame, std::span<double> weights) const;

 private:
  /// A morph target: the channels that it stands for, each as a share of its limit, and the slots that have it.
  struct Target {
    std::string name;  ///< as it is known
    FaceChannels shares{};
    std::vector<std::uint32_t> slots;
  };
  using Mix = std::vector<double>;  ///< [targets]

  std::optional<std::size_t> named(const std::string& name) const;
  // Empty where no mix comes near.
  Mix expression_mix(const FacePreset& expression) const;
  Mix channel_mix(std::size_t channel, bool up) const;
  Mix mix_for(const FaceChannels& shares) const;

  std::vector<Target> targets_;
  std::map<const FacePreset*, Mix> of_expression_;
  std::map<std::pair<std::size_t, bool>, Mix> of_channel_;  ///< at the limit above (true) or below 0
};

}  // namespace sinew
