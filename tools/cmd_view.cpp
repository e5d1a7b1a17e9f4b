#include <iostream>

#include <spdlog/spdlog.h>

#include "engine/view/viewer.h"
#include "tools/command.h"
#include "tools/shader_build.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  SceneWords scene;
  std::optional<std::string> size;
  int samples = 1;
  std::optional<int> shown;
  bool uncapped = false;
  std::optional<std::string> shaders;
};

Result<ViewerOptions> viewer_options(const Words& words) {
  ViewerOptions options;
  auto scene = scene_options(words.scene);
  if (!scene) return pass_on(std::move(scene));
  options.scene = std::move(*scene);
  auto size = parse_size(words.size.value_or("1280x720"));
  if (!size) return pass_on(std::move(size));
  options.look.size = *size;
  if (auto ok = check_samples(words.samples); !ok) return pass_on(std::move(ok));
  options.look.samples = words.samples;
  if (words.shown && (*words.shown < 1 || *words.shown > 1'000'000))
    return failure(ErrorKind::usage, "--frames {}: expected 1 to 1,000,000 frames to show", *words.shown);
  options.frames = words.shown.value_or(0);
  options.uncapped = words.uncapped;
  options.size_given = words.size.has_value();
  options.device = {words.common.device, words.common.validate};
  options.shaders = shader_build();
  if (words.shaders) options.shaders.folder = *words.shaders;
  return options;
}

Result<void> run_view(const Words& words) {
  apply_verbosity(words.common);
  const auto options = viewer_options(words);
  if (!options) return tl::unexpected<Error>(options.error());
  if (words.shaders && !std::filesystem::is_directory(*words.shaders))
    return bad_input("--shaders {}: expected a folder", *words.shaders);
  auto system = WindowSystem::start();
  if (!system) return pass_on(std::move(system));
  auto device = open_device(words.common, system->surface_extensions());
  if (!device) return pass_on(std::move(device));
  const auto report = view(*system, *device, *options);
  if (!report) return tl::unexpected<Error>(report.error());
  log_problems(report->problems);
  const double rate = report->seconds > 0.0 ? report->frames / report->seconds : 0.0;
  if (words.common.json)
    print_json({{"device", device_json(device->info())},
                {"frames", report->frames},
                {"size", {report->size.width, report->size.height}},
                {"seconds", report->seconds},
                {"fps", rate},
                {"frame", {{"median", report->median_ms}, {"p95", report->p95_ms}}}});
  else if (words.shown)
    std::cout << fmt::format("{} frames in {:.2f} s: {:.1f} a second\n", report->frames, report->seconds, rate);
  return check_validation(*device);
}

}  // namespace

void add_view(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("view", "The window: look at a scene, play it, edit it");
  command->footer("Example: sinew view character.glb\nIn the window: F1 lists the keys.");
  auto words = std::make_shared<Words>();
  add_stage_options(*command, words->scene);
  command->add_option("--size", words->size, "WIDTHxHEIGHT of the window (as it was last, at first 1280x720)");
  command->add_option("--samples", words->samples, "1 or 4 samples a pixel (1)");
  command->add_option("--frames", words->shown, "Show so many frames, then end");
  command->add_flag("--uncapped", words->uncapped, "As fast as they come, for measurements");
  if (shader_build().compile)
    command->add_option("--shaders", words->shaders,
                        "Folder of shaders, compiled anew when they change (the source's)");
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return run_view(*words); }; });
}

}  // namespace sinew::tools
