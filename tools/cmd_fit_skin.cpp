#include <algorithm>
#include <iostream>

#include <spdlog/spdlog.h>

#include "engine/core/files.h"
#include "engine/core/frame_range.h"
#include "engine/core/interrupt.h"
#include "engine/core/text.h"
#include "engine/fit/example_fit.h"
#include "engine/fit/round_trip.h"
#include "engine/io/gltf_read.h"
#include "engine/io/gltf_write.h"
#include "tools/command.h"
#include "tools/fit_report.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  std::string rest, poses_from, output, method = "convex", bones = "known", skeleton, clip;
  std::vector<std::string> poses;
  std::optional<std::string> frames;
  std::optional<int> random_poses, count;
  int influences = 4, test_poses = 0;
  std::int64_t seed = 1;
  double noise = 0.0, fps = 24.0;
};

constexpr int most_poses = most_example_poses;
constexpr int most_bones = 1000;

/// What both ways to come by poses share.
Result<FitOptions> fit_options(const Words& words) {
  FitOptions options;
  if (words.influences < 1 || words.influences > static_cast<int>(max_influences))
    return failure(ErrorKind::usage, "--influences {}: expected 1 to {}", words.influences, max_influences);
  if (words.method != "paper" && words.method != "convex")
    return failure(ErrorKind::usage, "--method {}: expected paper or convex", words.method);
  if (words.bones != "known" && words.bones != "unknown")
    return failure(ErrorKind::usage, "--bones {}: expected known or unknown", words.bones);
  options.method = words.method == "paper" ? FitMethod::paper : FitMethod::convex;
  options.influences = static_cast<std::size_t>(words.influences);
  auto progress = progress_style(words.common);
  if (!progress) return pass_on(std::move(progress));
  options.progress = *progress;
  return options;
}

/// The words that mean nothing beside others.
Result<void> check_company(const Words& words) {
  if (words.poses_from.empty() && words.poses.empty())
    return failure(ErrorKind::usage, "no poses; expected files, or --poses-from CHARACTER --random-poses K");
  if (!words.poses_from.empty() && !words.poses.empty())
    return failure(ErrorKind::usage, "{}: with --poses-from no poses are given", words.poses.front());
  const bool files = words.poses_from.empty(), unknown = words.bones == "unknown";
  const std::pair<const char*, bool> for_characters[] = {{"--random-poses", words.random_poses.has_value()},
                                                         {"--test-poses", words.test_poses != 0},
                                                         {"--noise", words.noise != 0.0}};
  for (const auto& [option, used] : for_characters)
    if (files && used) return failure(ErrorKind::usage, "{}: goes with --poses-from, not with files", option);
  const std::pair<const char*, bool> for_files[] = {{"--skeleton", !words.skeleton.empty()},
                                                    {"--clip", !words.clip.empty()},
                                                    {"--frames", words.frames.has_value()},
                                                    {"--bones unknown", unknown}};
  for (const auto& [option, used] : for_files)
    if (!files && used)
      return failure(ErrorKind::usage, "{}: goes with poses from files, not with --poses-from", option);
  if (unknown && !words.skeleton.empty())
    return failure(ErrorKind::usage, "--skeleton: with --bones unknown there is none");
  if (unknown && words.method == "paper")
    return failure(ErrorKind::usage, "--method paper: needs bones; expected convex with --bones unknown");
  if (unknown != words.count.has_value()) return failure(ErrorKind::usage, "--bones unknown and --count B go together");
  return {};
}

Result<RoundTripOptions> round_trip_options(const Words& words, const FitOptions& fit) {
  RoundTripOptions options;
  static_cast<FitOptions&>(options) = fit;
  if (!words.random_poses)
    return failure(ErrorKind::usage, "--poses-from {}: expected --random-poses K beside it", words.poses_from);
  if (*words.random_poses < 1 || *words.random_poses > most_poses)
    return failure(ErrorKind::usage, "--random-poses {}: expected 1 to {}", *words.random_poses, most_poses);
  if (words.test_poses < 0 || words.test_poses > most_poses)
    return failure(ErrorKind::usage, "--test-poses {}: expected 0 to {}", words.test_poses, most_poses);
  if (!(words.noise >= 0.0 && words.noise <= 1000.0))
    return failure(ErrorKind::usage, "--noise {}: expected millimetres, 0 to 1000", words.noise);
  options.poses = static_cast<std::size_t>(*words.random_poses);
  options.test_poses = static_cast<std::size_t>(words.test_poses);
  options.seed = static_cast<std::uint64_t>(words.seed);
  options.noise = words.noise;
  return options;
}

Result<ExampleFitOptions> example_options(const Words& words, const FitOptions& fit) {
  ExampleFitOptions options;
  static_cast<FitOptions&>(options) = fit;
  options.rest = words.rest;
  options.skeleton = words.skeleton;
  options.poses.files.assign(words.poses.begin(), words.poses.end());
  if (!words.clip.empty()) {
    options.clip = parse_clip(words.clip);
    options.poses.clip = words.clip;
    if (std::holds_alternative<NoClip>(options.clip))
      return failure(ErrorKind::usage, "--clip none: expected the clip that says where the bones are");
  }
  if (words.frames) {
    auto frames = parse_frame_range(*words.frames);
    if (!frames) return failure(ErrorKind::usage, "--frames {}: {}", *words.frames, frames.error().message);
    options.poses.frames = std::move(*frames);
  }
  if (!(words.fps > 0.0 && words.fps <= 1000.0))
    return failure(ErrorKind::usage, "--fps {}: expected a number above 0, up to 1000", words.fps);
  options.poses.fps = words.fps;
  if (words.count && (*words.count < 1 || *words.count > most_bones))
    return failure(ErrorKind::usage, "--count {}: expected 1 to {}", *words.count, most_bones);
  if (words.count) options.unknown_bones = static_cast<std::size_t>(*words.count);
  return options;
}

Result<void> check_output(const Words& words) {
  if (lower(std::filesystem::path(words.output).extension().string()) != ".glb")
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .glb", words.output);
  std::vector<std::string> inputs{words.rest, words.poses_from, words.skeleton};
  inputs.insert(inputs.end(), words.poses.begin(), words.poses.end());
  return check_fresh_output(words.output, inputs);
}

Result<ExampleFit> fit_round(const Words& words, const RoundTripOptions& options) {
  auto rest = read_gltf(words.rest);
  if (!rest) return pass_on(std::move(rest));
  log_problems(rest->problems);
  const bool same = words.rest == words.poses_from;
  auto character = same ? rest : read_gltf(words.poses_from);
  if (!character) return pass_on(std::move(character));
  if (!same) log_problems(character->problems);
  auto report = fit_round_trip(*character, options, *rest);
  if (!report) return pass_on(std::move(report));
  return ExampleFit{std::move(*rest), std::move(*report)};
}

Result<void> fit_skin(const Words& words) {
  apply_verbosity(words.common);
  const auto fit = fit_options(words);
  if (!fit) return tl::unexpected<Error>(fit.error());
  if (auto ok = check_company(words); !ok) return ok;
  std::function<Result<ExampleFit>()> work;
  if (words.poses_from.empty()) {
    const auto options = example_options(words, *fit);
    if (!options) return tl::unexpected<Error>(options.error());
    work = [options = *options] { return fit_examples(options); };
  } else {
    const auto options = round_trip_options(words, *fit);
    if (!options) return tl::unexpected<Error>(options.error());
    work = [&words, options = *options] { return fit_round(words, options); };
  }
  if (auto ok = check_output(words); !ok) return ok;
  const auto fitted = work();
  if (!fitted) return tl::unexpected<Error>(fitted.error());
  for (const std::string& reason : fitted->report.reasons) spdlog::warn("{}", reason);
  const auto bytes = rig_glb(fitted->model);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  if (auto ok = check_interrupt(); !ok) return ok;
  if (auto ok = write_file(words.output, *bytes); !ok) return ok;
  const std::string_view method = words.bones == "unknown" ? "rigid bones" : words.method;
  if (words.common.json)
    print_json(fit_report_json(words.output, method, fitted->report, words.test_poses > 0));
  else
    print_fit_report(words.output, fitted->report, words.test_poses > 0);
  return {};
}

}  // namespace

void add_fit_skin(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("fit-skin", "Skin weights from example poses");
  command->footer(
      "Examples: sinew fit-skin rest.obj pose_0*.obj --skeleton hero.glb --clip Walk -o fit.glb\n"
      "          sinew fit-skin rest.obj baked.glb --bones unknown --count 20 -o found.glb\n"
      "          sinew fit-skin hero.glb --poses-from hero.glb --random-poses 20 --test-poses 10 -o fit.glb");
  auto words = std::make_shared<Words>();
  command->add_option("rest", words->rest, "The mesh at rest: .obj, .ply, .glb, .gltf or .vrm")->required();
  command->add_option("poses", words->poses, ".obj and .ply files, a pose each, or one animated glTF file");
  command->add_option("-o,--output", words->output, "x.glb")->required();
  command->add_option("--poses-from", words->poses_from, "A skinned character that poses for the examples");
  command->add_option("--random-poses", words->random_poses, "So many poses at random angles");
  command->add_option("--test-poses", words->test_poses, "So many more, to test the fit in")->capture_default_str();
  command->add_option("--seed", words->seed, "Of the random angles and of the noise")->capture_default_str();
  command->add_option("--noise", words->noise, "Sigma of noise on the examples, a coordinate, millimetres")
      ->capture_default_str();
  command->add_option("--influences", words->influences, "At most so many bones a vertex, 1 to 8")
      ->capture_default_str();
  command->add_option("--method", words->method, "convex, or paper: bones by lone errors, weights by SVD")
      ->capture_default_str();
  command->add_option(
      "--skeleton", words->skeleton,
      "glTF file with the bones and the clip that moves them; else the animated poses or the rest file");
  command->add_option("--clip", words->clip, "The skeleton's clip: its name or index; its first");
  command->add_option("--frames", words->frames, "Where in the clip the poses stand: 0-47, 0-99:5 or 1,3,7-9");
  command->add_option("--fps", words->fps, "Frames a second")->capture_default_str();
  command->add_option("--bones", words->bones, "known, or unknown: bones are found too")->capture_default_str();
  command->add_option("--count", words->count, "So many bones to find");
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return fit_skin(*words); }; });
}

}  // namespace sinew::tools
