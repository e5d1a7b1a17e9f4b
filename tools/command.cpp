#include "tools/command.h"

#include <iostream>

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "engine/app/options.h"
#include "engine/core/files.h"
#include "engine/core/frame_range.h"

namespace sinew::tools {

void add_common_options(CLI::App& command, CommonOptions& options) {
  command.add_flag("--json", options.json, "Print one JSON object on stdout");
  command.add_flag("--quiet", options.quiet, "Log errors only");
  command.add_flag("--verbose", options.verbose, "Log more");
  command.add_option("--progress", options.progress, "Progress on stderr: auto, bar, plain or none")
      ->capture_default_str();
  command.add_option("--device", options.device, "Vulkan device: its index, or a part of its name")
      ->envname("SINEW_DEVICE");
  command.add_flag("--validate", options.validate, "Run with Vulkan's validation layer; any message is an error");
}

void add_scene_options(CLI::App& command, SceneWords& words) {
  add_stage_options(command, words);
  auto* frame = command.add_option("--frame", words.frame, "One frame");
  command.add_option("--frames", words.frames, "Frames: 0-47, 0-99:5 or 1,3,7-9")->excludes(frame);
}

void add_stage_options(CLI::App& command, SceneWords& words) {
  command.add_option("scene", words.scene, "A scene file, a .glb or .gltf, or nothing for the embedded scene");
  command.add_option("--deformer", words.deformer, "How vertices follow the joints: rigid or ssd")
      ->capture_default_str();
  command.add_option("--bulge", words.bulge, "Muscles: on, off or paper (keeps the step at the region's edge)")
      ->capture_default_str();
  command
      .add_option("--pose", words.poses, "JOINT=x,y,z: turn a joint from its rest pose about the model's axes, degrees")
      ->allow_extra_args(false);
  command.add_option("--clip", words.clip, "The model's own animation: its name, its index, or none");
  command.add_option("--fps", words.fps, "Frames a second, in place of the scene's");
  command.add_option("--strength", words.strength, "Of all muscles, 0 to 1")->capture_default_str();
  command.add_option("--library", words.library, "Motion library");
}

void add_look_options(CLI::App& command, LookWords& words) {
  command.add_option("--size", words.size, "Picture size")->capture_default_str();
  command.add_option("--samples", words.samples, "Samples a pixel: 1 or 4")->capture_default_str();
  command.add_option("--view", words.view, "front, back, left, right, top or three-quarter");
  command.add_option("--orbit", words.orbit, "Degrees that the camera turns, counter-clockwise seen from above");
  command.add_option("--shading", words.shading, "lit, flat, clay, normals, weights, bulge or depth");
  command.add_option("--joint", words.joint, "Whose weights --shading weights shows");
  command.add_option("--shadows", words.shadows, "on or off: shadows of the key light");
  command.add_option("--floor", words.floor, "on or off: a floor that shows shadows");
  command.add_option("--background", words.background, "A colour such as #d8d8d8, or transparent");
}

Result<SceneOptions> scene_options(const SceneWords& words) {
  SceneOptions options;
  if (words.scene && words.scene->empty())
    return failure(ErrorKind::usage, "the scene's name is empty; name a file, or leave it out for the embedded scene");
  options.scene = words.scene.value_or("");
  if (const auto& range = words.frame ? words.frame : words.frames) {
    auto frames = parse_frame_range(*range);
    if (!frames)
      return failure(ErrorKind::usage, "{} {}: {}", words.frame ? "--frame" : "--frames", *range,
                     frames.error().message);
    if (words.frame && frames->size() != 1)
      return failure(ErrorKind::usage, "--frame {}: expected one frame; several go with --frames", *words.frame);
    options.frames = std::move(*frames);
  }
  auto deformer = parse_deformer(words.deformer);
  if (!deformer) return pass_on(std::move(deformer));
  options.deformer = *deformer;
  auto bulge = parse_bulge(words.bulge);
  if (!bulge) return pass_on(std::move(bulge));
  options.bulge = *bulge;
  for (const std::string& text : words.poses) {
    auto pose = parse_pose(text);
    if (!pose) return pass_on(std::move(pose));
    options.poses.push_back(std::move(*pose));
  }
  if (!words.clip.empty()) options.clip = parse_clip(words.clip);
  if (words.fps && !(*words.fps > 0.0 && *words.fps <= 1000.0))
    return failure(ErrorKind::usage, "--fps {}: expected a number above 0, up to 1000", *words.fps);
  options.fps = words.fps;
  if (!(words.strength >= 0.0 && words.strength <= 1.0))
    return failure(ErrorKind::usage, "--strength {}: expected a number from 0 to 1", words.strength);
  options.strength = words.strength;
  options.library = words.library;
  return options;
}

Result<ProgressStyle> progress_style(const CommonOptions& options) {
  if (options.quiet || options.progress == "none") return ProgressStyle::none;
  if (options.progress == "auto") return ProgressStyle::automatic;
  if (options.progress == "bar") return ProgressStyle::bar;
  if (options.progress == "plain") return ProgressStyle::plain;
  return failure(ErrorKind::usage, "--progress {}: expected auto, bar, plain or none", options.progress);
}

void apply_verbosity(const CommonOptions& options) {
  static const auto logger = spdlog::stderr_color_st("sinew");
  spdlog::set_default_logger(logger);
  spdlog::set_pattern("%^%l%$: %v");
  spdlog::set_level(options.quiet ? spdlog::level::err : options.verbose ? spdlog::level::debug : spdlog::level::info);
}

Result<Device> open_device(const CommonOptions& options, const std::vector<std::string>& surface_extensions) {
  auto device = Device::create({options.device, options.validate, surface_extensions});
  if (!device) return device;
  const DeviceInfo& info = device->info();
  spdlog::info("device: {} (Vulkan {}, {}){}", info.name, info.api, info.driver,
               info.cpu ? "; it is a CPU, expect CPU speed" : "");
  return device;
}

Result<Opened> open_scene(const SceneOptions& scene, const CommonOptions& common, bool with_device) {
  auto stage = open_stage(scene);
  if (!stage) return pass_on(std::move(stage));
  log_problems(stage->problems);
  Opened opened{nullptr, std::move(*stage)};
  if (!with_device) return opened;
  auto device = open_device(common);
  if (!device) return pass_on(std::move(device));
  opened.device = std::make_unique<Device>(std::move(*device));
  return opened;
}

nlohmann::ordered_json device_json(const DeviceInfo& info) {
  return {{"name", info.name}, {"type", info.type}, {"api", info.api}, {"driver", info.driver}};
}

void print_json(const nlohmann::ordered_json& json) {
  std::cout << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
}

Result<void> check_validation(const Device& device) {
  const std::vector<std::string> messages = device.validation_messages();
  if (messages.empty()) return {};
  return failure(ErrorKind::check_failed, "{} messages from the validation layer:\n{}", messages.size(),
                 fmt::join(messages, "\n"));
}

void log_problems(const std::vector<std::string>& problems) {
  for (const std::string& problem : problems) spdlog::warn("{}", problem);
}

}  // namespace sinew::tools
