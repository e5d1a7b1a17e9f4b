#include "engine/app/opened_scene.h"

#include "embedded/default_scene.h"
#include "engine/app/motion_use.h"
#include "engine/io/scene_file.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

constexpr std::size_t largest_scene_file = std::size_t{64} << 20;

OpenedScene bare_model_scene(const std::string& model) {
  OpenedScene opened;
  opened.bare_model = true;
  opened.scene.characters.emplace_back().model = model;
  return opened;
}

}  // namespace

Result<OpenedScene> open_scene(const std::string& source) {
  if (source.empty()) {
    auto scene = parse_scene(default_scene, "the embedded scene", ".");
    if (!scene) return pass_on(std::move(scene));
    return OpenedScene{std::move(*scene), false};
  }
  if (is_built_in_model(source)) return bare_model_scene(source);
  auto bytes = read_file(source);
  if (!bytes) return pass_on(std::move(bytes));
  if (bytes->size() <= largest_scene_file && looks_like_scene(*bytes)) {
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    auto scene = parse_scene(text, source, std::filesystem::path(source).parent_path());
    if (!scene) return pass_on(std::move(scene));
    return OpenedScene{std::move(*scene), false};
  }
  if (is_motion_alone(source, *bytes)) {
    OpenedScene opened = bare_model_scene("builtin:figure");
    opened.scene.characters.front().motion = MotionUse{.source = MotionFile{source, ""}};
    return opened;
  }
  OpenedScene opened = bare_model_scene(source);
  opened.model_bytes = std::move(*bytes);
  return opened;
}

}  // namespace sinew
