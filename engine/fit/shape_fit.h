#pragma once
/// The weights of one shape from examples, and what is to be said of them.

#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/fit/skin_fit.h"
#include "engine/fit/skinned_shape.h"
#include "engine/model/model.h"

namespace sinew {

struct FitOptions {
  std::size_t influences = 4;  ///< at most so many bones a vertex, 1 to max_influences
  FitMethod method = FitMethod::convex;
  ProgressStyle progress = ProgressStyle::none;
};

struct WorstVertex {
  std::size_t vertex = 0;  ///< counted over all skinned meshes in the scene's order
  std::string mesh;
  double rmse = 0.0;  ///< over the poses
};

struct ShellResidual {
  std::string mesh;  ///< of its first vertex
  std::size_t vertices = 0;
  double rmse = 0.0;
};

/// Lengths in world units; errors are 3-D distances of the fitted weights to the examples.
struct FitReport {
  std::size_t vertices = 0, poses = 0, bones = 0, max_influences = 0;
  double rmse = 0.0, max_error = 0.0, diagonal = 0.0, height = 0.0;
  double test_rmse = 0.0;     ///< in poses that were held back; 0 where there are none
  double noise = 0.0;         ///< sigma as the fit sees it, the largest of all skins'
  double milliseconds = 0.0;  ///< of the fit alone
  std::size_t negative = 0, undetermined = 0;
  std::vector<WorstVertex> worst;     ///< at most ten, the worst first
  std::vector<ShellResidual> shells;  ///< the worst first
  std::vector<std::string> reasons;   ///< what keeps weights open, for people

  /// Takes in the sizes of a box round the rest mesh.
  void measure(const Bounds& rest);
};

/// Fits a shape of `model` to `wanted` ([vertices * poses], vertex after vertex) and adds what there is to say to the
/// report, whose rmse is that of all shapes so far. Fails as bad_input naming the model and the skin; as interrupted.
Result<Influences> fit_shape(const Model& model, const SkinnedShape& shape, const BonePoses& bones,
                             std::span<const Vec3> wanted, const FitOptions& options, FitReport& report);

/// Adds to the report how far `fitted` is from `wanted`, both as fit_shape() has them; `shell`: [vertices].
void report_errors(const Model& model, const SkinnedShape& shape, std::span<const Vec3> fitted,
                   std::span<const Vec3> wanted, std::span<const std::uint32_t> shell, FitReport& report);

double squared_distance(const Vec3& a, const Vec3& b);

}  // namespace sinew
