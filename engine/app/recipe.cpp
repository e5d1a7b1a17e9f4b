#include "engine/app/recipe.h"

#include <nlohmann/json.hpp>

#include "engine/app/version.h"
#include "engine/core/files.h"
#include "engine/model/scene_words.h"

namespace sinew {

Recipe::Recipe(const Stage& stage, const SceneOptions& scene, const LookOptions& look, const std::string& figure) {
  nlohmann::ordered_json json;
  json["scene"] = stage.scene_hash;
  json["deformer"] = deformer_name(scene.deformer);
  json["bulge"] = bulge_name(scene.bulge);
  json["size"] = {look.size.width, look.size.height};
  json["samples"] = look.samples;
  if (look.view) json["view"] = view_names()[static_cast<std::size_t>(*look.view)];
  if (look.orbit) json["orbit"] = *look.orbit;
  if (look.shading) json["shading"] = shading_names()[static_cast<std::size_t>(*look.shading)];
  if (!look.joint.empty()) json["joint"] = look.joint;
  if (look.shadows) json["shadows"] = *look.shadows;
  if (look.floor) json["floor"] = *look.floor;
  if (look.background) json["background"] = colour_text(*look.background);
  json["figure"] = figure;
  json["version"] = version();
  text_ = json.dump();
}

std::string Recipe::hash(int frame) const { return sha256(fmt::format("{}#{}", text_, frame)); }

}  // namespace sinew
