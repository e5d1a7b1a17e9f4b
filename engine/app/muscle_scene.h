#pragma once
/// A scene with muscles made for a model: `sinew muscles`.

#include "engine/app/stage.h"

namespace sinew {

struct MuscleSceneOptions {
  std::string model;                  ///< a glTF file, or a built-in model's name
  std::string output;                 ///< the scene file
  std::vector<MusclePreset> presets;  ///< each on both sides
  bool only_what_fits = false;        ///< presets that fit neither side are left out, and are problems
  double strength = 1.0;              ///< 0 to 1, of all peaks
};

struct MuscleSceneReport {
  Stage stage;                        ///< the model; its character's muscles are those written
  std::vector<std::string> problems;  ///< what was left out, and regions too small to show much
};

/// How presets are placed on both sides of a character.
struct PresetPlacing {
  std::vector<MusclePreset> presets;
  bool only_what_fits = false;  ///< as in MuscleSceneOptions
  double strength = 1.0;        ///< of the peaks
};

/// The muscles on both sides. A side without its joints is a problem, no failure. Fails as bad_input as
/// write_muscle_scene() does.
Result<std::vector<PlacedMuscle>> place_presets(const StagedCharacter& character, const PresetPlacing& placing,
                                                std::vector<std::string>& problems);

/// Places the muscles on the model and writes a scene that shows what the bare model shows, with every number of every
/// muscle in it. A side that the model does not have is a problem; fails as bad_input, and writes nothing, where the
/// file is no model or a preset fits neither side, saying what is missing.
Result<MuscleSceneReport> write_muscle_scene(const MuscleSceneOptions& options);

}  // namespace sinew
