#pragma once
/// Landmarks of a head for which nobody has named any: from its profile, its eyes and its mouth, and where it has no
/// features by Loomis' proportions.

#include <string>
#include <vector>

#include "engine/face/landmarks.h"
#include "engine/model/character_mesh.h"

namespace sinew {

/// Where a head is: its own axes, and which vertices belong to it.
struct HeadSite {
  Mat3 axes{1.0};            ///< its left, its up, its front
  std::vector<bool> inside;  ///< [vertices of the mesh]; empty: not known, looked for by the neck
};

struct FoundLandmarks {
  Landmarks marks;                 ///< in the space of `mesh.positions`
  std::vector<std::string> notes;  ///< which were found by which feature, for people
  bool by_features = true;         ///< false: neither nose, lips nor eyes were seen, all are by proportion
};

/// What to tell people where nothing was seen (by_features).
constexpr const char* no_features =
    "neither nose, lips nor eyes were found on it: its face is laid on by a head's proportions and shows little or "
    "nothing; a file of landmarks says where its face is";

/// `mesh`: at rest. Fails as bad_input where there is no head to be seen: too few vertices, or no profile, or no
/// place for a landmark that a face cannot do without. `name`: the
/// model's, for messages.
Result<FoundLandmarks> find_landmarks(const CharacterMesh& mesh, const HeadSite& site, const std::string& name);

}  // namespace sinew
