#include <spdlog/spdlog.h>

#include "engine/app/parity.h"
#include "tools/command.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  SceneWords scene;
  double tolerance = 1e-5, normal_tolerance = 0.1;
};

nlohmann::ordered_json report_json(const ParityReport& r, const Device& device, const ParityOptions& options) {
  return {{"device", device_json(device.info())},
          {"frames", r.frames},
          {"vertices", r.vertices},
          {"max_position_error", r.max_position_error},
          {"rms_position_error", r.rms_position_error},
          {"max_normal_error_degrees", r.max_normal_error_degrees},
          {"near_singular_normals", r.singular_normals},
          {"max_near_singular_normal_error_degrees", r.max_singular_normal_error_degrees},
          {"max_bulge_height_error", r.max_height_error},
          {"bbox_diagonal", r.bbox_diagonal},
          {"relative_error", r.relative_error},
          {"tolerance", options.tolerance},
          {"normal_tolerance_degrees", options.normal_tolerance_degrees},
          {"pass", r.pass}};
}

Result<void> parity(const Words& words) {
  apply_verbosity(words.common);
  ParityOptions options;
  auto scene = scene_options(words.scene);
  if (!scene) return pass_on(std::move(scene));
  options.scene = std::move(*scene);
  auto progress = progress_style(words.common);
  if (!progress) return pass_on(std::move(progress));
  options.progress = *progress;
  if (!(words.tolerance >= 0.0) || !(words.normal_tolerance >= 0.0))
    return failure(ErrorKind::usage, "--tolerance, --normal-tolerance: expected numbers of 0 or more");
  options.tolerance = words.tolerance;
  options.normal_tolerance_degrees = words.normal_tolerance;

  auto opened = open_scene(options.scene, words.common);
  if (!opened) return pass_on(std::move(opened));
  Device& device = *opened->device;
  const Stage& stage = opened->stage;
  auto report = compare_with_reference(device, stage, options);
  if (!report) return pass_on(std::move(report));
  if (words.common.json) print_json(report_json(*report, device, options));
  const std::string summary = fmt::format(
      "{} frames of {} vertices: relative position error {:.3g} (at most {:.3g}), normals {:.3g} degrees (at most "
      "{:.3g}), {} near-singular normals {:.3g} degrees",
      report->frames, report->vertices, report->relative_error, options.tolerance, report->max_normal_error_degrees,
      options.normal_tolerance_degrees, report->singular_normals, report->max_singular_normal_error_degrees);
  if (!report->pass) return failure(ErrorKind::check_failed, "parity failed: {}", summary);
  spdlog::info("parity holds: {}", summary);
  return check_validation(device);
}

}  // namespace

void add_parity(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("parity", "Compare the compute shader with the CPU reference, every vertex");
  command->footer("Example: sinew parity character.glb --frames 0-47 --bulge paper");
  auto words = std::make_shared<Words>();
  add_scene_options(*command, words->scene);
  command->add_option("--tolerance", words->tolerance, "Of the position error, as a share of the box's diagonal")
      ->capture_default_str();
  command->add_option("--normal-tolerance", words->normal_tolerance, "Of the normals, degrees")->capture_default_str();
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return parity(*words); }; });
}

}  // namespace sinew::tools
