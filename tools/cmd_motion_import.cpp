#include <iostream>

#include <spdlog/spdlog.h>

#include "engine/motion/library_import.h"
#include "tools/motion_command.h"

namespace sinew::tools {
namespace {

struct Words : MotionWords {
  std::vector<std::string> files;
  ImportOptions options;
};

Result<void> import_files(const Words& words) {
  apply_verbosity(words.common);
  ImportOptions options = words.options;
  if (auto ok = check_emotion(options.emotion); !ok) return ok;
  if (auto ok = check_tags(options.tags); !ok) return ok;
  if (!options.name.empty() && words.files.size() != 1)
    return failure(ErrorKind::usage, "--name {}: names one clip, and {} files are given", options.name,
                   words.files.size());
  const auto style = progress_style(words.common);
  if (!style) return tl::unexpected<Error>(style.error());
  options.progress = *style;
  auto library = open_library(words, true);
  if (!library) return pass_on(std::move(library));
  const std::vector<std::filesystem::path> files(words.files.begin(), words.files.end());
  const auto report = import_motions(*library, files, options);
  if (!report) return tl::unexpected<Error>(report.error());
  log_problems(report->problems);
  spdlog::info("{}: {} clips", library->file().string(), report->clips.size());
  if (words.common.json)
    print_json({{"library", library->file().string()}, {"clips", report->clips}, {"problems", report->problems}});
  else
    for (const std::string& clip : report->clips) std::cout << clip << '\n';
  return {};
}

}  // namespace

void add_motion_import(CLI::App& motion, Run& run) {
  auto* command = motion.add_subcommand("import", "Adds the motions of files to the library, all or none");
  command->footer("Example: sinew motion import laughs/*.bvh --tag laugh --emotion laugh --licence CC0-1.0");
  auto words = std::make_shared<Words>();
  command->add_option("files", words->files, "BVH, AMC (its ASF beside it), glTF, VRM or VRM animation files")
      ->required();
  command->add_option("--name", words->options.name, "The clip's name, where one file holds one motion");
  command->add_option("--tag", words->options.tags, "A word to find it by; repeatable")->allow_extra_args(false);
  command->add_option("--emotion", words->options.emotion, "The emotion that it shows, such as laugh");
  command->add_option("--source", words->options.source, "Where it comes from (the file's name)");
  command->add_option("--licence", words->options.licence, "Its terms");
  command->add_flag("--replace", words->options.replace, "Take the place of clips of the same name");
  add_motion_options(*command, *words);
  command->callback([words, &run] { run = [words] { return import_files(*words); }; });
}

}  // namespace sinew::tools
