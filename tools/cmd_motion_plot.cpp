#include <array>

#include <spdlog/spdlog.h>

#include "engine/core/text.h"
#include "engine/motion/curve_plot.h"
#include "engine/motion/motion_edit.h"
#include "tools/motion_command.h"

namespace sinew::tools {
namespace {

struct Words : MotionWords {
  std::string clip, joint, axis = "x", output, size = "1000x700";
};

Result<void> plot(const Words& words) {
  apply_verbosity(words.common);
  const std::size_t axis = std::string_view("xyz").find(words.axis);
  if (words.axis.size() != 1 || axis == std::string_view::npos)
    return failure(ErrorKind::usage, "--axis {}: expected x, y or z", words.axis);
  const std::string extension = lower(std::filesystem::path(words.output).extension().string());
  if (extension != ".svg" && extension != ".png")
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .svg or .png", words.output);
  const auto size = parse_size(words.size);
  if (!size) return tl::unexpected<Error>(size.error());
  const auto library = open_library(words, false);
  if (!library) return tl::unexpected<Error>(library.error());
  const auto clip = library->load(words.clip);
  if (!clip) return tl::unexpected<Error>(clip.error());
  if (!clip->curves)
    return bad_input("{}: clip \"{}\" has no curves yet; `sinew motion fit {}` fits them", library->file().string(),
                     words.clip, words.clip);
  CurvePlot picture;
  picture.width = size->width;
  picture.height = size->height;
  const CurveClip& curves = *clip->curves;
  if (words.joint == "root") {
    for (const MotionFrame& frame : clip->motion.frames) {
      picture.times.push_back(static_cast<double>(picture.times.size()) * clip->motion.frame_time);
      picture.values.push_back(frame.root[static_cast<int>(axis)]);
    }
    picture.curve = curves.root[axis];
    picture.quantity = fmt::format("{} (the file's lengths)", words.axis);
    picture.unit = "lengths";
  } else {
    const auto joint = find_motion_joint(clip->motion.skeleton, words.joint);
    if (!joint) return bad_input("{}: clip \"{}\": {}", library->file().string(), words.clip, joint.error().message);
    picture.curve = curves.joints[*joint].angles[axis];
    const auto turns = joint_turns(clip->motion, static_cast<std::size_t>(*joint));
    for (const Vec3& angles : angles_in_order(turns, curves.joints[*joint].order)) {
      picture.times.push_back(static_cast<double>(picture.times.size()) * clip->motion.frame_time);
      picture.values.push_back(angles[static_cast<int>(axis)]);
    }
    picture.quantity = fmt::format("{} about {} (degrees)", std::array{"alpha", "beta", "gamma"}[axis], words.axis);
    picture.unit = "degrees";
  }
  picture.title = fmt::format("{}: {}, {} segments, degree {}", words.clip, words.joint, picture.curve.segments(),
                              picture.curve.degree());
  if (auto drawn = plot_curve(picture, words.output); !drawn) return drawn;
  if (words.common.json)
    print_json({{"file", words.output},
                {"clip", words.clip},
                {"joint", words.joint},
                {"axis", words.axis},
                {"segments", picture.curve.segments()},
                {"degree", picture.curve.degree()}});
  else
    spdlog::info("{}", words.output);
  return {};
}

}  // namespace

void add_motion_plot(CLI::App& motion, Run& run) {
  auto* command = motion.add_subcommand("plot", "A fitted curve with its samples, cuts and residual, by gnuplot");
  command->footer("Example: sinew motion plot laugh --joint neck --axis x -o laugh.svg");
  auto words = std::make_shared<Words>();
  command->add_option("clip", words->clip, "The clip's name")->required();
  command->add_option("--joint", words->joint, "A joint's or humanoid name, or root for the root's place")->required();
  command->add_option("--axis", words->axis, "x, y or z")->capture_default_str();
  command->add_option("-o,--output", words->output, "x.svg or x.png")->required();
  command->add_option("--size", words->size, "Picture size")->capture_default_str();
  add_motion_options(*command, *words);
  command->callback([words, &run] { run = [words] { return plot(*words); }; });
}

}  // namespace sinew::tools
