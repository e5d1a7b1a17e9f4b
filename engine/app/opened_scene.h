#pragma once
/// The scene in whatever a user names: a scene file, a model, a motion.

#include <optional>
#include <string>

#include "engine/core/files.h"
#include "engine/model/scene.h"

namespace sinew {

/// A scene, and whether it was made up for a bare model, which has defaults of its own.
struct OpenedScene {
  Scene scene;
  bool bare_model = false;
  std::optional<Bytes> model_bytes = std::nullopt;  ///< of a bare model's file, which was read to see what it is
};

/// `source`: a file, the name of a built-in model, or empty for the embedded scene. Fails as bad_input.
Result<OpenedScene> open_scene(const std::string& source);

}  // namespace sinew
