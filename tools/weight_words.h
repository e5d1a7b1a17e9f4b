#pragma once
/// The options of commands that change skin weights.

#include <string>

#include "engine/fit/weight_edit.h"
#include "tools/command.h"

namespace sinew::tools {

struct WeightWords {
  int influences = static_cast<int>(max_influences), smooth = 0;
  double prune = 0.0;
  std::string mirror{}, from{};
};

/// `--influences`, `--prune`, `--smooth`, `--mirror` and `--from`, with the words' values as defaults.
void add_weight_options(CLI::App& command, WeightWords& words);

/// Fails as usage.
Result<WeightEdits> weight_edits(const WeightWords& words);

}  // namespace sinew::tools
