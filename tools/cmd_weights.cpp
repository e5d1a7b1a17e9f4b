#include <iostream>

#include "engine/core/files.h"
#include "engine/core/interrupt.h"
#include "engine/core/text.h"
#include "engine/fit/transferred_weights.h"
#include "engine/fit/weight_run.h"
#include "engine/io/gltf_read.h"
#include "engine/io/gltf_write.h"
#include "tools/weight_words.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  WeightWords weights;
  std::string model, output;
};

struct Count {
  std::size_t vertices = 0, influences = 0, most = 0;
};

Count count(const Model& model) {
  Count out;
  for (const SkinnedShape& shape : skinned_shapes(model)) {
    out.vertices += shape.positions.size();
    out.influences += shape.influences.entries.size();
    out.most = std::max(out.most, most_influences(shape.influences));
  }
  return out;
}

Result<void> weights(const Words& words) {
  apply_verbosity(words.common);
  const auto edits = weight_edits(words.weights);
  if (!edits) return tl::unexpected<Error>(edits.error());
  if (lower(std::filesystem::path(words.output).extension().string()) != ".glb")
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .glb", words.output);
  const std::vector<std::string> inputs{words.model, words.weights.from};
  if (auto ok = check_fresh_output(words.output, inputs); !ok) return ok;
  auto model = read_gltf(words.model);
  if (!model) return pass_on(std::move(model));
  log_problems(model->problems);
  const Count before = count(*model);
  std::vector<std::string> problems;
  if (!words.weights.from.empty())
    if (auto ok = take_weights(words.weights.from, *model, problems); !ok) return ok;
  log_problems(problems);
  if (auto ok = edit_weights(*edits, *model); !ok) return ok;
  const Count after = count(*model);
  const auto bytes = rig_glb(*model);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  if (auto ok = check_interrupt(); !ok) return ok;
  if (auto ok = write_file(words.output, *bytes); !ok) return ok;
  if (words.common.json)
    print_json({{"file", words.output},
                {"vertices", after.vertices},
                {"influences_before", before.influences},
                {"influences", after.influences},
                {"max_influences", after.most}});
  else
    std::cout << fmt::format("{}: {} vertices, {} weights before, {} now, at most {} each\n", words.output,
                             after.vertices, before.influences, after.influences, after.most);
  return {};
}

}  // namespace

void add_weights(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("weights", "Changes skin weights: take over, smooth, mirror, prune, limit");
  command->footer(
      "What is asked for happens in this order: --from, --smooth, --mirror, --prune, --influences.\n"
      "Example: sinew weights hero.glb --smooth 2 --mirror left --influences 4 -o even.glb");
  auto words = std::make_shared<Words>();
  command->add_option("model", words->model, "A skinned .glb, .gltf or .vrm file")->required();
  command->add_option("-o,--output", words->output, "x.glb")->required();
  add_weight_options(*command, words->weights);
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return weights(*words); }; });
}

}  // namespace sinew::tools
