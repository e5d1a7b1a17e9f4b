#pragma once
/// Example poses of a mesh from files.

#include <filesystem>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "engine/fit/skinned_shape.h"
#include "engine/model/model.h"

namespace sinew {

struct ExampleFiles {
  std::vector<std::filesystem::path> files;  ///< .obj and .ply, a pose each; or one glTF file that is animated
  std::optional<std::vector<int>> frames;    ///< at which the poses stand; absent: 0, 1, 2..., or at a glTF's keys
  double fps = 24.0;                         ///< frames a second
  std::string clip;                          ///< of the glTF file; its first where it has none of this name
};

struct ExamplePoses {
  std::vector<double> seconds;  ///< [poses] when each stands
  std::vector<Vec3> places;     ///< [vertices * poses] a vertex's places in all poses, vertex after vertex
};

/// Most poses that one fit takes.
constexpr std::size_t most_example_poses = 10000;

/// The places in the files of the vertices of `rest`, which are the vertices of its model in the order of `export`. A
/// glTF file's vertices are morphed and skinned at the distinct times of its clip's keys, or at `frames`.
/// Fails as bad_input where a file has other vertices or triangles than `rest`, nothing moves, or there are too many
/// poses; as interrupted between two files.
Result<ExamplePoses> read_example_poses(const ExampleFiles& files, const SkinnedShape& rest);

}  // namespace sinew
