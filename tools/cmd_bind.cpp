#include <iostream>

#include <spdlog/spdlog.h>

#include "engine/core/files.h"
#include "engine/core/interrupt.h"
#include "engine/core/text.h"
#include "engine/fit/automatic_weights.h"
#include "engine/fit/bound_model.h"
#include "engine/fit/weight_run.h"
#include "engine/io/gltf_write.h"
#include "engine/io/mesh_read.h"
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

void log_report(const AutomaticWeightReport& report) {
  if (!report.outside.empty())
    spdlog::warn("{} joints lie outside of the mesh and move nothing: {}", report.outside.size(),
                 fmt::join(report.outside, ", "));
  if (!report.idle.empty())
    spdlog::warn("{} joints got no vertex: {}", report.idle.size(), fmt::join(report.idle, ", "));
  if (report.far > 0)
    spdlog::warn("{} vertices are far from every bone, vertex {} of \"{}\" by {:.3g}", report.far, report.farthest,
                 report.farthest_mesh, report.farthest_distance);
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

/// After edits there may be other numbers.
void count_weights(const Model& bound, AutomaticWeightReport& report) {
  const SkinnedShape shape = skinned_shapes(bound).front();
  report.vertices = shape.positions.size();
  report.joints = bound.skins[0].joints.size();
  report.max_influences = most_influences(shape.influences);
}

Result<void> bind(const Words& words) {
  apply_verbosity(words.common);
  const auto edits = weight_edits(words.weights);
  if (!edits) return tl::unexpected<Error>(edits.error());
  const auto options = bind_options(words, *edits);
  if (!options) return tl::unexpected<Error>(options.error());
  if (lower(std::filesystem::path(words.output).extension().string()) != ".glb")
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .glb", words.output);
  const std::vector<std::string> inputs{words.mesh, words.skeleton, words.weights.from};
  if (auto ok = check_fresh_output(words.output, inputs); !ok) return ok;
  const auto mesh = read_mesh(words.mesh);
  if (!mesh) return tl::unexpected<Error>(mesh.error());
  log_problems(mesh->problems);
  const auto skeleton = read_mesh(words.skeleton);
  if (!skeleton) return tl::unexpected<Error>(skeleton.error());
  if (words.skeleton != words.mesh) log_problems(skeleton->problems);
  auto bound = bound_model(*mesh, *skeleton, {.keep_hung = true});
  if (!bound) return tl::unexpected<Error>(bound.error());
  AutomaticWeightReport report;
  if (words.weights.from.empty()) {
    auto made = set_automatic_weights(*options, *bound);
    if (!made) return pass_on(std::move(made));
    report = std::move(*made);
    log_report(report);
  } else if (auto ok = take_weights(words.weights.from, *bound); !ok) {
    return ok;
  }
  if (auto ok = edit_weights(*edits, *bound); !ok) return ok;
  count_weights(*bound, report);
  const auto bytes = rig_glb(*bound);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  if (auto ok = check_interrupt(); !ok) return ok;
  if (auto ok = write_file(words.output, *bytes); !ok) return ok;
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
