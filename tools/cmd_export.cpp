#include <spdlog/spdlog.h>

#include "engine/app/bake.h"
#include "tools/command.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  SceneWords scene;
  std::string output, by = "gpu";
  bool rig = false;
  std::vector<std::string> meta;
};

Result<BakeOptions> bake_options(const Words& words) {
  BakeOptions options;
  auto scene = scene_options(words.scene);
  if (!scene) return pass_on(std::move(scene));
  options.scene = std::move(*scene);
  auto progress = progress_style(words.common);
  if (!progress) return pass_on(std::move(progress));
  options.progress = *progress;
  options.output = words.output;
  if (words.by != "gpu" && words.by != "cpu")
    return failure(ErrorKind::usage, "--by {}: expected gpu or cpu", words.by);
  options.by_cpu = words.by == "cpu";
  options.rig = words.rig;
  for (const std::string& word : words.meta)
    if (auto ok = add_vrm_meta(options.vrm, word); !ok) return pass_on(std::move(ok));
  if (auto ok = check_mesh_name(options); !ok) return pass_on(std::move(ok));
  return options;
}

Result<void> export_mesh(const Words& words) {
  apply_verbosity(words.common);
  auto options = bake_options(words);
  if (!options) return pass_on(std::move(options));
  auto opened = open_scene(options->scene, words.common, !options->by_cpu && !options->rig);
  if (!opened) return pass_on(std::move(opened));
  auto report = bake(opened->device.get(), opened->stage, *options);
  if (!report) return pass_on(std::move(report));
  if (words.common.json)
    print_json({{"file", options->output},
                {"frames", report->frames},
                {"vertices", report->vertices},
                {"triangles", report->triangles}});
  spdlog::info("{}: {} frames of {} vertices, {} triangles", options->output, report->frames, report->vertices,
               report->triangles);
  return opened->device ? check_validation(*opened->device) : Result<void>();
}

}  // namespace

void add_export(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("export", "The deformed mesh as .obj, .ply or .glb");
  command->footer("Example: sinew export character.glb --frame 12 -o posed.obj");
  auto words = std::make_shared<Words>();
  add_scene_options(*command, words->scene);
  command->add_option("-o,--output", words->output, "x.obj, x.ply, x.glb, or x_####.obj for several frames")
      ->required();
  command->add_option("--by", words->by, "Who makes the vertices: gpu or cpu")->capture_default_str();
  command->add_flag(
      "--rig", words->rig,
      "Write skeleton, weights and morph targets instead of deformed vertices (.glb, or .vrm in a T pose)");
  command->add_option("--meta", words->meta, "KEY=VALUE: of a .vrm, such as name=Figure or authors=Ada; repeatable")
      ->allow_extra_args(false);
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return export_mesh(*words); }; });
}

}  // namespace sinew::tools
