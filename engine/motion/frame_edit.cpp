#include "engine/motion/frame_edit.h"

#include <algorithm>
#include <cmath>

#include "engine/motion/motion_blend.h"
#include "engine/motion/motion_fit.h"
#include "engine/rig/motion_rig.h"

namespace sinew {
namespace {

constexpr std::size_t most_frames = 1'000'000;

std::optional<double> seconds_of(const JsonValue& edit, const std::string& key, double low, double high) {
  const auto value = edit.require(key, "seconds");
  if (!value) return std::nullopt;
  return value->number({low, high});
}

/// The clip that an edit names, its joints those of `motion`.
std::optional<Motion> other_clip(const EditedMotion& motion, const JsonValue& edit, const ClipSource& clips) {
  const auto name = edit.require("clip", "a clip's name");
  if (!name) return std::nullopt;
  const std::string text = name->text("a clip's name");
  if (text.empty()) return std::nullopt;
  auto other = clips(text);
  if (!other) {
    name->error(other.error().message);
    return std::nullopt;
  }
  const auto& own = motion.skeleton.joints;
  const auto& joints = other->skeleton.joints;
  const bool same =
      std::equal(own.begin(), own.end(), joints.begin(), joints.end(),
                 [](const MotionJoint& a, const MotionJoint& b) { return a.name == b.name && a.parent == b.parent; });
  if (!same) {
    name->error(fmt::format("clip \"{}\" has other joints; expected a clip of the same skeleton", text));
    return std::nullopt;
  }
  return sampled_motion(other->curves, other->skeleton, text);
}

Vec3 up_of(const Motion& motion) { return motion_rig(motion).up; }

std::optional<Motion> warped(const Motion& motion, const JsonValue& edit) {
  const auto list = edit.find("times");
  if (!list->expect_list(2, 100000, "two or more pairs [from, to], rising")) return std::nullopt;
  std::vector<std::pair<double, double>> pairs;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const auto pair = list->item(i).numbers(2, "[from, to]", {0.0, 1e6});
    if (!pairs.empty() && (pair[0] < pairs.back().first || pair[1] <= pairs.back().second)) {
      list->item(i).error("expected both times later than in the pair before");
      return std::nullopt;
    }
    pairs.emplace_back(pair[0], pair[1]);
  }
  if (pairs.front().second != 0.0) {
    list->item(0).error("expected 0 as the first \"to\": the new clip begins there");
    return std::nullopt;
  }
  return resampled(motion, pairs.back().second, [&](double t) {
    const auto later = std::find_if(pairs.begin() + 1, pairs.end() - 1, [&](const auto& p) { return t <= p.second; });
    const auto& [from0, to0] = *(later - 1);
    const auto& [from1, to1] = *later;
    return from0 + (from1 - from0) * std::clamp((t - to0) / (to1 - to0), 0.0, 1.0);
  });
}

std::optional<Motion> layer(const EditedMotion& edited, const Motion& motion, const JsonValue& edit,
                            const ClipSource& clips) {
  const auto other = other_clip(edited, edit, clips);
  const auto list = edit.require("joints", "a list of joints");
  if (!other || !list || !list->expect_list(1, 4096, "a list of joints")) return std::nullopt;
  std::vector<int> roots;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const auto joint = find_motion_joint(motion.skeleton, list->item(i).text("a joint's name"));
    if (!joint) {
      list->item(i).error(joint.error().message);
      return std::nullopt;
    }
    roots.push_back(*joint);
  }
  return layered(motion, *other, roots);
}

std::optional<Motion> edited_frames(const EditedMotion& edited, const JsonValue& edit, const std::string& operation,
                                    const ClipSource& clips) {
  const Motion motion = sampled_motion(edited.curves, edited.skeleton, "");
  const double length = motion.duration();
  if (operation == "mirror") return mirrored(motion);
  if (operation == "warp") return warped(motion, edit);
  if (operation == "layer") return layer(edited, motion, edit, clips);
  if (operation == "loop") {
    const auto count = edit.require("count", "how often");
    const auto blend = seconds_of(edit, "blend", 0.0, 0.5 * length);
    if (!count || !blend) return std::nullopt;
    const int times = count->integer(2, 1000);
    if (motion.frames.size() * static_cast<std::size_t>(times) > most_frames) {
      count->error(fmt::format("the clip would have more than {} frames", most_frames));
      return std::nullopt;
    }
    return looped(motion, times, *blend, up_of(motion));
  }
  const auto other = other_clip(edited, edit, clips);
  if (!other) return std::nullopt;
  if (operation == "join") {
    const auto blend = seconds_of(edit, "blend", 0.0, std::min(length, other->duration()));
    if (!blend) return std::nullopt;
    return joined(motion, *other, *blend, up_of(motion));
  }
  const auto from = seconds_of(edit, "from", 0.0, length), to = seconds_of(edit, "to", 0.0, length);
  if (!from || !to) return std::nullopt;
  if (*to < *from) {
    edit.error("expected \"to\" after \"from\"");
    return std::nullopt;
  }
  return cross_faded(motion, *other, *from, *to);
}

}  // namespace

void edit_frames(EditedMotion& motion, const JsonValue& edit, const std::string& operation, const ClipSource& clips) {
  const auto frames = edited_frames(motion, edit, operation, clips);
  if (!frames) return;
  CurveFitOptions options;
  options.tolerance = refit_tolerance;
  motion.curves = fit_motion(*frames, options).clip;
}

}  // namespace sinew
