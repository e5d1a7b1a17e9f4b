#include <iostream>

#include "engine/app/bind_mesh.h"
#include "tools/weight_words.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  WeightWords weights{.influences = 4, .prune = 0.01};
  std::string mesh, skeleton, output;
  int resolution = 192;
  std::vector<std::string> left_out;
};

Result<AutomaticWeightOptions> bind_options(const Words& words, const WeightEdits& edits) {
  AutomaticWeightOptions options;
  if (words.resolution < 16 || words.resolution > 384)
    return failure(ErrorKind::usage, "--resolution {}: expected 16 to 384", words.resolution);
  options.influences = edits.influences;
  options.resolution = words.resolution;
  options.prune = edits.prune;
  options.left_out = words.left_out;
  auto progress = progress_style(words.common);
  if (!progress) return pass_on(std::move(progress));
  options.progress = *progress;
  return options;
}

nlohmann::ordered_json report_json(const std::string& file, const AutomaticWeightReport& report) {
  return {{"file", file},
          {"vertices", report.vertices},
          {"joints", report.joints},
          {"max_influences", report.max_influences},
          {"outside", report.outside},
          {"idle", report.idle},
          {"far_vertices", report.far},
          {"farthest",
           {{"vertex", report.farthest}, {"mesh", report.farthest_mesh}, {"distance", report.farthest_distance}}},
          {"height", report.height},
          {"ms", report.milliseconds}};
}

Result<void> bind(const Words& words) {
  apply_verbosity(words.common);
  const auto edits = weight_edits(words.weights);
  if (!edits) return tl::unexpected<Error>(edits.error());
  const auto weights = bind_options(words, *edits);
  if (!weights) return tl::unexpected<Error>(weights.error());
  std::vector<std::string> problems;
  const auto bound =
      bind_mesh({words.mesh, words.skeleton, words.output, words.weights.from, *weights, *edits}, problems);
  log_problems(problems);
  if (!bound) return tl::unexpected<Error>(bound.error());
  const AutomaticWeightReport& report = *bound;
  if (words.common.json)
    print_json(report_json(words.output, report));
  else
    std::cout << fmt::format("{}: {} vertices follow {} joints, at most {} each, {:.0f} ms\n", words.output,
                             report.vertices, report.joints - report.outside.size() - report.idle.size(),
                             report.max_influences, report.milliseconds);
  return {};
}

}  // namespace

void add_bind(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("bind", "Skin weights for a mesh that has none");
  command->footer(
      "Examples: sinew bind statue.obj hero.glb -o statue.glb\n"
      "          sinew bind coat.glb hero.glb --from hero.glb -o coat_on_hero.glb");
  auto words = std::make_shared<Words>();
  command->add_option("mesh", words->mesh, "The mesh: .obj, .ply, .glb, .gltf or .vrm; weights it may have are ignored")
      ->required();
  command->add_option("skeleton", words->skeleton, "glTF file whose joints stand in the mesh at rest")->required();
  command->add_option("-o,--output", words->output, "x.glb")->required();
  add_weight_options(*command, words->weights);
  command->add_option("--resolution", words->resolution, "Voxels along the longest side, 16 to 384")
      ->capture_default_str();
  command->add_option("--leave-out", words->left_out, "A joint that shall move nothing; repeatable")
      ->allow_extra_args(false);
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return bind(*words); }; });
}

}  // namespace sinew::tools
