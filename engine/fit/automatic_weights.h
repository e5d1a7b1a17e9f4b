#pragma once
/// Skin weights of a mesh that has none. engine/definitions.md 17.

#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/task_watch.h"
#include "engine/fit/skinned_shape.h"
#include "engine/model/model.h"

namespace sinew {

struct AutomaticWeightOptions {
  std::size_t influences = 4;         ///< at most so many joints a vertex, 1 to max_influences
  double prune = 0.01;                ///< weights below this are dropped
  int resolution = 192;               ///< voxels along the longest side
  std::vector<std::string> left_out;  ///< joints that shall move nothing, by node or humanoid name
  ProgressStyle progress = ProgressStyle::none;
  TaskWatch* watch = nullptr;  ///< counts joints and the steps before; cancelled, it stops the work as a signal does
};

struct AutomaticWeightReport {
  std::size_t vertices = 0, joints = 0, max_influences = 0;
  std::vector<std::string> outside;  ///< joints that lie outside of the mesh: they move nothing
  std::vector<std::string> idle;     ///< joints inside it that got no vertex all the same
  std::size_t far = 0;               ///< vertices farther from their bone than a fifth of the height
  std::size_t farthest = 0;          ///< the vertex that is farthest
  std::string farthest_mesh;
  double farthest_distance = 0.0;  ///< world units
  double height = 0.0;             ///< the longest side of the mesh's box
  double milliseconds = 0.0;
};

/// Weights of the model's one skin (bound_model() made it): the nearest bone inside the body (nearest_bones.h) by
/// voxels, spread over the surface like heat (heat_weights.h), limbs parted. In a humanoid what does not hang from the
/// hips is a handle and moves nothing; elsewhere a joint without a parent that lies outside of the mesh.
/// Fails as bad_input where an option names an unknown joint or no joint lies in the mesh; as interrupted.
Result<AutomaticWeightReport> set_automatic_weights(const AutomaticWeightOptions& options, Model& model);

}  // namespace sinew
