#pragma once
/// What every command of the program shares: how it is registered, what it says and how it ends.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "engine/app/options.h"
#include "engine/app/stage.h"
#include "engine/core/fresh_output.h"
#include "engine/core/progress.h"
#include "engine/gpu/device.h"

namespace sinew::tools {

/// Options that every command has; those of the device mean nothing to commands that need none.
struct CommonOptions {
  bool json = false;
  bool quiet = false;
  bool verbose = false;
  bool validate = false;
  std::string device;
  std::string progress = "auto";
};

/// The words of the scene options, as typed.
struct SceneWords {
  std::optional<std::string> scene;
  std::optional<std::string> frame, frames;
  std::string deformer = "ssd", bulge = "on", clip, library;
  std::vector<std::string> poses;
  std::optional<double> fps;
  double strength = 1.0;
};

/// The words of the look options, as typed.
struct LookWords {
  std::string size = "1280x720", view, shading, joint, shadows, floor, background;
  int samples = 1;
  std::optional<double> orbit;
};

/// A command: its parser, filled in by its file, and what runs once the words are parsed.
using Run = std::function<Result<void>()>;

void add_common_options(CLI::App& command, CommonOptions& options);
void add_scene_options(CLI::App& command, SceneWords& words);
/// Those of them that do not choose frames.
void add_stage_options(CLI::App& command, SceneWords& words);
void add_look_options(CLI::App& command, LookWords& words);

/// Each fails as usage, without having opened a file.
Result<SceneOptions> scene_options(const SceneWords& words);
Result<ProgressStyle> progress_style(const CommonOptions& options);

/// Sets what is logged to stderr.
void apply_verbosity(const CommonOptions& options);

/// The device that was asked for, named in the log; with `surface_extensions` one that shows pictures in windows. Fails
/// as no_device.
Result<Device> open_device(const CommonOptions& options, const std::vector<std::string>& surface_extensions = {});

/// What most commands work on. The device outlives what is made on it.
struct Opened {
  std::unique_ptr<Device> device;  ///< null where none was asked for
  Stage stage;
};

/// Opens the scene, logs what was repaired in it, and then, where `with_device`, the device.
Result<Opened> open_scene(const SceneOptions& scene, const CommonOptions& common, bool with_device = true);

nlohmann::ordered_json device_json(const DeviceInfo& info);

/// Prints one JSON object on stdout.
void print_json(const nlohmann::ordered_json& json);

/// Fails as check_failed where the validation layer had something to say.
Result<void> check_validation(const Device& device);

/// Logs what was repaired or left out.
void log_problems(const std::vector<std::string>& problems);

// The commands. Each registers itself and hands `run` what to do when it is chosen.
void add_render(CLI::App& program, Run& run);
void add_info(CLI::App& program, Run& run);
void add_parity(CLI::App& program, Run& run);
void add_export(CLI::App& program, Run& run);
void add_bench(CLI::App& program, Run& run);
void add_muscles(CLI::App& program, Run& run);
void add_compare(CLI::App& program, Run& run);
void add_figure(CLI::App& program, Run& run);
void add_motion(CLI::App& program, Run& run);
void add_head(CLI::App& program, Run& run);
void add_fit_skin(CLI::App& program, Run& run);
void add_view(CLI::App& program, Run& run);
void add_bind(CLI::App& program, Run& run);
void add_weights(CLI::App& program, Run& run);

}  // namespace sinew::tools
