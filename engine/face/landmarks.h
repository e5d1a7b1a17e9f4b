#pragma once
/// Named places of a face, by which a face of one mesh is laid on another.

#include <array>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <variant>

#include "engine/core/math.h"
#include "engine/core/result.h"
#include "engine/face/head_cage.h"

namespace sinew {

/// A landmark's name, and where it is on the head from drawing rules: a point of its cage, its left side.
struct LandmarkName {
  std::string name;  ///< Left and Right are the character's own
  CagePoint place;
  bool right = false;     ///< on the other side
  bool required = false;  ///< a face cannot be laid on without it
};

/// All there are, each once. lipContact is required where not both of upperLip and lowerLip are given.
std::span<const LandmarkName> landmark_names();

/// A vertex of a mesh, counted as its file or `export` has them, or a place of the mesh at rest.
using LandmarkPlace = std::variant<std::uint32_t, Vec3>;
using LandmarkPlaces = std::map<std::string, LandmarkPlace>;
using Landmarks = std::map<std::string, Vec3>;  ///< by name, any one space

/// A landmark file: {"landmarks": {"noseTip": 1234, "chin": [0, 1.5, 0.1]}}, comments allowed. `name` is the file's,
/// for messages. Fails as bad_input with the JSON pointer: an unknown name (with the nearest known), a value that is
/// neither a vertex number nor three numbers, a required landmark missing.
Result<LandmarkPlaces> parse_landmarks(std::string_view text, const std::string& name);
Result<LandmarkPlaces> read_landmarks(const std::filesystem::path& file);

/// Landmarks as a file that parse_landmarks reads again.
std::string landmarks_text(const LandmarkPlaces& places);

/// Says which required landmark is missing. `name` is the file's.
Result<void> check_landmarks(const LandmarkPlaces& places, const std::string& name);

}  // namespace sinew
