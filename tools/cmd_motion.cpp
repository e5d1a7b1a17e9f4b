#include <algorithm>

#include "engine/core/text.h"
#include "engine/model/scene_words.h"
#include "tools/motion_command.h"

namespace sinew::tools {

void add_motion_options(CLI::App& command, MotionWords& words) {
  command.add_option("--library", words.library, fmt::format("The motion library ({})", default_library().string()));
  add_common_options(command, words.common);
}

Result<MotionLibrary> open_library(const MotionWords& words, bool write) {
  return MotionLibrary::open(library_or_default(words.library), write);
}

nlohmann::ordered_json entry_json(const ClipEntry& entry) {
  nlohmann::ordered_json json{{"name", entry.name},     {"frames", entry.frames}, {"duration", entry.duration()},
                              {"joints", entry.joints}, {"tags", entry.tags},     {"emotion", nullptr},
                              {"fitted", entry.fitted}, {"source", entry.source}, {"licence", entry.licence}};
  if (!entry.emotion.empty()) json["emotion"] = entry.emotion;
  if (!entry.parent.empty()) json["parent"] = entry.parent;
  return json;
}

Result<void> check_emotion(const std::string& emotion) {
  const auto known = expression_names();
  if (emotion.empty() || std::find(known.begin(), known.end(), emotion) != known.end()) return {};
  return failure(ErrorKind::usage, "--emotion {}: expected one of {}{}", emotion, fmt::join(known, ", "),
                 did_you_mean(emotion, known));
}

Result<void> check_tags(const std::vector<std::string>& tags) {
  for (const std::string& tag : tags)
    if (tag.empty() || tag.find(',') != std::string::npos)
      return failure(ErrorKind::usage, "--tag {}: expected a word without commas; the option repeats", tag);
  return {};
}

void add_motion(CLI::App& program, Run& run) {
  auto* motion = program.add_subcommand("motion", "The motion library: import, list, show, fit, edit, plot, export");
  motion->require_subcommand(1);
  motion->footer(
      "Example: sinew motion import walk.bvh --tag neutral && sinew motion fit walk --tolerance 0.5 && "
      "sinew motion plot walk --joint leftUpperLeg --axis x -o walk.svg");
  add_motion_import(*motion, run);
  add_motion_list(*motion, run);
  add_motion_show(*motion, run);
  add_motion_fit(*motion, run);
  add_motion_edit(*motion, run);
  add_motion_plot(*motion, run);
  add_motion_export(*motion, run);
}

}  // namespace sinew::tools
