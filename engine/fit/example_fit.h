#pragma once
/// Skin weights from example poses that lie in files.

#include <filesystem>
#include <string>

#include "engine/fit/example_poses.h"
#include "engine/fit/shape_fit.h"
#include "engine/model/scene.h"

namespace sinew {

struct ExampleFitOptions : FitOptions {
  std::filesystem::path rest;  ///< .obj, .ply or glTF: the mesh where the skeleton's rest pose has it
  ExampleFiles poses;
  std::filesystem::path skeleton;  ///< glTF with joints and a clip; empty: the animated poses, else the rest file
  ClipChoice clip = 0;             ///< of the skeleton
  std::size_t unknown_bones = 0;   ///< above 0: no skeleton is read, so many bones are found
  std::size_t iterations = 30;     ///< of that search, at most
};

/// A rest mesh with the weights that were found, on its skeleton with its clip.
struct ExampleFit {
  Model model;
  FitReport report;
};

/// Fails as bad_input where a file cannot be read, poses have other topology, there is no skeleton or no clip, the
/// examples are too few, or more bones were asked for than motions can be told apart; as interrupted.
Result<ExampleFit> fit_examples(const ExampleFitOptions& options);

}  // namespace sinew
