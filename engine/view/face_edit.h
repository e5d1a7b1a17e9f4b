#pragma once
/// What a face does at a frame, and the edits of a scene that change it. No interface here.

#include <optional>
#include <span>

#include "engine/app/stage.h"

namespace sinew {

/// A face at a frame. Channels are in this head's own units; of a face by morph targets, in an adult's.
struct ShownFace {
  FaceRig sizes;                  ///< without vertices
  FaceChannels expressions{};     ///< what expressions alone do
  FaceChannels regions{};         ///< what the regions' keys add
  FaceChannels shown{};           ///< both, held at the limits
  std::vector<double> strengths;  ///< [expression_names()] from the scene's keys
};

/// Nothing where the character's mesh has neither regions nor morph targets that are known of faces.
std::optional<ShownFace> shown_face(const StagedCharacter& character, double frame);

/// How far a channel may go while the others are where they are shown.
struct ChannelRange {
  double low = 0.0, high = 0.0;
};
ChannelRange channel_range(const ShownFace& face, FaceChannel channel);

/// The character's face by morph targets; nothing where it has regions, or no known targets.
std::optional<TargetFace> target_face(const StagedCharacter& character);
/// What a face by morph targets can be made to do.
struct TargetAbilities {
  std::vector<bool> expressions;                       ///< [expression_names()]
  std::array<ChannelRange, face_channels> channels{};  ///< how far regions go; nowhere: 0 to 0
};
TargetAbilities target_abilities(const TargetFace& face);

/// Shows one expression at a frame, in place of another there; the keys beside it cross-fade with it.
/// `strength`: 0 to most_expression_strength.
void set_expression(Character& character, double frame, Expression expression, double strength);

/// Where a channel is to go, expressions included.
struct ChannelGoal {
  FaceChannel channel;
  double value;
};
/// Moves channels as far towards their goals as the limits let them, and writes their regions at the frame. Other
/// regions that a limit pushes, as a lower lip by the upper, go along.
void move_channels(Character& character, const ShownFace& face, double frame, std::span<const ChannelGoal> goals);

/// Gives a region's number at a frame another value: what it adds to expressions, whatever they do.
void set_channel(Character& character, const ShownFace& face, double frame, FaceChannel channel, double value);

/// Takes a region's numbers away at all frames.
void reset_region(Character& character, FaceChannel channel);

/// Makes what the face does at a frame keys, so that other frames can differ; where there is nothing yet the neutral
/// expression is the key.
void add_face_key(Character& character, const ShownFace& face, double frame);
void remove_face_key(Character& character, double frame);

/// True where the scene can give this character another head.
bool has_drawn_head(const Character& character);
/// The head of another age or skull. Only builtin:head can have keys of its age. Weights of 0 are left out.
void set_head_age(Character& character, double frame, double age);
void set_skull(Character& character, const std::string& outline, double weight);

}  // namespace sinew
