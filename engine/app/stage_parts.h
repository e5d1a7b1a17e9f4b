#pragma once
/// What takes long on the way to another scene, made ahead on any thread: models read or drawn, motions put onto them.

#include "engine/app/character_motions.h"

namespace sinew {

/// What a scene needs that a stage does not have.
struct MissingParts {
  struct Part {
    std::size_t character = 0;
    bool needs_model = false;
    StagedCharacter known{};  ///< else: model, its hash and its humanoid bones alone
  };
  std::vector<Part> parts;
  Scene scene;
  SceneOptions options;  ///< with the scene's library
  std::string source;    ///< of the scene, for messages
  KnownMotions motions;  ///< of the stage

  bool empty() const { return parts.empty(); }
};

/// What restage() would have to read, draw or retarget; each model that the stage has serves one character.
MissingParts missing_parts(const Stage& stage, const Scene& scene, const SceneOptions& options);

struct StageParts {
  std::vector<StagedCharacter> models;
  KnownMotions motions;
};

/// Makes them as restage() would. Fails as open_stage() does.
Result<StageParts> make_parts(const MissingParts& missing, TaskWatch& watch);

/// Puts them among what the stage keeps for scenes to come.
void lend(StageParts parts, Stage& stage);

/// Whether a model that is there is the one that a scene asks for.
bool has_model_of(const StagedCharacter& known, const Character& character);

/// All motions of a stage, played and spare.
KnownMotions known_motions(const Stage& stage);

}  // namespace sinew
