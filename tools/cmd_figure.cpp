#include <iostream>

#include <spdlog/spdlog.h>

#include "engine/body/figure.h"
#include "engine/core/files.h"
#include "engine/core/text.h"
#include "engine/io/gltf_write.h"
#include "tools/command.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  std::string output;
  std::optional<std::string> like;
  std::optional<double> sex, height, build, muscle;
  std::optional<int> joints, vertices;
};

Result<BodyOptions> figure_options(const Words& words) {
  BodyOptions options;
  if (words.like) {
    auto preset = figure_preset(*words.like);
    if (!preset) return preset;
    options = *preset;
  }
  if (words.sex) options.sex = *words.sex;
  if (words.height) {
    // 0 is the library's word for "as the measures say", and no height that a user can mean.
    if (*words.height == 0.0) return failure(ErrorKind::usage, "--height 0: expected metres, from 0.3 to 3");
    options.height = *words.height;
  }
  if (words.build) options.build = *words.build;
  if (words.muscle) options.muscle = *words.muscle;
  if (words.joints) options.joints = *words.joints;
  if (words.vertices) {
    options.vertices = *words.vertices;
    options.triangles = 0;
  }
  return options;
}

Result<void> figure(const Words& words) {
  apply_verbosity(words.common);
  if (lower(std::filesystem::path(words.output).extension().string()) != ".glb")
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .glb", words.output);
  const auto options = figure_options(words);
  if (!options) return tl::unexpected<Error>(options.error());
  if (auto ok = check_figure_options(*options); !ok) return ok;
  if (auto ok = check_writable(words.output); !ok) return ok;
  const auto model = build_figure(*options);
  if (!model) return tl::unexpected<Error>(model.error());
  const auto bytes = rig_glb(*model);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  if (auto ok = write_file(words.output, *bytes); !ok) return ok;

  const Primitive& skin = model->meshes.front().primitives.front();
  Bounds bounds;
  for (const Vec3& p : skin.positions) bounds.add(p);
  const std::size_t joints = model->skins.front().joints.size();
  if (words.common.json) {
    print_json({{"file", words.output},
                {"vertices", skin.positions.size()},
                {"triangles", skin.indices.size() / 3},
                {"joints", joints},
                {"height", bounds.high.y - bounds.low.y}});
  } else {
    std::cout << fmt::format("{}: {} vertices, {} triangles, {} joints, {:.3f} m\n", words.output,
                             skin.positions.size(), skin.indices.size() / 3, joints, bounds.high.y - bounds.low.y);
  }
  return {};
}

}  // namespace

void add_figure(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("figure", "A procedural human body, rigged and skinned");
  command->footer("Example: sinew figure --like woman --height 1.70 -o woman.glb");
  auto words = std::make_shared<Words>();
  command->add_option("-o,--output", words->output, "x.glb")->required();
  command->add_option("--like", words->like,
                      "Counts of vertices, triangles and joints as of: skeleton, woman or poser");
  command->add_option("--sex", words->sex, "0 (male) to 1 (female)");
  command->add_option("--height", words->height, "Metres, 0.3 to 3 (1.75 male to 1.63 female)");
  command->add_option("--build", words->build, "-1 (slim) to 1 (heavy) (0)");
  command->add_option("--muscle", words->muscle, "0 to 1 (0.5)");
  command->add_option("--joints", words->joints, "23, 37 or 68 (68)");
  command->add_option("--vertices", words->vertices, "About so many, 1840 to 2000000 (8000)");
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return figure(*words); }; });
}

}  // namespace sinew::tools
