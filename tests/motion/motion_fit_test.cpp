#include "engine/motion/motion_fit.h"
#include "engine/motion/motion_bench.h"

#include <iostream>

#include <gtest/gtest.h>

#include "engine/rig/motion_file.h"
#include "tests/support/assets.h"

namespace sinew {
namespace {

TEST(MotionFit, HoldsHalfADegreeOfCapturesInFewNumbers) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "SKIPPED: minutes under the sanitizers, where smaller cases run";
#endif
  SINEW_ASSETS_OR_SKIP(assets);
  for (const char* file : {"01_01.bvh", "cmu_12_01_walk.bvh", "cmu_asfamc/02_01.amc"}) {
    const auto motion = read_motion(assets / "motions" / file);
    ASSERT_TRUE(motion) << motion.error().message;
    CurveFitOptions options;
    options.tolerance = 0.5;
    const MotionFit fit = fit_motion(*motion, options);
    std::size_t segments = 0;
    for (const CurveReport& curve : fit.curves) {
      EXPECT_LE(curve.max_degrees, 0.5) << file << " joint " << curve.joint;
      segments = std::max(segments, curve.segments);
    }
    const double share = static_cast<double>(fit.stored_numbers) / static_cast<double>(fit.sampled_numbers);
    // 0.11 to 0.14 are measured.
    EXPECT_LE(share, 0.15) << file;
    EXPECT_LE(fit.root_error, root_tolerance(motion->skeleton, 0.5));
    double jump = 0.0, distance = 0.0;
    for (const JointCurves& joint : fit.clip.joints)
      for (const PiecewisePolynomial& curve : joint.angles) jump = std::max(jump, curve.largest_jump().value);
    EXPECT_LE(jump, 1e-9);
    MotionFrame frame;
    for (std::size_t i = 0; i < motion->frames.size(); ++i) {
      sample_curves(fit.clip, motion->skeleton, static_cast<double>(i) * motion->frame_time, frame);
      distance = std::max(distance, largest_joint_distance(motion->skeleton, motion->frames[i], frame));
    }
    std::cout << fmt::format(
        "{}: {} frames, {} joints, {:.0f} ms, {:.1f} % stored, most segments {}, joints {:.4f} of "
        "the body's size off\n",
        file, motion->frames.size(), motion->skeleton.joints.size(), fit.ms, 100.0 * share, segments,
        distance / skeleton_size(motion->skeleton));
    const MotionFit plain = fit_motion(*motion, {});
    std::cout << fmt::format(
        "  by its noise: {:.0f} ms, {:.1f} % stored\n", plain.ms,
        100.0 * static_cast<double>(plain.stored_numbers) / static_cast<double>(plain.sampled_numbers));
  }
}

TEST(MotionFit, KeepsTheCurvesOfOtherJoints) {
  const Motion motion = made_up_motion(6, 100);
  CurveFitOptions close;
  close.tolerance = 0.1;
  const MotionFit before = fit_motion(motion, close);
  KeptCurves kept{before.clip, std::vector<bool>(6, true)};
  kept.joints[2] = false;
  CurveFitOptions coarse;
  coarse.segments = 2;
  coarse.degree = 3;
  const MotionFit after = fit_motion(motion, coarse, &kept), alone = fit_motion(motion, coarse);
  for (std::size_t j = 0; j < 6; ++j)
    for (int axis = 0; axis < 3; ++axis) {
      const MotionFit& from = j == 2 ? alone : before;
      EXPECT_EQ(after.clip.joints[j].angles[axis].coefficients, from.clip.joints[j].angles[axis].coefficients);
      EXPECT_EQ(after.curves[3 * j + axis].max_degrees, from.curves[3 * j + axis].max_degrees);
    }
  EXPECT_EQ(after.clip.root[2].coefficients, before.clip.root[2].coefficients);
  EXPECT_NE(after.stored_numbers, before.stored_numbers);
}

TEST(MotionFit, PlaysAPoseOfManyJointsInMicroseconds) {
  const Motion motion = made_up_motion(68, 300);
  CurveFitOptions options;
  options.tolerance = 0.5;
  const MotionFit fit = fit_motion(motion, options);
  const double us = pose_microseconds(fit.clip, motion.skeleton);
  std::cout << fmt::format("a pose of 68 joints: {:.1f} us; {:.1f} % stored\n", us,
                           100.0 * static_cast<double>(fit.stored_numbers) / static_cast<double>(fit.sampled_numbers));
  // Ten times what a free core takes, for machines that are busy and builds that are checked.
  EXPECT_LT(us, 2000.0);
}

}  // namespace
}  // namespace sinew
