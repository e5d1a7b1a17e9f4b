#pragma once
/// Files that grow out of sight and appear under their names when they are complete.

#include <filesystem>
#include <span>
#include <string_view>

#include "engine/core/result.h"

namespace sinew {

/// An empty hidden file beside the one that it is to become, removed with this object unless it appeared. It is locked
/// (flock) for as long as this object lives: that tells it from what a killed program left, on every machine that
/// shares the folder.
class TemporaryFile {
 public:
  /// Fails as cannot_write.
  static Result<TemporaryFile> create(const std::filesystem::path& file);

  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile();

  /// Its own name, for those that write it by name.
  const std::filesystem::path& path() const { return path_; }
  /// Appends. Fails as cannot_write.
  Result<void> write(std::span<const unsigned char> data);
  /// Flushes to the disk and renames. Fails as cannot_write; what stood under the name before is then still there. To
  /// be called once.
  Result<void> appear();

 private:
  TemporaryFile(std::filesystem::path file, std::filesystem::path path, int descriptor)
      : file_(std::move(file)), path_(std::move(path)), descriptor_(descriptor) {}

  std::filesystem::path file_;
  std::filesystem::path path_;  ///< empty: nothing is left to remove
  int descriptor_ = -1;
};

/// Removes the temporaries that killed programs left beside `pattern`, a file's name or that of a sequence
/// ("out/x_####.png"): its own and no other's, and none that a running program still writes. What cannot be removed or
/// locked stays.
void remove_stale_temporaries(std::string_view pattern);

}  // namespace sinew
