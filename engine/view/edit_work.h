#pragma once
/// Edits that need what takes long — a model read, a head drawn, a motion put onto its model — made ready beside the
/// window. No interface here.

#include <deque>
#include <optional>
#include <string>

#include "engine/view/document.h"
#include "engine/view/task.h"

namespace sinew {

/// Edits wait here in their order while what the first one needs is made. Of edits of the same parts of a character,
/// such as those of one slider, the latest alone waits.
class EditWork {
 public:
  /// Takes an edit over if something has to be made for it, or if it must not overtake one that waits. What else has
  /// changed in the document when it is ready stays.
  bool take(const Document& document, const Scene& scene, const std::string& label, const std::string& merge);
  /// The same for undo() and redo().
  bool take_undo(const Document& document);
  bool take_redo(const Document& document);
  /// Takes back the edit that was asked for last, if nothing of it is shown yet; its label.
  std::optional<std::string> withdraw(const Document& document);

  /// What became of an edit.
  struct Done {
    Result<Touched> touched;
    std::string said;  ///< for people
  };
  /// Puts an edit that is ready into the document. Nothing where none is.
  std::optional<Done> finish(Document& document);
  /// Forgets all that waits.
  void drop();
  /// The slider was let go: the edits that merge end with the last that waits.
  void seal(Document& document);

  bool is_busy() const { return !waiting_.empty() || task_.running(); }
  /// The head that is asked for a character, not shown yet.
  std::optional<HeadSpec> wanted_head(std::size_t character) const;
  Task<StageParts>& task() { return task_; }

 private:
  enum class Kind { edit, undo, redo };
  struct Wanted {
    Kind kind = Kind::edit;
    Scene before{}, after{};  ///< of an edit: the document's scene when it was asked for, and what it should become
    std::string label, merge;
    bool seals = false;
  };
  bool take_step(const Document& document, Kind kind);
  bool waits_to_step() const;
  void enqueue(Wanted wanted);
  static Scene target(const Document& document, const Wanted& wanted);
  static Result<Touched> apply(Document& document, const Wanted& wanted);
  std::optional<Done> start(Document& document);

  std::deque<Wanted> waiting_;
  bool makes_first_ = false;  ///< task_ makes what the first of them needs; else what was dropped
  Task<StageParts> task_;
};

}  // namespace sinew
