#pragma once
/// Heads that are drawn beside the window while their sliders move. No interface here.

#include <future>
#include <optional>
#include <string>

#include "engine/view/document.h"

namespace sinew {

/// Draws the head that was asked for last; what was asked for meanwhile comes after it, the latest alone.
class HeadWork {
 public:
  /// Takes an edit over if it gives a character a head that must be drawn first; its other changes are left out.
  bool take(const Document& document, const Scene& scene, const std::string& label, const std::string& merge);
  /// Puts a head that is ready into the document. Nothing where none is, or where it was dropped meanwhile.
  std::optional<Result<Touched>> finish(Document& document);
  /// Forgets what was asked for.
  void drop() {
    wanted_.reset();
    drawn_.reset();
  }
  /// The slider was let go: the edits that merge end with the last head.
  void seal() { seals_ = true; }

  bool is_busy() const { return drawing_.valid(); }
  /// The head that is asked for, not shown yet.
  const HeadSpec* wanted() const { return wanted_ ? &wanted_->head : nullptr; }
  const std::string& label() const { return label_; }

 private:
  struct Wanted {
    std::size_t character;
    HeadSpec head;
    bool operator==(const Wanted&) const = default;
  };
  void start(const Document& document);

  std::optional<Wanted> wanted_;
  std::optional<Wanted> drawn_;  ///< what drawing_ draws, unless that was dropped
  std::string label_, merge_;
  bool seals_ = false;
  std::future<Result<StagedCharacter>> drawing_;
};

}  // namespace sinew
