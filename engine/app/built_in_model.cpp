#include "engine/app/built_in_model.h"

#include <fmt/ranges.h>

#include "engine/body/arm.h"
#include "engine/body/figure.h"
#include "engine/core/text.h"
#include "engine/model/scene_words.h"

namespace sinew {

Result<Model> built_in_model(const std::string& name) {
  if (name == "builtin:arm") return make_arm();
  if (name == "builtin:figure") return build_figure({});
  return bad_input("{}: there is no such built-in model{}; there are {}", name,
                   did_you_mean(name, built_in_model_names()), fmt::join(built_in_model_names(), ", "));
}

}  // namespace sinew
