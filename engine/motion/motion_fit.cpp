#include "engine/motion/motion_fit.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/motion/segment_tables.h"

namespace sinew {

double root_tolerance(const MotionSkeleton& skeleton, double degrees) {
  return 0.25 * skeleton_size(skeleton) * degrees * degrees_to_radians;
}

namespace {

Result<MotionFit> fitted(const Motion& motion, const CurveFitOptions& options, const KeptCurves* kept,
                         TaskWatch& watch) {
  const auto begun = std::chrono::steady_clock::now();
  const MotionSamples samples = motion_samples(motion);
  const std::size_t joints = samples.joints.size();
  SegmentTables tables(samples.times.size());
  MotionFit fit;
  fit.tolerance = options.tolerance.value_or(0.0);
  fit.clip.frame_time = motion.frame_time;
  fit.clip.joints.resize(joints);
  fit.curves.resize(3 * joints);
  watch.begin(joints);
  parallel_for(
      joints,
      [&](std::size_t j) {
        if (watch.is_cancelled()) return;
        JointCurves& curves = fit.clip.joints[j];
        curves.order = samples.joints[j].order;
        assert(!kept || !kept->joints[j] || kept->curves.joints[j].order == curves.order);
        std::vector<double> values(samples.times.size());
        for (int axis = 0; axis < 3; ++axis) {
          for (std::size_t i = 0; i < values.size(); ++i) values[i] = samples.joints[j].degrees[i][axis];
          CurveFit one = kept && kept->joints[j]
                             ? measured_curve(kept->curves.joints[j].angles[axis], samples.times, values)
                             : fit_curve(tables, samples.times, values, options);
          fit.curves[3 * j + axis] = {
              j, axis, one.curve.segments(), one.curve.degree(), one.rms_error, one.largest_error};
          curves.angles[axis] = std::move(one.curve);
        }
        watch.advance();
      },
      1);
  if (auto ok = watch.check(); !ok) return pass_on(std::move(ok));
  CurveFitOptions lengths = options;
  if (options.tolerance) lengths.tolerance = root_tolerance(motion.skeleton, *options.tolerance);
  lengths.resolution = root_tolerance(motion.skeleton, options.resolution);
  for (int axis = 0; axis < 3; ++axis) {
    CurveFit one = kept ? measured_curve(kept->curves.root[axis], samples.times, samples.root[axis])
                        : fit_curve(tables, samples.times, samples.root[axis], lengths);
    fit.root_error = std::max(fit.root_error, one.largest_error);
    fit.clip.root[axis] = std::move(one.curve);
  }
  fit.stored_numbers = fit.clip.stored_numbers();
  fit.sampled_numbers = samples.times.size() * 3 * (joints + 1);
  fit.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
  return fit;
}

}  // namespace

MotionFit fit_motion(const Motion& motion, const CurveFitOptions& options, const KeptCurves* kept) {
  TaskWatch watch;
  return *fitted(motion, options, kept, watch);
}

Result<MotionFit> fit_motion(const Motion& motion, const CurveFitOptions& options, TaskWatch& watch) {
  return fitted(motion, options, nullptr, watch);
}

Result<void> check_motion_fit_options(const MotionFitOptions& options) {
  if (options.skin_tolerance && !(*options.skin_tolerance > 0.0 && std::isfinite(*options.skin_tolerance)))
    return failure(ErrorKind::usage, "--skin-tolerance {}: expected millimetres above 0", *options.skin_tolerance);
  if (options.skin_tolerance && options.curve.segments)
    return failure(ErrorKind::usage, "--skin-tolerance needs --segments auto: more segments are how it is kept");
  return check_fit_options(options.curve);
}

}  // namespace sinew
