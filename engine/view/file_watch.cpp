#include "engine/view/file_watch.h"

namespace sinew {
namespace {

constexpr std::chrono::milliseconds pause(250);

}  // namespace

void FileWatch::watch(const std::filesystem::path& file) {
  file_ = file;
  seen_ = mark();
  next_ = {};
}

std::optional<FileWatch::Mark> FileWatch::mark() const {
  if (file_.empty()) return std::nullopt;
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file_, error);
  if (error) return std::nullopt;
  const auto size = std::filesystem::file_size(file_, error);
  if (error) return std::nullopt;
  return Mark{time, size};
}

bool FileWatch::has_changed() {
  if (file_.empty() || std::chrono::steady_clock::now() < next_) return false;
  next_ = std::chrono::steady_clock::now() + pause;
  const auto now = mark();
  if (!now || now == seen_) return false;
  seen_ = now;
  return true;
}

}  // namespace sinew
