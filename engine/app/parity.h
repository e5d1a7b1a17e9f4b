#pragma once
/// The compute pass against the double-precision reference, every vertex of every frame.

#include "engine/app/stage.h"
#include "engine/core/progress.h"
#include "engine/gpu/gpu_deformer.h"

namespace sinew {

struct ParityOptions {
  SceneOptions scene;
  double tolerance = 1e-5;  ///< of the position error over the box's diagonal
  double normal_tolerance_degrees = 0.1;
  BufferLayout layout = BufferLayout::automatic;
  ProgressStyle progress = ProgressStyle::automatic;
};

/// Normals at vertices whose blended matrix is nearly singular (a twist by almost half a turn, say) are
/// ill-conditioned: they may be off by this much.
constexpr double singular_normal_tolerance_degrees = 2.0;

struct ParityReport {
  std::size_t frames = 0, vertices = 0;
  double max_position_error = 0.0, rms_position_error = 0.0;  ///< world units
  double max_normal_error_degrees = 0.0;                      ///< where the blend is regular
  std::size_t singular_normals = 0;                           ///< over all frames
  double max_singular_normal_error_degrees = 0.0;
  double max_height_error = 0.0;  ///< of the bulge, world units
  double bbox_diagonal = 0.0;     ///< of the reference's vertices over all frames
  double relative_error = 0.0;
  bool pass = false;
};

/// Fails only where a frame cannot be computed; what the comparison says is in the report.
Result<ParityReport> compare_with_reference(Device& device, const Stage& stage, const ParityOptions& options);

}  // namespace sinew
