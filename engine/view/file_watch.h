#pragma once
/// Notices that a file on the disk, or one of a folder's, is another one now. No Vulkan here.

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>

namespace sinew {

class FileWatch {
 public:
  /// Watches this file, or the files that lie in this folder, from now on, as they are now; an empty path: none.
  void watch(const std::filesystem::path& file_or_folder);

  /// True once for all that has changed since watch() or the last change told. A file that has gone is no change:
  /// editors that write anew take the old one away first. Asks the disk four times a second at most.
  bool has_changed();

 private:
  struct Mark {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const Mark&) const = default;
  };
  static std::optional<Mark> mark(const std::filesystem::path& file);
  std::map<std::filesystem::path, Mark> marks() const;

  std::filesystem::path watched_;
  std::map<std::filesystem::path, Mark> seen_;  ///< of each file when it was last there
  std::chrono::steady_clock::time_point next_;
};

}  // namespace sinew
