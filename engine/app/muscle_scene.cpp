#include "engine/app/muscle_scene.h"
#include "engine/app/stage_use.h"

#include <algorithm>

#include <fmt/ranges.h>

#include "engine/core/files.h"
#include "engine/io/scene_file.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

/// What is wrong with a model on which a preset found no place on either side.
std::string what_is_missing(const StagedCharacter& character, const std::vector<std::string>& reasons) {
  std::vector<std::string> said = reasons;
  const std::vector<HumanoidBone> missing = character.humanoid.missing_required();
  if (!missing.empty()) {
    std::vector<std::string_view> names;
    for (const HumanoidBone bone : missing) names.push_back(humanoid_name(bone));
    if (std::all_of(character.humanoid.node.begin(), character.humanoid.node.end(), [](int n) { return n < 0; }))
      said = {"no humanoid joints were found in it"};
    said.push_back(fmt::format("a humanoid needs {}, which this model lacks", fmt::join(names, ", ")));
  }
  for (const std::string& note : character.humanoid.notes) said.push_back(note);
  return fmt::format("{}", fmt::join(said, "; "));
}

}  // namespace

Result<std::vector<PlacedMuscle>> place_presets(const StagedCharacter& character, const PresetPlacing& placing,
                                                std::vector<std::string>& problems) {
  const std::string model = character.scene.model.string();
  const PlacementContext context = placement_context(character);
  std::vector<PlacedMuscle> muscles;
  for (const MusclePreset preset : placing.presets) {
    std::vector<std::string> reasons;
    for (const MuscleSide side : {MuscleSide::left, MuscleSide::right}) {
      MuscleSpec spec;
      spec.preset = preset;
      spec.side = side;
      auto placed = place_muscle(context, spec);
      if (!placed) {
        reasons.push_back(placed.error().message);
        continue;
      }
      placed->muscle.peak *= placing.strength;
      for (std::string& problem : placement_problems(*placed)) problems.push_back(std::move(problem));
      muscles.push_back(std::move(*placed));
    }
    if (reasons.size() == 2 && !placing.only_what_fits)
      return bad_input("{}: no place for the muscle \"{}\": {}", model,
                       muscle_preset_names()[static_cast<std::size_t>(preset)], what_is_missing(character, reasons));
    problems.insert(problems.end(), reasons.begin(), reasons.end());
  }
  if (muscles.empty()) return bad_input("{}: no place for any muscle: {}", model, what_is_missing(character, {}));
  return muscles;
}

Result<MuscleSceneReport> write_muscle_scene(const MuscleSceneOptions& options) {
  SceneOptions opening;
  opening.scene = options.model;
  auto stage = open_stage(opening);
  if (!stage) return pass_on(std::move(stage));
  if (stage->is_scene) return bad_input("{}: is a scene; name a model (.glb, .gltf or .vrm)", options.model);
  if (auto ok = check_not_an_input(*stage, options.output); !ok) return pass_on(std::move(ok));
  MuscleSceneReport report{std::move(*stage), {}};
  StagedCharacter& character = report.stage.characters.front();
  auto muscles = place_presets(character, {options.presets, options.only_what_fits, options.strength}, report.problems);
  if (!muscles) return pass_on(std::move(muscles));
  character.muscles = std::move(*muscles);
  report.stage.scene = {};
  report.stage.scene.characters.emplace_back().model = character.scene.model;
  const auto scene = spelled_out_scene(report.stage);
  if (!scene) return tl::unexpected<Error>(scene.error());
  const std::filesystem::path folder = std::filesystem::path(options.output).parent_path();
  if (auto ok = write_file(options.output, scene_text(*scene, folder)); !ok) return pass_on(std::move(ok));
  return report;
}

}  // namespace sinew
