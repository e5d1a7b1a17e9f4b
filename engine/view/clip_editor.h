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
  /// How far the samples are from the edited curve, degrees.
  struct Residual {
    std::vector<double> values;       ///< [frames] sample less curve
    double rms = 0.0, largest = 0.0;  ///< root mean square, largest size
  };
  const Residual& residual(const CurveChoice& choice) const;

  // Edits, each of apply_edits()'. Setting the same key again replaces what was done to it before, until seal(). Each
  // fails as apply_edits() does, and then nothing has changed.
  /// `seconds`: where the key goes, held a frame away from its neighbours; the ends stay where they are.
  Result<void> set_key(const CurveChoice& choice, std::size_t key, double value, std::optional<double> slope = {},
                       std::optional<double> seconds = {});
  Result<void> add_key(const CurveChoice& choice, double seconds);
  Result<void> delete_key(const CurveChoice& choice, std::size_t key);
  /// Ends a drag: the next edit of the same key is one of its own.
  void seal() { dragged_.reset(); }

  bool is_edited() const { return !edits_.empty(); }
  /// Takes the last edit back, a drag as a whole.
  void take_back();
  const nlohmann::json& edits() const { return edits_; }

 private:
  /// A key while it is dragged.
  struct DraggedKey {
    CurveChoice choice;
    std::size_t key = 0;
    std::optional<double> slope{};  ///< that the drag gave it
    bool is(const CurveChoice& c, std::size_t k) const { return choice == c && key == k; }
  };
  nlohmann::json edit_of(const char* operation, const CurveChoice& choice, double seconds) const;
  /// Adds a step; `replaces`: in place of the last one.
  Result<void> add(const nlohmann::json& edits, bool replaces);

  StoredClip clip_;
  MotionSamples samples_;
  std::vector<double> times_;
  mutable std::vector<double> values_;        ///< of `shown_`
  mutable std::optional<CurveChoice> shown_;  ///< whose samples were asked for last
  mutable Residual residual_;                 ///< of the curve `residual_of_` as it is now
  mutable std::optional<CurveChoice> residual_of_;
  std::vector<EditedMotion> steps_;  ///< [steps + 1] the curves before the first step and after each
  std::vector<std::size_t> begins_;  ///< [steps] the number of edits before each
  nlohmann::json edits_ = nlohmann::json::array();
  std::optional<DraggedKey> dragged_;
};

}  // namespace sinew
