#pragma once
/// What a scene asks of a face over time: expressions by keys and cues, regions by keys. engine/definitions.md 15.

#include <utility>
#include <vector>

#include "engine/face/expression.h"
#include "engine/model/scene.h"

namespace sinew {

struct FaceTrack {
  /// An expression's strength over time, from the scene's keys.
  struct Keys {
    const FacePreset* expression;
    Keyed<double> strength;
  };
  struct Cue {
    const FacePreset* expression;
    ExpressionCue cue;
  };
  /// A region's numbers over time, and the first of their channels; a region's stand one after another.
  struct Region {
    std::size_t first_channel;
    Keyed<std::vector<double>> numbers;
  };
  std::vector<Keys> keys;
  std::vector<Cue> cues;
  std::vector<Region> regions;

  bool empty() const { return keys.empty() && cues.empty() && regions.empty(); }
};

/// Fails as bad_input where a cue names no known expression; the message begins with the place in the character, such
/// as "/expressions: ".
Result<FaceTrack> face_track(const Character& character);

/// How much of a cue's expression there is at a frame: rising over `fade` frames from `start`, whole until `until`,
/// falling until `stop`; what there is no room for is cut off the rise.
double cue_strength(const ExpressionCue& cue, double frame);

/// The expressions at a frame, those without strength left out. An expression that two sources show stands twice.
std::vector<WeighedExpression> expressions_at(const FaceTrack& track, double frame);

/// What the regions' keys add, in this head's own units.
FaceChannels regions_at(const FaceTrack& track, double frame);

/// Both on a face, before its limits.
FaceChannels channels_at(const FaceTrack& track, const FaceRig& face, double frame);

/// The frames from the first to the last at which something changes.
std::pair<double, double> reach_of(const FaceTrack& track);

}  // namespace sinew
