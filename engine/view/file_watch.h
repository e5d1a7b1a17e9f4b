#pragma once
/// Notices that a file on the disk is another one now. No Vulkan here.

#include <chrono>
#include <filesystem>
#include <optional>

namespace sinew {

class FileWatch {
 public:
  /// Watches this file from now on, as it is now; an empty path: none.
  void watch(const std::filesystem::path& file);
  const std::filesystem::path& file() const { return file_; }

  /// True once for every change since watch() or the last change told. A file that has gone is no change: editors
  /// that write anew take the old one away first. Asks the disk four times a second at most.
  bool has_changed();

 private:
  struct Mark {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const Mark&) const = default;
  };
  std::optional<Mark> mark() const;

  std::filesystem::path file_;
  std::optional<Mark> seen_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace sinew
