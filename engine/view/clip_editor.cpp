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

double ClipEditor::rms_residual(const CurveChoice& choice) const {
  const std::vector<double>& values = samples(choice);
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double off = values[i] - curve(choice).value(times_[i]);
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double ClipEditor::largest_residual(const CurveChoice& choice) const {
  const std::vector<double>& values = samples(choice);
  double largest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    largest = std::max(largest, std::abs(values[i] - curve(choice).value(times_[i])));
  return largest;
}

nlohmann::json ClipEditor::edit_of(const char* operation, const CurveChoice& choice, std::size_t key) const {
  return {{"operation", operation},
          {"joint", clip_.motion.skeleton.joints[choice.joint].name},
          {"axis", axis_words[choice.axis]},
          {"time", curve(choice).cuts[key]}};
}

/// True where the edit goes on with the drag that made the last one.
bool ClipEditor::continues_last(const nlohmann::json& edit) const {
  const auto same = [&](const char* key) { return edits_.back().at(key) == edit.at(key); };
  return merges_ && !edits_.empty() && same("operation") && same("joint") && same("axis") && same("time");
}

Result<void> ClipEditor::add(nlohmann::json edit, bool merges) {
  const bool replaces = merges && continues_last(edit);
  EditedMotion motion = replaces ? steps_[steps_.size() - 2] : steps_.back();
  if (auto ok = apply_edits(motion, nlohmann::json::array({edit}), {}); !ok) return ok;
  if (replaces) {
    edits_.back() = std::move(edit);
    steps_.back() = std::move(motion);
  } else {
    edits_.push_back(std::move(edit));
    steps_.push_back(std::move(motion));
  }
  merges_ = merges;
  return {};
}

Result<void> ClipEditor::set_key(const CurveChoice& choice, std::size_t key, double value,
                                 std::optional<double> slope) {
  nlohmann::json edit = edit_of("set_key", choice, key);
  edit["value"] = value;
  // The slope stays what it was made by an earlier step of the same drag.
  if (slope)
    edit["slope"] = *slope;
  else if (continues_last(edit) && edits_.back().contains("slope"))
    edit["slope"] = edits_.back()["slope"];
  return add(std::move(edit), true);
}

Result<void> ClipEditor::move_key(const CurveChoice& choice, std::size_t key, double seconds) {
  nlohmann::json edit = edit_of("move_key", choice, key);
  edit["to"] = seconds;
  return add(std::move(edit), false);
}

Result<void> ClipEditor::add_key(const CurveChoice& choice, double seconds) {
  nlohmann::json edit = edit_of("add_key", choice, 0);
  edit["time"] = seconds;
  return add(std::move(edit), false);
}

Result<void> ClipEditor::delete_key(const CurveChoice& choice, std::size_t key) {
  return add(edit_of("delete_key", choice, key), false);
}

void ClipEditor::take_back() {
  if (edits_.empty()) return;
  edits_.erase(edits_.size() - 1);
  steps_.pop_back();
  merges_ = false;
}

}  // namespace sinew
