#pragma once
/// Curves for every joint of a motion, and how well they do.

#include <optional>
#include <string>
#include <vector>

#include "engine/core/task_watch.h"
#include "engine/motion/curve_clip.h"
#include "engine/motion/curve_fit.h"

namespace sinew {

struct MotionFitOptions {
  CurveFitOptions curve;                 ///< tolerance and resolution in degrees
  std::optional<double> skin_tolerance;  ///< millimetres, > 0: the largest tolerance that keeps within it; then
                                         ///< `curve.tolerance` is the largest tried
};

struct CurveReport {
  std::size_t joint = 0;
  int axis = 0;
  std::size_t segments = 0;
  int degree = 0;
  double rmse_degrees = 0.0, max_degrees = 0.0;
};

struct MotionFit {
  CurveClip clip;
  std::vector<CurveReport> curves;  ///< of joints' angles, joints in order, x to z
  double root_error = 0.0;          ///< the largest of any axis, the skeleton's lengths
  double tolerance = 0.0;           ///< degrees that were held; 0: none was asked for
  std::size_t stored_numbers = 0, sampled_numbers = 0;
  double ms = 0.0;  ///< of the fit alone
};

/// A root's tolerance in place of degrees: what the angle moves at a quarter of the skeleton's size.
double root_tolerance(const MotionSkeleton& skeleton, double degrees);

/// Curves of the same motion that a fit leaves as they are.
struct KeptCurves {
  CurveClip curves;
  std::vector<bool> joints;  ///< [joints] whose; the root's are kept too
};

/// Fits all curves, but for those that are `kept`, on all cores.
MotionFit fit_motion(const Motion& motion, const CurveFitOptions& options, const KeptCurves* kept = nullptr);

/// The same, counted by joints. Fails as interrupted where it was cancelled.
Result<MotionFit> fit_motion(const Motion& motion, const CurveFitOptions& options, TaskWatch& watch);

/// Fails as usage with the option's name where one is out of its range.
Result<void> check_motion_fit_options(const MotionFitOptions& options);

}  // namespace sinew
