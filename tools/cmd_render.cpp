#include <cmath>

#include <spdlog/spdlog.h>

#include "engine/app/capture.h"
#include "tools/command.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  SceneWords scene;
  LookWords look;
  std::string output, shard, overlay, compare, compare_as, zoom, plot, sheet;
  std::optional<int> turntable;
  bool resume = false;
};

Result<LookOptions> look_options(const LookWords& words) {
  LookOptions look;
  auto size = parse_size(words.size);
  if (!size) return pass_on(std::move(size));
  look.size = *size;
  if (auto ok = check_samples(words.samples); !ok) return pass_on(std::move(ok));
  look.samples = words.samples;
  if (words.orbit && !std::isfinite(*words.orbit))
    return failure(ErrorKind::usage, "--orbit {}: expected a number of degrees", *words.orbit);
  look.orbit = words.orbit;
  const auto optional = [](const std::string& text, auto parse, auto& to) -> Result<void> {
    if (text.empty()) return {};
    auto value = parse(text);
    if (!value) return pass_on(std::move(value));
    to = *value;
    return {};
  };
  if (auto ok = optional(words.view, parse_view, look.view); !ok) return pass_on(std::move(ok));
  if (auto ok = optional(words.shading, parse_shading, look.shading); !ok) return pass_on(std::move(ok));
  if (look.shading == Shading::weights && words.joint.empty())
    return failure(ErrorKind::usage,
                   "--shading weights: whose? Name a joint with --joint, such as --joint leftLowerArm");
  look.joint = words.joint;
  const auto on_off = [](const char* option) {
    return [=](const std::string& text) { return parse_switch(option, text); };
  };
  if (auto ok = optional(words.shadows, on_off("--shadows"), look.shadows); !ok) return pass_on(std::move(ok));
  if (auto ok = optional(words.floor, on_off("--floor"), look.floor); !ok) return pass_on(std::move(ok));
  if (auto ok = optional(words.background, parse_background, look.background); !ok) return pass_on(std::move(ok));
  return look;
}

Result<FigureOptions> figure_options(const Words& words) {
  FigureOptions figure;
  if (!words.overlay.empty()) {
    auto overlay = parse_overlay(words.overlay);
    if (!overlay) return pass_on(std::move(overlay));
    figure.overlay = *overlay;
  }
  if (!words.sheet.empty()) {
    auto grid = parse_grid(words.sheet);
    if (!grid) return pass_on(std::move(grid));
    figure.sheet = *grid;
  }
  if (words.turntable && (*words.turntable < 1 || *words.turntable > 100'000))
    return failure(ErrorKind::usage, "--turntable {}: expected 1 to 100,000 pictures", *words.turntable);
  if (words.turntable && figure.sheet && figure.sheet != no_grid)
    return failure(ErrorKind::usage, "--turntable and --sheet: give one of them");
  figure.turntable = words.turntable.value_or(0);
  if (!words.compare.empty()) figure.compare = words.compare;
  if (!words.compare_as.empty()) {
    auto place = parse_comparison_place(words.compare_as);
    if (!place) return pass_on(std::move(place));
    figure.compare_as = *place;
  }
  if (!words.zoom.empty()) figure.zoom = words.zoom;
  if (!words.plot.empty()) {
    auto plot = parse_muscle_plot(words.plot);
    if (!plot) return pass_on(std::move(plot));
    figure.plot = *plot;
  }
  return figure;
}

Result<CaptureOptions> capture_options(const Words& words) {
  CaptureOptions options;
  auto scene = scene_options(words.scene);
  if (!scene) return pass_on(std::move(scene));
  options.scene = std::move(*scene);
  auto look = look_options(words.look);
  if (!look) return pass_on(std::move(look));
  options.look = *look;
  auto figure = figure_options(words);
  if (!figure) return pass_on(std::move(figure));
  options.figure = *figure;
  auto progress = progress_style(words.common);
  if (!progress) return pass_on(std::move(progress));
  options.progress = *progress;
  options.output = words.output;
  options.resume = words.resume;
  if (!words.shard.empty()) {
    auto shard = parse_shard(words.shard);
    if (!shard) return pass_on(std::move(shard));
    options.shard = *shard;
  }
  if (auto ok = check_output(options); !ok) return pass_on(std::move(ok));
  return options;
}

nlohmann::ordered_json report_json(const CaptureReport& report, const Device& device, const Stage& stage,
                                   const CaptureOptions& options) {
  nlohmann::ordered_json json;
  json["device"] = device_json(device.info());
  json["frames"] = nlohmann::ordered_json::array();
  for (const CapturedFrame& f : report.frames) {
    nlohmann::ordered_json frame{{"frame", f.frame}};
    if (!f.file.empty()) frame["file"] = f.file;
    frame.update({{"sha256", f.sha256}, {"ms", f.ms}, {"skipped", f.skipped}});
    json["frames"].push_back(std::move(frame));
  }
  if (!report.film.empty()) {
    json["file"] = report.film;
    json["sha256"] = report.film_sha256;
  }
  json["size"] = {options.look.size.width, options.look.size.height};
  json["fps"] = stage.scene.fps;
  return json;
}

void log_outcome(const CaptureReport& report) {
  const std::size_t count = report.frames.size();
  if (!report.film.empty()) {
    spdlog::info("{}: {} frames", report.film, count);
  } else if (count == 1) {
    spdlog::info("{} written", report.frames.front().file);
  } else if (count > 1) {
    spdlog::info("{} pictures: {} to {}", count, report.frames.front().file, report.frames.back().file);
  }
}

Result<void> render(const Words& words) {
  apply_verbosity(words.common);
  auto options = capture_options(words);
  if (!options) return pass_on(std::move(options));
  auto opened = open_scene(options->scene, words.common);
  if (!opened) return pass_on(std::move(opened));
  Device& device = *opened->device;
  const Stage& stage = opened->stage;
  auto report = capture(device, stage, *options);
  if (!report) return pass_on(std::move(report));
  log_problems(report->problems);
  log_outcome(*report);
  if (words.common.json) print_json(report_json(*report, device, stage, *options));
  return check_validation(device);
}

}  // namespace

void add_render(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("render", "Pictures without a window");
  command->footer("Example: sinew render arm.glb --pose leftLowerArm=0,-90,0 --view left -o arm.png");
  auto words = std::make_shared<Words>();
  add_scene_options(*command, words->scene);
  command
      ->add_option("-o,--output", words->output,
                   "x.png, x_####.png for several frames, or a film: x.mp4, x.webm, x.gif")
      ->required();
  add_look_options(*command, words->look);
  command->add_option(
      "--overlay", words->overlay,
      "Drawn over the picture, by commas: wire or wire-all, skeleton, bones, muscles, arrows, projection, box, axes; "
      "of a face guides, regions");
  command->add_option(
      "--compare", words->compare,
      "Panels side by side: bulge, deformer, overlay, another view such as left, or another scene or model");
  command->add_option("--compare-as", words->compare_as, "panels, or inset: the second panel at the lower right");
  command->add_option("--zoom", words->zoom, "An inset near this joint or muscle, at the upper right");
  command->add_option("--plot", words->plot,
                      "A diagram beside the picture: angle (the muscles' heights by it) or profile (along the limb)");
  command->add_option("--sheet", words->sheet,
                      "COLUMNSxROWS: that many of the frames in one picture; none: not the scene's");
  command->add_option("--turntable", words->turntable, "So many pictures round the first selected frame");
  command->add_option("--shard", words->shard, "I/N: the I-th (from 0) of N contiguous parts of the frames");
  command->add_flag("--resume", words->resume, "Keep frames that an earlier run of the same recipe wrote whole");
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return render(*words); }; });
}

}  // namespace sinew::tools
