#include "engine/view/clip_editor.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sinew {
namespace {

const std::string axis_words[] = {"x", "y", "z"};

}  // namespace

ClipEditor::ClipEditor(StoredClip clip) : clip_(std::move(clip)), samples_(motion_samples(clip_.motion)) {
  assert(clip_.curves);
  // Angles are the curves' own: the fit may have chosen another order than the samples would today.
  for (std::size_t j = 0; j < clip_.curves->joints.size(); ++j) {
    const EulerOrder& order = clip_.curves->joints[j].order;
    if (!(samples_.joints[j].order == order))
      samples_.joints[j] = {order, angles_in_order(joint_turns(clip_.motion, j), order)};
  }
  times_ = samples_.times;
  steps_.push_back({clip_.motion.skeleton, *clip_.curves});
}

const PiecewisePolynomial& ClipEditor::curve(const CurveChoice& choice) const {
  return steps_.back().curves.joints[choice.joint].angles[choice.axis];
}

const std::vector<double>& ClipEditor::samples(const CurveChoice& choice) const {
  if (shown_ == choice) return values_;
  shown_ = choice;
  values_.clear();
  for (const Vec3& degrees : samples_.joints[choice.joint].degrees) values_.push_back(degrees[choice.axis]);
  // A curve and its samples may be whole turns apart.
  const PiecewisePolynomial& fitted = clip_.curves->joints[choice.joint].angles[choice.axis];
  const double turns = 360.0 * std::round((fitted.value(times_.front()) - values_.front()) / 360.0);
  for (double& value : values_) value += turns;
  return values_;
}

const ClipEditor::Residual& ClipEditor::residual(const CurveChoice& choice) const {
  if (residual_of_ == choice) return residual_;
  residual_of_ = choice;
  residual_ = {};
  const std::vector<double>& values = samples(choice);
  const PiecewisePolynomial& edited = curve(choice);
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double off = values[i] - edited.value(times_[i]);
    residual_.values.push_back(off);
    residual_.largest = std::max(residual_.largest, std::abs(off));
    sum += off * off;
  }
  residual_.rms = std::sqrt(sum / static_cast<double>(values.size()));
  return residual_;
}

nlohmann::json ClipEditor::edit_of(const char* operation, const CurveChoice& choice, double seconds) const {
  return {{"operation", operation},
          {"joint", clip_.motion.skeleton.joints[choice.joint].name},
          {"axis", axis_words[choice.axis]},
          {"time", seconds}};
}

Result<void> ClipEditor::add(const nlohmann::json& edits, bool replaces) {
  EditedMotion motion = replaces ? steps_[steps_.size() - 2] : steps_.back();
  if (auto ok = apply_edits(motion, edits, {}); !ok) return ok;
  if (replaces) {
    edits_.erase(edits_.begin() + static_cast<std::ptrdiff_t>(begins_.back()), edits_.end());
    steps_.pop_back();
  } else {
    begins_.push_back(edits_.size());
  }
  edits_.insert(edits_.end(), edits.begin(), edits.end());
  steps_.push_back(std::move(motion));
  residual_of_.reset();
  return {};
}

Result<void> ClipEditor::set_key(const CurveChoice& choice, std::size_t key, double value, std::optional<double> slope,
                                 std::optional<double> seconds) {
  const bool goes_on = dragged_ && dragged_->is(choice, key);
  if (!goes_on) dragged_.reset();
  const std::vector<double>& cuts =
      (goes_on ? steps_[steps_.size() - 2] : steps_.back()).curves.joints[choice.joint].angles[choice.axis].cuts;
  nlohmann::json edits = nlohmann::json::array();
  double at = cuts[key];
  if (seconds && key > 0 && key + 1 < cuts.size()) {
    const double frame = clip_.motion.frame_time, low = cuts[key - 1] + frame, high = cuts[key + 1] - frame;
    const double to = low < high ? std::clamp(*seconds, low, high) : at;
    if (to != at) {
      nlohmann::json edit = edit_of("move_key", choice, at);
      edit["to"] = at = to;
      edits.push_back(std::move(edit));
    }
  }
  nlohmann::json edit = edit_of("set_key", choice, at);
  edit["value"] = value;
  // The slope stays what it was made by an earlier step of the same drag.
  if (!slope && goes_on) slope = dragged_->slope;
  if (slope) edit["slope"] = *slope;
  edits.push_back(std::move(edit));
  if (auto ok = add(edits, goes_on); !ok) return ok;
  dragged_ = DraggedKey{choice, key, slope};
  return {};
}

Result<void> ClipEditor::add_key(const CurveChoice& choice, double seconds) {
  seal();
  return add(nlohmann::json::array({edit_of("add_key", choice, seconds)}), false);
}

Result<void> ClipEditor::delete_key(const CurveChoice& choice, std::size_t key) {
  seal();
  return add(nlohmann::json::array({edit_of("delete_key", choice, curve(choice).cuts[key])}), false);
}

void ClipEditor::take_back() {
  if (begins_.empty()) return;
  edits_.erase(edits_.begin() + static_cast<std::ptrdiff_t>(begins_.back()), edits_.end());
  begins_.pop_back();
  steps_.pop_back();
  residual_of_.reset();
  seal();
}

}  // namespace sinew
