#pragma once
/// A mesh bound to a skeleton, from files to a file.

#include "engine/fit/automatic_weights.h"
#include "engine/fit/weight_edit.h"

namespace sinew {

struct BindMeshOptions {
  std::string mesh;      ///< any file that holds one
  std::string skeleton;  ///< glTF file whose joints stand in the mesh at rest
  std::string output;    ///< .glb
  std::string from;      ///< skinned glTF file whose weights are taken over; empty: weights are made
  AutomaticWeightOptions weights;
  WeightEdits edits;
};

/// Reads mesh and skeleton, gives every vertex its weights, edits these and writes the file, all of it or nothing. What
/// people should know goes to `problems`. The report's numbers are those of what was written; with `from` nothing but
/// the counts. Fails as bad_input, as cannot_write where the output is an input or cannot be written, as usage where it
/// does not end in .glb, as interrupted.
Result<AutomaticWeightReport> bind_mesh(const BindMeshOptions& options, std::vector<std::string>& problems);

}  // namespace sinew
