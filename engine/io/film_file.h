#pragma once
/// A file that grows out of sight and appears under its name when it is complete.

#include <filesystem>
#include <utility>

#include "engine/core/result.h"

namespace sinew {

/// An empty temporary beside `file`, hidden, removed with this object unless it was put under its final name.
class HiddenFile {
 public:
  /// Fails as cannot_write.
  static Result<HiddenFile> create(const std::filesystem::path& file);

  HiddenFile(HiddenFile&& other) noexcept;
  HiddenFile& operator=(HiddenFile&&) = delete;
  ~HiddenFile();

  const std::filesystem::path& path() const { return path_; }
  /// Flushes to the disk and renames. Fails as cannot_write; the temporary is then still there. To be called once.
  Result<void> appear();

 private:
  HiddenFile(std::filesystem::path file, std::filesystem::path path) : file_(std::move(file)), path_(std::move(path)) {}

  std::filesystem::path file_;
  std::filesystem::path path_;  ///< empty: nothing is left to remove
};

}  // namespace sinew
