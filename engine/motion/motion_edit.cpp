#include "engine/motion/motion_edit.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/core/text.h"
#include "engine/io/json_reader.h"
#include "engine/motion/frame_edit.h"
#include "engine/motion/key_edit.h"
#include "engine/rig/motion_rig.h"

namespace sinew {
namespace {

const std::vector<std::string> axis_names{"x", "y", "z"};

/// The curves that an edit names.
struct Target {
  AxisCurves* curves = nullptr;
  std::optional<std::size_t> axis;

  bool has(std::size_t a) const { return !axis || *axis == a; }
  PiecewisePolynomial& curve() const { return (*curves)[*axis]; }
};

std::optional<Target> target_of(EditedMotion& motion, const JsonValue& edit, bool with_axis) {
  Target target;
  const auto joint = edit.require("joint", "a joint's name, or \"root\"");
  const auto axis = with_axis ? edit.require("axis", "x, y or z") : edit.find("axis");
  if (axis) target.axis = axis->word(axis_names);
  if (!joint || (with_axis && !axis)) return std::nullopt;
  const std::string name = joint->text("a joint's name, or \"root\"");
  if (name == "root") {
    target.curves = &motion.curves.root;
    return target;
  }
  const auto found = find_motion_joint(motion.skeleton, name);
  if (!found) {
    joint->error(found.error().message);
    return std::nullopt;
  }
  target.curves = &motion.curves.joints[*found].angles;
  return target;
}

double number_of(const JsonValue& edit, const std::string& key, const NumberRange& range = {}) {
  const auto value = edit.require(key, "a number");
  return value ? value->number(range) : std::max(range.low, 0.0);
}

std::optional<double> number_if(const JsonValue& edit, const std::string& key) {
  const auto value = edit.find(key);
  if (!value) return std::nullopt;
  return value->number();
}

void edit_key(EditedMotion& motion, const JsonValue& edit, const std::string& operation) {
  const auto target = target_of(motion, edit, true);
  const double time = number_of(edit, "time");
  if (!target) return;
  PiecewisePolynomial& curve = target->curve();
  const double reach = 0.5 * motion.curves.frame_time;
  auto key = find_key(curve, time, reach);
  if (operation == "add_key") {
    if (key) return edit.error(fmt::format("there is a key at {:.4f} s already", curve.cuts[*key]));
    if (time <= curve.begin() || time >= curve.end())
      return edit.error(fmt::format("time {} is outside the clip's {} to {} s", time, curve.begin(), curve.end()));
    key = add_key(curve, time);
    if (const auto value = number_if(edit, "value"))
      set_key(curve, *key, *value, number_if(edit, "slope"));
    else if (const auto slope = number_if(edit, "slope"))
      set_key(curve, *key, curve.value(time), *slope);
    return;
  }
  if (!key) return edit.error(key.error().message);
  if (operation == "set_key") return set_key(curve, *key, number_of(edit, "value"), number_if(edit, "slope"));
  if (*key == 0 || *key == curve.segments()) return edit.error("the key is an end of the clip; those stay");
  if (operation == "delete_key") return delete_key(curve, *key);
  const double to = number_of(edit, "to");
  if (to <= curve.cuts[*key - 1] || to >= curve.cuts[*key + 1])
    return edit.error(fmt::format("expected \"to\" between its neighbours at {:.4f} and {:.4f} s", curve.cuts[*key - 1],
                                  curve.cuts[*key + 1]));
  move_key(curve, *key, to);
}

void scale(EditedMotion& motion, const JsonValue& edit) {
  const auto target = target_of(motion, edit, false);
  const double factor = number_of(edit, "factor", {-1000.0, 1000.0});
  for (std::size_t axis = 0; target && axis < 3; ++axis) {
    if (!target->has(axis)) continue;
    PiecewisePolynomial& curve = (*target->curves)[axis];
    const double first = curve.value(curve.begin());
    for (auto& segment : curve.coefficients) {
      for (double& c : segment) c *= factor;
      segment[0] += first * (1.0 - factor);
    }
  }
}

void offset(EditedMotion& motion, const JsonValue& edit) {
  const auto target = target_of(motion, edit, true);
  const double degrees = number_of(edit, "degrees");
  if (!target) return;
  for (auto& segment : target->curve().coefficients) segment[0] += degrees;
}

template <class Change>
void change_all(CurveClip& clip, const Change& change) {
  for (JointCurves& joint : clip.joints)
    for (PiecewisePolynomial& curve : joint.angles) change(curve);
  for (PiecewisePolynomial& curve : clip.root) change(curve);
}

void stretch(EditedMotion& motion, const JsonValue& edit) {
  const double factor = number_of(edit, "factor", {0.01, 100.0});
  // The new end is a whole frame.
  const double frames = std::max(1.0, std::round(motion.curves.duration() * factor / motion.curves.frame_time));
  const double exact = frames * motion.curves.frame_time / motion.curves.duration();
  change_all(motion.curves, [&](PiecewisePolynomial& curve) {
    for (double& cut : curve.cuts) cut *= exact;
  });
}

void crop(EditedMotion& motion, const JsonValue& edit) {
  const double frame = motion.curves.frame_time, end = motion.curves.end();
  const double from = std::round(number_of(edit, "from", {0.0, end}) / frame) * frame;
  const double to = std::min(std::round(number_of(edit, "to", {0.0, end}) / frame) * frame, end);
  if (to < from + 0.5 * frame) return edit.error("expected \"to\" a frame or more after \"from\"");
  change_all(motion.curves, [&](PiecewisePolynomial& curve) { curve = part_of(curve, from, to, -from); });
}

void apply_one(EditedMotion& motion, const JsonValue& edit, const ClipSource& clips) {
  const auto name = edit.require("operation", fmt::format("one of {}", fmt::join(edit_operations(), ", ")));
  if (!name) return;
  const std::string operation = edit_operations()[name->word(edit_operations())];
  if (operation.ends_with("_key")) return edit_key(motion, edit, operation);
  if (operation == "scale") return scale(motion, edit);
  if (operation == "offset") return offset(motion, edit);
  if (operation == "warp" && !edit.find("times")) return stretch(motion, edit);
  if (operation == "crop") return crop(motion, edit);
  edit_frames(motion, edit, operation, clips);
}

}  // namespace

std::span<const std::string> edit_operations() {
  static const std::vector<std::string> names{"set_key", "add_key", "move_key", "delete_key", "scale", "offset", "warp",
                                              "crop",    "loop",    "join",     "cross_fade", "layer", "mirror"};
  return names;
}

Result<int> find_motion_joint(const MotionSkeleton& skeleton, const std::string& name) {
  const MotionRig rig = motion_rig({"", skeleton, 1.0, {rest_frame(skeleton)}, {}});
  auto node = find_joint(rig.model, rig.humanoid, name);
  if (!node) return bad_input("{}", node.error().message);
  if (*node >= static_cast<int>(skeleton.joints.size())) return bad_input("\"{}\" is a bone's end, no joint", name);
  return *node;
}

Result<void> apply_edits(EditedMotion& motion, const nlohmann::json& edits, const ClipSource& clips) {
  JsonReport report("edit");
  const JsonValue list(edits, report);
  if (!list.expect_list(1, 10000, "a list of edits")) return tl::unexpected<Error>(*report.error());
  EditedMotion trial = motion;
  for (std::size_t i = 0; i < list.size(); ++i) {
    apply_one(trial, list.item(i), clips);
    if (report.error()) return tl::unexpected<Error>(*report.error());
  }
  motion = std::move(trial);
  return {};
}

}  // namespace sinew
