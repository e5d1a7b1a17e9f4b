#include <algorithm>
#include <iostream>

#include <spdlog/spdlog.h>

#include "engine/body/figure.h"
#include "engine/core/text.h"
#include "engine/motion/motion_edit.h"
#include "engine/motion/skin_error.h"
#include "tools/motion_command.h"

namespace sinew::tools {
namespace {

struct Words : MotionWords {
  std::string clip, segments = "auto";
  std::vector<std::string> joints;
  MotionFitOptions options;
};

/// The figure whose skin shows a fit's error.
Result<Model> test_figure() {
  BodyOptions options;
  options.vertices = 2500;
  return build_figure(options);
}

struct SkinError {
  double mm = 0.0;
  bool of_figure = true;  ///< else of the skeleton's own joints
};

SkinError skin_error(const Model& figure, const Motion& sampled, const Motion& fitted) {
  const auto error = skin_error_mm(figure, sampled, fitted);
  if (error) return {*error, true};
  return {joint_error_mm(sampled, fitted), false};
}

struct Fitted {
  MotionFit fit;
  SkinError skin;
};

Fitted fitted(const Motion& motion, const Model& figure, const CurveFitOptions& options, const KeptCurves* kept) {
  Fitted result{fit_motion(motion, options, kept), {}};
  result.skin = skin_error(figure, motion, sampled_motion(result.fit.clip, motion.skeleton, motion.name));
  return result;
}

/// The degrees follow from the skin: they shrink, in proportion to what the skin was off by, until it holds.
Result<Fitted> fitted_within(const Motion& motion, const Model& figure, CurveFitOptions options, const KeptCurves* kept,
                             double skin_mm) {
  options.tolerance = options.tolerance.value_or(1.0);
  for (int attempt = 0; attempt < 20; ++attempt) {
    Fitted result = fitted(motion, figure, options, kept);
    if (result.skin.mm <= skin_mm) return result;
    *options.tolerance *= std::clamp(0.9 * skin_mm / result.skin.mm, 0.1, 0.9);
  }
  return bad_input("clip \"{}\": no fit keeps its skin within {} mm", motion.name, skin_mm);
}

/// All curves but those of the joints that are named: the clip's own, or new ones that follow its noise alone.
Result<std::optional<KeptCurves>> kept_curves(const StoredClip& clip, const std::vector<std::string>& joints) {
  if (joints.empty()) return std::nullopt;
  const MotionSkeleton& skeleton = clip.motion.skeleton;
  KeptCurves kept{{}, std::vector<bool>(skeleton.joints.size(), true)};
  for (const std::string& name : joints) {
    const auto joint = find_motion_joint(skeleton, name);
    if (!joint) return bad_input("clip {}: {}", clip.entry.name, joint.error().message);
    kept.joints[static_cast<std::size_t>(*joint)] = false;
  }
  kept.curves = clip.curves ? *clip.curves : fit_motion(clip.motion, {}).clip;
  return kept;
}

nlohmann::ordered_json curves_json(const MotionFit& fit, const MotionSkeleton& skeleton) {
  nlohmann::ordered_json curves = nlohmann::ordered_json::array();
  for (const CurveReport& curve : fit.curves)
    curves.push_back({{"joint", skeleton.joints[curve.joint].name},
                      {"axis", std::string(1, "xyz"[curve.axis])},
                      {"order", order_name(fit.clip.joints[curve.joint].order)},
                      {"samples", fit.clip.frames()},
                      {"segments", curve.segments},
                      {"degree", curve.degree},
                      {"rmse_degrees", curve.rmse_degrees},
                      {"max_degrees", curve.max_degrees}});
  return curves;
}

void print_text(const MotionFit& fit, const MotionSkeleton& skeleton, const SkinError& skin) {
  std::cout << fmt::format("{:<24} axis order segments degree   rmse    max (degrees)\n", "joint");
  for (const CurveReport& curve : fit.curves)
    if (curve.degree > 0)
      std::cout << fmt::format("{:<24} {:>4} {:>5} {:>8} {:>6} {:>6.3f} {:>6.3f}\n", skeleton.joints[curve.joint].name,
                               "xyz"[curve.axis], order_name(fit.clip.joints[curve.joint].order), curve.segments,
                               curve.degree, curve.rmse_degrees, curve.max_degrees);
  std::cout << fmt::format("{} numbers for {} ({:.1f} %), {} {:.2f} mm at the most, fitted in {:.0f} ms\n",
                           fit.stored_numbers, fit.sampled_numbers,
                           100.0 * static_cast<double>(fit.stored_numbers) / static_cast<double>(fit.sampled_numbers),
                           skin.of_figure ? "skin off by" : "joints off by", skin.mm, fit.ms);
}

Result<void> fit(const Words& words) {
  apply_verbosity(words.common);
  MotionFitOptions options = words.options;
  if (words.segments != "auto") {
    const auto count = parse_integer(words.segments);
    if (!count || *count < 1 || *count > 100000)
      return failure(ErrorKind::usage, "--segments {}: expected auto, or a number from 1 to 100000", words.segments);
    options.curve.segments = static_cast<int>(*count);
  }
  if (auto ok = check_motion_fit_options(options); !ok) return ok;
  auto library = open_library(words, true);
  if (!library) return pass_on(std::move(library));
  const auto clip = library->load(words.clip);
  if (!clip) return tl::unexpected<Error>(clip.error());
  const auto figure = test_figure();
  if (!figure) return tl::unexpected<Error>(figure.error());
  const Motion& motion = clip->motion;
  const auto kept = kept_curves(*clip, words.joints);
  if (!kept) return tl::unexpected<Error>(kept.error());
  const KeptCurves* others = *kept ? &**kept : nullptr;
  Result<Fitted> result = options.skin_tolerance
                              ? fitted_within(motion, *figure, options.curve, others, *options.skin_tolerance)
                              : Result<Fitted>(fitted(motion, *figure, options.curve, others));
  if (!result) return pass_on(std::move(result));
  const MotionFit& found = result->fit;
  if (!motion.frames.front().offsets.empty())
    spdlog::warn("clip \"{}\": joints change their offsets; curves hold them at rest", words.clip);
  if (found.tolerance > 0.0)
    for (const CurveReport& curve : found.curves)
      if (curve.max_degrees > found.tolerance)
        spdlog::warn("{} {}: {:.3f} degrees off; more segments or degrees would hold {}",
                     motion.skeleton.joints[curve.joint].name, "xyz"[curve.axis], curve.max_degrees, found.tolerance);
  if (auto ok = library->begin(); !ok) return ok;
  if (auto ok = library->set_curves(words.clip, found.clip); !ok) return ok;
  if (auto ok = library->commit(); !ok) return ok;
  if (!words.common.json) {
    print_text(found, motion.skeleton, result->skin);
    return {};
  }
  print_json({{"clip", words.clip},
              {"curves", curves_json(found, motion.skeleton)},
              {"stored_numbers", found.stored_numbers},
              {"sampled_numbers", found.sampled_numbers},
              {"skin_error_mm", result->skin.mm},
              {"skin_error_of", result->skin.of_figure ? "figure" : "joints"},
              {"tolerance", found.tolerance},
              {"root_error", found.root_error},
              {"ms", found.ms},
              {"pose_us", pose_microseconds(found.clip, motion.skeleton)}});
  return {};
}

}  // namespace

void add_motion_fit(CLI::App& motion, Run& run) {
  auto* command = motion.add_subcommand("fit", "Fits piecewise polynomials to a clip's joint angles, and keeps them");
  command->footer("Example: sinew motion fit walk --tolerance 0.5");
  auto words = std::make_shared<Words>();
  command->add_option("clip", words->clip, "The clip's name")->required();
  command->add_option("--degree", words->options.curve.degree,
                      "Of every segment, 3 to 8; with a tolerance, or segments auto, at most (5; with a tolerance 8)");
  command->add_option("--segments", words->segments, "auto, or so many a curve")->capture_default_str();
  command->add_option("--tolerance", words->options.curve.tolerance,
                      "Degrees that a curve may be off; without it noise is smoothed away");
  command->add_option("--skin-tolerance", words->options.skin_tolerance, "Millimetres that a figure's skin may be off");
  command->add_option("--joint", words->joints, "Only this joint's curves, the others stay; repeatable")
      ->allow_extra_args(false);
  add_motion_options(*command, *words);
  command->callback([words, &run] { run = [words] { return fit(*words); }; });
}

}  // namespace sinew::tools
