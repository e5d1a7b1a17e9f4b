#pragma once
/// The motion library as a viewer shows it: clips found, one of them open, its curves fitted and edited. What takes
/// long runs beside the window. No Vulkan and no window here.

#include <memory>
#include <string>
#include <vector>

#include "engine/view/clip_editor.h"
#include "engine/view/task.h"

namespace sinew {

class MotionBrowser {
 public:
  /// An empty path is the user's own library. Lists it anew where it is another one.
  void use_library(const std::filesystem::path& library);
  const std::filesystem::path& library() const { return library_; }

  ClipQuery query;  ///< name, tag, emotion; changed by whoever shows it, then refresh()
  /// Reads the list again.
  void refresh();
  const std::vector<ClipEntry>& clips() const { return clips_; }
  /// Of all clips of the library, in alphabetical order.
  const std::vector<std::string>& tags() const { return tags_; }
  /// Why there is no list; empty where there is one.
  const std::string& trouble() const { return trouble_; }

  /// Opens a clip, beside the window. Edits of another that are not saved are dropped.
  void open(const std::string& clip);
  /// Fits the open clip within so many degrees and keeps its curves in the library. Edits are dropped.
  void fit(double tolerance);
  /// Adds the open clip with its edits to the library under another name, and opens that.
  void save_as(const std::string& name);

  Task<StoredClip>& task() { return task_; }
  /// Takes in what was done beside the window; true where anything is different now.
  bool poll();

  const StoredClip* clip() const { return clip_.get(); }
  /// Nothing where no clip is open, or it has no curves yet.
  ClipEditor* editor() { return editor_.get(); }

  /// What poll() has to say to the user, once.
  struct News {
    std::string message;
    bool is_error = false;
    std::string saved;  ///< the clip that save_as() made
  };
  std::optional<News> take_news() { return std::exchange(news_, std::nullopt); }

 private:
  std::filesystem::path library_;
  bool listed_ = false, tags_stale_ = true;
  std::vector<ClipEntry> clips_;
  std::vector<std::string> tags_;
  std::string trouble_;
  std::unique_ptr<StoredClip> clip_;
  std::unique_ptr<ClipEditor> editor_;
  Task<StoredClip> task_;
  bool saving_ = false;
  std::optional<News> news_;
};

}  // namespace sinew
