#include "engine/core/temporary_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string>

#include "engine/core/frame_range.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view ending = ".part";

/// The process' number only makes names differ: it says nothing about who is alive, since other machines may write to
/// the same folder and numbers come again.
fs::path next_name(const fs::path& file) {
  static std::atomic<unsigned> counter{0};
  return file.parent_path() / fmt::format(".{}.{}-{}{}", file.filename().string(), ::getpid(), counter++, ending);
}

bool is_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// The name that a temporary was to have: "x.png" of ".x.png.12-3.part".
std::optional<std::string> name_to_be(std::string_view name) {
  if (!name.starts_with('.') || !name.ends_with(ending)) return std::nullopt;
  name = name.substr(1, name.size() - 1 - ending.size());
  const auto dot = name.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const std::string_view numbers = name.substr(dot + 1);
  const auto dash = numbers.find('-');
  if (dash == std::string_view::npos || !is_digits(numbers.substr(0, dash)) || !is_digits(numbers.substr(dash + 1)))
    return std::nullopt;
  return std::string(name.substr(0, dot));
}

/// Locked and still there: a program that tidies up may have taken the file for a dead one's before it was locked. A
/// file system without locks does not matter, since there nothing is ever taken for stale.
bool hold(int descriptor) {
  while (::flock(descriptor, LOCK_EX) != 0 && errno == EINTR) {
  }
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

void remove_if_stale(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return;
  struct stat status {};
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
    ::unlink(file.c_str());
  ::close(descriptor);
}

}  // namespace

Result<TemporaryFile> TemporaryFile::create(const fs::path& file) {
  while (true) {
    fs::path path = next_name(file);
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == EEXIST) continue;
    if (descriptor < 0)
      return failure(ErrorKind::cannot_write, "{}: cannot be created: {}", file.string(), std::strerror(errno));
    if (hold(descriptor)) return TemporaryFile(file, std::move(path), descriptor);
    ::close(descriptor);
  }
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : file_(std::move(other.file_)),
      path_(std::exchange(other.path_, fs::path())),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

TemporaryFile::~TemporaryFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<void> TemporaryFile::write(std::span<const unsigned char> data) {
  while (!data.empty()) {
    const ssize_t written = ::write(descriptor_, data.data(), data.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0)
      return failure(ErrorKind::cannot_write, "{}: cannot be written: {}", file_.string(), std::strerror(errno));
    data = data.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

Result<void> TemporaryFile::appear() {
  // Network file systems tell of late write errors when a descriptor is closed, the lock must outlive the renaming.
  const int second = ::dup(descriptor_);
  const bool complete =
      ::fsync(descriptor_) == 0 && second >= 0 && ::close(second) == 0 && ::rename(path_.c_str(), file_.c_str()) == 0;
  if (!complete)
    return failure(ErrorKind::cannot_write, "{}: cannot be written: {}", file_.string(), std::strerror(errno));
  path_.clear();
  return {};
}

void remove_stale_temporaries(std::string_view pattern) {
  const fs::path wanted(pattern);
  const fs::path folder = wanted.has_parent_path() ? wanted.parent_path() : fs::path(".");
  const std::string name = wanted.filename().string();
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const auto to_be = name_to_be(entry->path().filename().string());
    if (to_be && is_frame_file_name(name, *to_be)) remove_if_stale(entry->path());
  }
}

}  // namespace sinew
