#include <spdlog/spdlog.h>

#include "engine/app/motion_export.h"
#include "engine/core/files.h"
#include "engine/core/text.h"
#include "tools/motion_command.h"

namespace sinew::tools {
namespace {

struct Words : MotionWords {
  std::string clip, output;
  std::optional<std::string> model;
  bool samples = false;
};

Result<void> export_clip(const Words& words) {
  apply_verbosity(words.common);
  const std::string extension = lower(std::filesystem::path(words.output).extension().string());
  if (extension != ".bvh" && extension != ".vrma" && extension != ".glb")
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .bvh, .vrma or .glb", words.output);
  if (extension == ".glb" && !words.model)
    return failure(ErrorKind::usage, "-o {}: an animation needs a body; name it with --model", words.output);
  if (auto ok = check_writable(words.output); !ok) return ok;
  const auto library = open_library(words, false);
  if (!library) return tl::unexpected<Error>(library.error());
  const auto clip = library->load(words.clip);
  if (!clip) return tl::unexpected<Error>(clip.error());
  const Motion motion =
      clip->curves && !words.samples ? sampled_motion(*clip->curves, clip->motion.skeleton, words.clip) : clip->motion;
  std::optional<std::filesystem::path> model;
  if (words.model) model = *words.model;
  if (auto ok = export_motion(motion, words.output, model); !ok) return ok;
  if (words.common.json)
    print_json({{"file", words.output}, {"clip", words.clip}, {"frames", motion.frames.size()}});
  else
    spdlog::info("{}: {} frames", words.output, motion.frames.size());
  return {};
}

}  // namespace

void add_motion_export(CLI::App& motion, Run& run) {
  auto* command = motion.add_subcommand("export", "A clip as BVH, VRM animation, or an animation of a model");
  command->footer("Example: sinew motion export walk --model builtin:woman -o walk.glb");
  auto words = std::make_shared<Words>();
  command->add_option("clip", words->clip, "The clip's name")->required();
  command->add_option("-o,--output", words->output, "x.bvh, x.vrma or x.glb")->required();
  command->add_option("--model", words->model, "The body of a .glb: a glTF file, or a built-in model's name");
  command->add_flag("--samples", words->samples, "The samples as they were imported, not the fitted curves");
  add_motion_options(*command, *words);
  command->callback([words, &run] { run = [words] { return export_clip(*words); }; });
}

}  // namespace sinew::tools
