#include <iostream>

#include <spdlog/spdlog.h>

#include "engine/body/headed_figure.h"
#include "engine/core/files.h"
#include "engine/core/interrupt.h"
#include "engine/core/text.h"
#include "engine/io/gltf_write.h"
#include "tools/command.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  std::string output;
  std::optional<std::string> like, head;
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

/// An age's word or number, or a file of measures.
Result<HeadMeasures> head_measures(const std::string& text) {
  if (auto age = parse_age(text)) return measures_of_age(*age);
  const auto file = read_file(text);
  if (!file)
    return bad_input("--head {}: is neither an age (adult, young, adolescent, child, infant, or 0 to 1) nor a file: {}",
                     text, file.error().message);
  return parse_measures({reinterpret_cast<const char*>(file->data()), file->size()}, text);
}

Result<Model> figure_model(const Words& words, const BodyOptions& options) {
  if (!words.head) return build_figure(options);
  const auto measures = head_measures(*words.head);
  if (!measures) return tl::unexpected<Error>(measures.error());
  auto headed = build_headed_figure(options, *measures, default_head_level, true);
  if (!headed) return tl::unexpected<Error>(headed.error());
  return std::move(headed->model);
}

Result<void> figure(const Words& words) {
  apply_verbosity(words.common);
  if (lower(std::filesystem::path(words.output).extension().string()) != ".glb")
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .glb", words.output);
  const auto options = figure_options(words);
  if (!options) return tl::unexpected<Error>(options.error());
  if (auto ok = check_figure_options(*options); !ok) return ok;
  if (auto ok = check_writable(words.output); !ok) return ok;
  std::optional<EndAtOnce> nothing_is_open(std::in_place);
  const auto model = figure_model(words, *options);
  if (!model) return tl::unexpected<Error>(model.error());
  nothing_is_open.reset();
  const auto bytes = rig_glb(*model);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  if (auto ok = write_file(words.output, *bytes); !ok) return ok;

  Bounds bounds;
  std::size_t vertices = 0, triangles = 0;
  for (const Primitive& primitive : model->meshes.front().primitives) {
    for (const Vec3& p : primitive.positions) bounds.add(p);
    vertices += primitive.positions.size();
    triangles += primitive.indices.size() / 3;
  }
  const std::size_t joints = model->skins.front().joints.size();
  if (words.common.json) {
    print_json({{"file", words.output},
                {"vertices", vertices},
                {"triangles", triangles},
                {"joints", joints},
                {"height", bounds.high.y - bounds.low.y}});
  } else {
    std::cout << fmt::format("{}: {} vertices, {} triangles, {} joints, {:.3f} m\n", words.output, vertices, triangles,
                             joints, bounds.high.y - bounds.low.y);
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
  command->add_option("--head", words->head,
                      "With a face: its age (adult to infant, or 0 to 1), or a file of measures from sinew head");
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return figure(*words); }; });
}

}  // namespace sinew::tools
