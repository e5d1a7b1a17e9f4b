#include <algorithm>
#include <iostream>

#include <spdlog/spdlog.h>

#include "engine/core/files.h"
#include "engine/core/text.h"
#include "engine/fit/round_trip.h"
#include "engine/io/gltf_read.h"
#include "engine/io/gltf_write.h"
#include "tools/command.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  std::string rest, poses_from, output, method = "convex";
  std::vector<std::string> poses;
  std::optional<int> random_poses;
  int influences = 4, test_poses = 0;
  std::int64_t seed = 1;
  double noise = 0.0;
};

constexpr int most_poses = 10000;

Result<RoundTripOptions> round_trip_options(const Words& words) {
  RoundTripOptions options;
  if (words.poses_from.empty() && words.poses.empty())
    return failure(ErrorKind::usage, "no poses; expected --poses-from CHARACTER --random-poses K");
  if (words.poses_from.empty())
    return failure(ErrorKind::usage, "{}: example poses from files do not exist yet; expected --poses-from CHARACTER",
                   words.poses.front());
  if (!words.poses.empty())
    return failure(ErrorKind::usage, "{}: with --poses-from no poses are given", words.poses.front());
  if (!words.random_poses)
    return failure(ErrorKind::usage, "--poses-from {}: expected --random-poses K beside it", words.poses_from);
  if (*words.random_poses < 1 || *words.random_poses > most_poses)
    return failure(ErrorKind::usage, "--random-poses {}: expected 1 to {}", *words.random_poses, most_poses);
  if (words.test_poses < 0 || words.test_poses > most_poses)
    return failure(ErrorKind::usage, "--test-poses {}: expected 0 to {}", words.test_poses, most_poses);
  if (words.influences < 1 || words.influences > static_cast<int>(max_influences))
    return failure(ErrorKind::usage, "--influences {}: expected 1 to {}", words.influences, max_influences);
  if (!(words.noise >= 0.0 && words.noise <= 1000.0))
    return failure(ErrorKind::usage, "--noise {}: expected millimetres, 0 to 1000", words.noise);
  if (words.method != "paper" && words.method != "convex")
    return failure(ErrorKind::usage, "--method {}: expected paper or convex", words.method);
  options.method = words.method == "paper" ? FitMethod::paper : FitMethod::convex;
  options.poses = static_cast<std::size_t>(*words.random_poses);
  options.test_poses = static_cast<std::size_t>(words.test_poses);
  options.influences = static_cast<std::size_t>(words.influences);
  options.seed = static_cast<std::uint64_t>(words.seed);
  options.noise = words.noise;
  auto progress = progress_style(words.common);
  if (!progress) return pass_on(std::move(progress));
  options.progress = *progress;
  return options;
}

Result<void> check_output(const Words& words) {
  if (lower(std::filesystem::path(words.output).extension().string()) != ".glb")
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .glb", words.output);
  for (const std::string& input : {words.rest, words.poses_from}) {
    std::error_code none;
    if (std::filesystem::equivalent(input, words.output, none))
      return failure(ErrorKind::cannot_write, "{}: is read by this very command; write to another file", words.output);
  }
  return check_writable(words.output);
}

nlohmann::ordered_json report_json(const Words& words, const RoundTripReport& report) {
  nlohmann::ordered_json json{{"file", words.output},
                              {"method", words.method},
                              {"vertices", report.vertices},
                              {"poses", report.poses},
                              {"bones", report.bones},
                              {"max_influences", report.max_influences},
                              {"rmse", report.rmse},
                              {"max_error", report.max_error},
                              {"relative_rmse", report.diagonal > 0.0 ? report.rmse / report.diagonal : 0.0},
                              {"test_rmse", nullptr},
                              {"ms", report.milliseconds},
                              {"height", report.height},
                              {"noise", report.noise},
                              {"negative_vertices", report.negative},
                              {"undetermined_vertices", report.undetermined}};
  if (words.test_poses > 0) json["test_rmse"] = report.test_rmse;
  json["worst"] = nlohmann::ordered_json::array();
  for (const WorstVertex& worst : report.worst)
    json["worst"].push_back({{"vertex", worst.vertex}, {"mesh", worst.mesh}, {"rmse", worst.rmse}});
  json["shells"] = nlohmann::ordered_json::array();
  for (const ShellResidual& shell : report.shells)
    json["shells"].push_back({{"mesh", shell.mesh}, {"vertices", shell.vertices}, {"rmse", shell.rmse}});
  json["reasons"] = report.reasons;
  return json;
}

void print_report(const Words& words, const RoundTripReport& report) {
  std::cout << fmt::format("{}: {} vertices, {} bones, {} poses, at most {} influences, {:.0f} ms\n", words.output,
                           report.vertices, report.bones, report.poses, report.max_influences, report.milliseconds);
  std::cout << fmt::format("RMSE {:.3g} ({:.3g} of the box), largest error {:.3g}\n", report.rmse,
                           report.diagonal > 0.0 ? report.rmse / report.diagonal : 0.0, report.max_error);
  if (words.test_poses > 0)
    std::cout << fmt::format("RMSE {:.3g} in {} clean poses that the fit did not see\n", report.test_rmse,
                             words.test_poses);
  if (report.negative > 0) std::cout << fmt::format("{} vertices had negative weights, cut to 0\n", report.negative);
  std::cout << "worst vertices:\n";
  for (const WorstVertex& worst : report.worst)
    std::cout << fmt::format("  {:>8}  {:.3g}  {}\n", worst.vertex, worst.rmse, worst.mesh);
  std::cout << "shells:\n";
  constexpr std::size_t shown = 10;
  for (std::size_t i = 0; i < std::min(shown, report.shells.size()); ++i)
    std::cout << fmt::format("  {:>8} vertices  {:.3g}  {}\n", report.shells[i].vertices, report.shells[i].rmse,
                             report.shells[i].mesh);
  if (report.shells.size() > shown) std::cout << fmt::format("  and {} more\n", report.shells.size() - shown);
}

Result<void> fit_skin(const Words& words) {
  apply_verbosity(words.common);
  const auto options = round_trip_options(words);
  if (!options) return tl::unexpected<Error>(options.error());
  if (auto ok = check_output(words); !ok) return ok;
  auto rest = read_gltf(words.rest);
  if (!rest) return pass_on(std::move(rest));
  log_problems(rest->problems);
  const bool same = words.rest == words.poses_from;
  auto character = same ? rest : read_gltf(words.poses_from);
  if (!character) return pass_on(std::move(character));
  if (!same) log_problems(character->problems);
  const auto report = fit_round_trip(*character, *options, *rest);
  if (!report) return tl::unexpected<Error>(report.error());
  for (const std::string& reason : report->reasons) spdlog::warn("{}", reason);
  const auto bytes = rig_glb(*rest);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  if (auto ok = write_file(words.output, *bytes); !ok) return ok;
  if (words.common.json)
    print_json(report_json(words, *report));
  else
    print_report(words, *report);
  return {};
}

}  // namespace

void add_fit_skin(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("fit-skin", "Skin weights from example poses");
  command->footer(
      "Example: sinew fit-skin hero.glb --poses-from hero.glb --random-poses 20 --test-poses 10 -o fit.glb");
  auto words = std::make_shared<Words>();
  command->add_option("rest", words->rest, "The rest mesh with its skeleton: a .glb, .gltf or .vrm file")->required();
  command->add_option("poses", words->poses, "Example poses (from files: not yet)");
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
  add_later_option(*command, "--bones");
  add_later_option(*command, "--count");
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return fit_skin(*words); }; });
}

}  // namespace sinew::tools
