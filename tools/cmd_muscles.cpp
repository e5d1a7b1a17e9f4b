#include <algorithm>
#include <iostream>

#include <spdlog/spdlog.h>

#include "engine/app/muscle_scene.h"
#include "engine/core/files.h"
#include "engine/core/text.h"
#include "engine/model/scene_words.h"
#include "tools/command.h"
#include "tools/muscle_report.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  std::string model, output;
  std::vector<std::string> presets;
  bool all = false;
  double strength = 1.0;
};

Result<std::vector<MusclePreset>> presets_of(const Words& words) {
  const auto known = muscle_preset_names();
  std::vector<MusclePreset> presets;
  if (words.all) {
    for (std::size_t i = 0; i < known.size(); ++i) presets.push_back(static_cast<MusclePreset>(i));
    return presets;
  }
  if (words.presets.empty()) return std::vector{MusclePreset::biceps, MusclePreset::calf};
  for (const std::string& word : words.presets) {
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end())
      return failure(ErrorKind::usage, "--preset {}: expected one of {}{}", word, fmt::join(known, ", "),
                     did_you_mean(word, known));
    const auto preset = static_cast<MusclePreset>(found - known.begin());
    if (std::find(presets.begin(), presets.end(), preset) == presets.end()) presets.push_back(preset);
  }
  return presets;
}

Result<void> muscles(const Words& words) {
  apply_verbosity(words.common);
  MuscleSceneOptions options{words.model, words.output, {}, words.all, words.strength};
  auto presets = presets_of(words);
  if (!presets) return pass_on(std::move(presets));
  options.presets = std::move(*presets);
  if (!(words.strength >= 0.0 && words.strength <= 1.0))
    return failure(ErrorKind::usage, "--strength {}: expected a number from 0 to 1", words.strength);
  if (words.model.empty())
    return failure(ErrorKind::usage, "the model's name is empty; name a .glb, .gltf or .vrm file");
  if (words.output.empty())
    return failure(ErrorKind::usage, "-o: the scene's name is empty; name a file such as x.json");
  if (auto ok = check_writable(options.output); !ok) return ok;
  auto report = write_muscle_scene(options);
  if (!report) return pass_on(std::move(report));
  std::vector<std::string> problems = report->problems;
  for (const std::string& problem : report->stage.problems) {
    // What the model's own default muscles lack was said, or does not matter.
    if (problem.find(": muscle \"") == std::string::npos) problems.push_back(problem);
  }
  log_problems(problems);
  const nlohmann::ordered_json placed = muscles_json(report->stage, false);
  spdlog::info("{}: {} muscles", options.output, placed.size());
  if (words.common.json) {
    print_json({{"file", options.output}, {"model", options.model}, {"muscles", placed}, {"problems", problems}});
  } else {
    std::cout << muscle_table(placed);
  }
  return {};
}

}  // namespace

void add_muscles(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("muscles", "Places muscles on a humanoid and writes them as a scene");
  command->footer("Example: sinew muscles character.glb -o character.json --preset biceps --preset triceps");
  auto words = std::make_shared<Words>();
  command->add_option("model", words->model, "A .glb, .gltf or .vrm file")->required();
  command->add_option("-o,--output", words->output, "The scene file, such as x.json")->required();
  auto* preset = command
                     ->add_option("--preset", words->presets,
                                  fmt::format("{}; repeatable; biceps and calf where none is named",
                                              fmt::join(muscle_preset_names(), ", ")))
                     ->allow_extra_args(false);
  command->add_flag("--all", words->all, "All of them")->excludes(preset);
  command->add_option("--strength", words->strength, "Of all peaks, 0 to 1")->capture_default_str();
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return muscles(*words); }; });
}

}  // namespace sinew::tools
