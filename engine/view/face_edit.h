#pragma once
/// What a face does at a frame, and the edits of a scene that change it. No interface here.

#include <optional>
#include <span>

#include "engine/app/stage.h"

namespace sinew {

/// A face with regions at a frame. Channels are in this head's own units.
struct ShownFace {
  FaceRig sizes;                  ///< without vertices
  FaceChannels expressions{};     ///< what expressions alone do
  FaceChannels regions{};         ///< what the regions' keys add
  FaceChannels shown{};           ///< both, held at the limits
  std::vector<double> strengths;  ///< [expression_names()] from the scene's keys
};

/// Nothing where the character's mesh has no regions.
std::optional<ShownFace> shown_face(const StagedCharacter& character, double frame);

/// How far a channel may go while the others are where they are shown.
struct ChannelRange {
  double low = 0.0, high = 0.0;
};
ChannelRange channel_range(const ShownFace& face, FaceChannel channel);

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
