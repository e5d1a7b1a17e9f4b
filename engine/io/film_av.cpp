#include "engine/io/film_av.h"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <mutex>
#include <utility>

namespace sinew {
namespace {

std::mutex log_mutex;
std::string last_error;

void keep_error(void*, int level, const char* format, va_list arguments) {
  if (level > AV_LOG_ERROR) return;
  std::array<char, 256> line{};
  std::vsnprintf(line.data(), line.size(), format, arguments);
  std::string text = line.data();
  while (text.ends_with('\n') || text.ends_with('.')) text.pop_back();
  const std::lock_guard lock(log_mutex);
  last_error = std::move(text);
}

}  // namespace

void quiet_av_log() {
  static std::once_flag once;
  std::call_once(once, [] { av_log_set_callback(keep_error); });
  const std::lock_guard lock(log_mutex);
  last_error.clear();
}

std::string av_reason(int error) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(error, text.data(), text.size());
  return text.data();
}

tl::unexpected<Error> av_failure(const std::filesystem::path& file, int error) {
  std::string logged;
  {
    const std::lock_guard lock(log_mutex);
    logged = std::exchange(last_error, {});
  }
  const std::string reason = av_reason(error);
  if (logged.empty() || logged == reason)
    return failure(ErrorKind::cannot_write, "{}: cannot be written: {}", file.string(), reason);
  return failure(ErrorKind::cannot_write, "{}: cannot be written: {} ({})", file.string(), reason, logged);
}

}  // namespace sinew
