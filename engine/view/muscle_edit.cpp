#include "engine/view/muscle_edit.h"

#include <algorithm>

#include "engine/app/muscle_scene.h"
#include "engine/app/stage_use.h"
#include "engine/body/muscle_spec.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

constexpr double straight = 180.0, least_range = 1.0;

bool has_muscle(const Character& character, const std::string& name) {
  return std::ranges::find(character.muscles, name, muscle_name) != character.muscles.end();
}

MuscleSpec preset_muscle(MusclePreset preset, MuscleSide side) {
  MuscleSpec spec;
  spec.preset = preset;
  spec.side = side;
  return spec;
}

}  // namespace

void set_muscle_angle(MuscleSpec& spec, const Muscle& placed, MuscleAngle angle, double degrees) {
  const bool rest = angle == MuscleAngle::rest;
  const double other = rest ? placed.reference_angle : placed.rest_angle;
  double wanted = std::clamp(degrees, 0.0, straight);
  if (std::abs(wanted - other) < least_range) {
    wanted = other + (wanted < other ? -least_range : least_range);
    if (wanted < 0.0 || wanted > straight) wanted = 2.0 * other - wanted;
  }
  (rest ? spec.rest_angle : spec.reference_angle) = wanted;
}

bool has_muscle(const Character& character, MusclePreset preset, MuscleSide side) {
  return has_muscle(character, muscle_name(preset_muscle(preset, side)));
}

Result<void> add_muscle(Character& character, const StagedCharacter& staged, MusclePreset preset, MuscleSide side) {
  const auto placed = place_muscle(placement_context(staged), preset_muscle(preset, side));
  if (!placed) return tl::unexpected<Error>(placed.error());
  auto spec = explicit_muscle(placement_context(staged), *placed);
  if (!spec) return pass_on(std::move(spec));
  character.muscles.push_back(std::move(*spec));
  return {};
}

Result<int> add_fitting_muscles(Character& character, const StagedCharacter& staged) {
  PresetPlacing placing{.presets = {}, .only_what_fits = true};
  for (std::size_t i = 0; i < muscle_preset_names().size(); ++i)
    placing.presets.push_back(static_cast<MusclePreset>(i));
  std::vector<std::string> left_out;
  const auto placed = place_presets(staged, placing, left_out);
  if (!placed) return tl::unexpected<Error>(placed.error());
  std::vector<MuscleSpec> added;
  for (const PlacedMuscle& muscle : *placed) {
    if (has_muscle(character, muscle.muscle.name)) continue;
    auto spec = explicit_muscle(placement_context(staged), muscle);
    if (!spec) return pass_on(std::move(spec));
    added.push_back(std::move(*spec));
  }
  character.muscles.insert(character.muscles.end(), added.begin(), added.end());
  return static_cast<int>(added.size());
}

}  // namespace sinew
