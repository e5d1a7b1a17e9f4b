#pragma once
/// A clip of the motion library while its curves are edited: what is dragged is shown at once, and saved as a new clip
/// that names its parent. No Vulkan and no window here.

#include <optional>
#include <string>
#include <vector>

#include "engine/motion/key_edit.h"
#include "engine/motion/library.h"
#include "engine/motion/motion_edit.h"

namespace sinew {

/// One curve of a clip.
struct CurveChoice {
  std::size_t joint = 0;
  int axis = 0;  ///< 0 to 2 for x to z
  bool operator==(const CurveChoice&) const = default;
};

class ClipEditor {
 public:
  /// Edits `clip`, which has curves.
  explicit ClipEditor(StoredClip clip);

  const StoredClip& clip() const { return clip_; }
  const std::string& name() const { return clip_.entry.name; }

  /// The curve as edited, degrees over seconds.
  const PiecewisePolynomial& curve(const CurveChoice& choice) const;
  /// The parent's samples in the curve's own angles, [frames]; and their times.
  const std::vector<double>& samples(const CurveChoice& choice) const;
  const std::vector<double>& times() const { return times_; }
  /// Root mean square and largest difference of the edited curve from the samples, degrees.
  double rms_residual(const CurveChoice& choice) const;
  double largest_residual(const CurveChoice& choice) const;

  // Edits, each one of apply_edits()'. Setting the same key again replaces the edit before. Each fails as apply_edits()
  // does, and then nothing has changed.
  Result<void> set_key(const CurveChoice& choice, std::size_t key, double value, std::optional<double> slope = {});
  Result<void> move_key(const CurveChoice& choice, std::size_t key, double seconds);
  Result<void> add_key(const CurveChoice& choice, double seconds);
  Result<void> delete_key(const CurveChoice& choice, std::size_t key);
  /// Ends a drag: the next edit of the same key is one of its own.
  void seal() { merges_ = false; }

  bool is_edited() const { return !edits_.empty(); }
  /// Takes the last edit back.
  void take_back();
  const nlohmann::json& edits() const { return edits_; }

 private:
  nlohmann::json edit_of(const char* operation, const CurveChoice& choice, std::size_t key) const;
  bool continues_last(const nlohmann::json& edit) const;
  Result<void> add(nlohmann::json edit, bool merges);

  StoredClip clip_;
  MotionSamples samples_;
  std::vector<double> times_;
  mutable std::vector<double> values_;        ///< of `shown_`
  mutable std::optional<CurveChoice> shown_;  ///< whose samples were asked for last
  std::vector<EditedMotion> steps_;           ///< [edits + 1] the curves before the first edit and after each
  nlohmann::json edits_ = nlohmann::json::array();
  bool merges_ = false;
};

}  // namespace sinew
