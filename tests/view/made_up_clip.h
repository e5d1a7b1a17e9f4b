#pragma once
/// Clips of a motion library for tests.

#include "engine/motion/library_edit.h"
#include "tests/motion/made_up_motion.h"

namespace sinew::test {

inline StoredClip made_up_clip(const std::string& name, bool fitted, int frames = 90) {
  StoredClip clip;
  clip.entry.name = name;
  clip.entry.tags = {"calm"};
  clip.motion = made_up_motion(name, frames);
  if (!fitted) return clip;
  CurveFitOptions options;
  options.tolerance = 0.2;
  clip.curves = fit_motion(clip.motion, options).clip;
  return clip;
}

inline std::vector<double> sampled(const PiecewisePolynomial& curve) {
  std::vector<double> values;
  for (double t = 0.0; t <= curve.end(); t += 0.01) values.push_back(curve.value(t));
  return values;
}

}  // namespace sinew::test
