#include "engine/view/file_watch.h"

namespace sinew {
namespace {

constexpr std::chrono::milliseconds pause(250);

}  // namespace

void FileWatch::watch(const std::filesystem::path& file_or_folder) {
  watched_ = file_or_folder;
  seen_ = marks();
  next_ = {};
}

std::optional<FileWatch::Mark> FileWatch::mark(const std::filesystem::path& file) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  if (error) return std::nullopt;
  const auto size = std::filesystem::file_size(file, error);
  if (error) return std::nullopt;
  return Mark{time, size};
}

std::map<std::filesystem::path, FileWatch::Mark> FileWatch::marks() const {
  std::map<std::filesystem::path, Mark> found;
  if (watched_.empty()) return found;
  std::error_code error;
  if (!std::filesystem::is_directory(watched_, error)) {
    if (const auto now = mark(watched_)) found.emplace(watched_, *now);
    return found;
  }
  for (std::filesystem::directory_iterator at(watched_, error), end; !error && at != end; at.increment(error))
    if (const auto now = mark(at->path())) found.emplace(at->path(), *now);
  return found;
}

bool FileWatch::has_changed() {
  if (watched_.empty() || std::chrono::steady_clock::now() < next_) return false;
  next_ = std::chrono::steady_clock::now() + pause;
  bool changed = false;
  for (const auto& [file, now] : marks()) {
    const auto [seen, is_new] = seen_.try_emplace(file, now);
    if (!is_new && seen->second == now) continue;
    seen->second = now;
    changed = true;
  }
  return changed;
}

}  // namespace sinew
