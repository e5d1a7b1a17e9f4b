#include "engine/io/film_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "engine/core/files.h"

namespace sinew {

namespace fs = std::filesystem;

Result<HiddenFile> HiddenFile::create(const fs::path& file) {
  if (auto ok = check_writable(file); !ok) return pass_on(std::move(ok));
  fs::path path = temporary_beside(file);
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0)
    return failure(ErrorKind::cannot_write, "{}: cannot be created: {}", file.string(), std::strerror(errno));
  ::close(descriptor);
  return HiddenFile(file, std::move(path));
}

HiddenFile::HiddenFile(HiddenFile&& other) noexcept
    : file_(std::move(other.file_)), path_(std::exchange(other.path_, fs::path())) {}

HiddenFile::~HiddenFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

Result<void> HiddenFile::appear() {
  const int descriptor = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  bool complete = descriptor >= 0 && ::fsync(descriptor) == 0;
  complete = complete && ::rename(path_.c_str(), file_.c_str()) == 0;
  const std::string reason = std::strerror(errno);
  if (descriptor >= 0) ::close(descriptor);
  if (!complete) return failure(ErrorKind::cannot_write, "{}: cannot be written: {}", file_.string(), reason);
  path_.clear();
  return {};
}

}  // namespace sinew
