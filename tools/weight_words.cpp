#include "tools/weight_words.h"

namespace sinew::tools {

void add_weight_options(CLI::App& command, WeightWords& words) {
  command.add_option("--from", words.from, "Take weights from this skinned glTF file, by the closest surface");
  command.add_option("--smooth", words.smooth, "Rounds of smoothing along the surface, 0 to 1000")
      ->capture_default_str();
  command.add_option("--mirror", words.mirror, "left or right: this side's weights go to the other side");
  command.add_option("--prune", words.prune, "Drop weights below this")->capture_default_str();
  command.add_option("--influences", words.influences, "At most so many joints a vertex, 1 to 8")
      ->capture_default_str();
}

Result<WeightEdits> weight_edits(const WeightWords& words) {
  WeightEdits edits;
  if (words.influences < 1 || words.influences > static_cast<int>(max_influences))
    return failure(ErrorKind::usage, "--influences {}: expected 1 to {}", words.influences, max_influences);
  if (words.smooth < 0 || words.smooth > 1000)
    return failure(ErrorKind::usage, "--smooth {}: expected 0 to 1000", words.smooth);
  if (!(words.prune >= 0.0 && words.prune < 1.0))
    return failure(ErrorKind::usage, "--prune {}: expected 0 or more, below 1", words.prune);
  if (!words.mirror.empty() && words.mirror != "left" && words.mirror != "right")
    return failure(ErrorKind::usage, "--mirror {}: expected left or right", words.mirror);
  edits.influences = static_cast<std::size_t>(words.influences);
  edits.smooth = words.smooth;
  edits.prune = words.prune;
  if (!words.mirror.empty()) edits.mirror = words.mirror == "left" ? BodySide::left : BodySide::right;
  return edits;
}

}  // namespace sinew::tools
