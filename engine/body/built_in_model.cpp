#include "engine/body/built_in_model.h"

#include "engine/body/arm.h"
#include "engine/body/figure.h"
#include "engine/core/text.h"
#include "engine/face/drawn_head.h"
#include "engine/model/scene_words.h"

namespace sinew {

std::optional<BodyOptions> built_in_figure(std::string_view name) {
  constexpr std::string_view prefix = "builtin:";
  if (!name.starts_with(prefix)) return std::nullopt;
  if (name == "builtin:figure") return BodyOptions{};
  const auto preset = figure_preset(name.substr(prefix.size()));
  return preset ? std::optional(*preset) : std::nullopt;
}

Result<Model> built_in_model(std::string_view name) {
  if (name == "builtin:arm") return make_arm();
  if (name == "builtin:head") {
    auto head = DrawnHead::make({}, 0.0);
    if (!head) return pass_on(std::move(head));
    return head->model();
  }
  const auto known = built_in_model_names();
  if (std::ranges::find(known, name) == known.end())
    return bad_input("{}: is no built-in model; expected one of {}{}", name, fmt::join(known, ", "),
                     did_you_mean(name, known));
  return build_figure(built_in_figure(name).value());
}

}  // namespace sinew
