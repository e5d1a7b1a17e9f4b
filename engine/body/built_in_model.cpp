#include "engine/body/built_in_model.h"

#include "engine/body/arm.h"
#include "engine/body/figure.h"
#include "engine/core/text.h"
#include "engine/face/drawn_head.h"
#include "engine/model/scene_words.h"

namespace sinew {

Result<Model> built_in_model(std::string_view name) {
  if (name == "builtin:arm") return make_arm();
  if (name == "builtin:figure") return build_figure({});
  if (name == "builtin:head") {
    auto head = DrawnHead::make({}, 0.0);
    if (!head) return pass_on(std::move(head));
    return head->model();
  }
  const auto known = built_in_model_names();
  if (std::ranges::find(known, name) == known.end())
    return bad_input("{}: is no built-in model; expected one of {}{}", name, fmt::join(known, ", "),
                     did_you_mean(name, known));
  const auto options = figure_preset(name.substr(name.find(':') + 1));
  if (!options) return tl::unexpected<Error>(options.error());
  return build_figure(*options);
}

}  // namespace sinew
