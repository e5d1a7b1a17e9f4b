#pragma once
/// How a call that touches files, users or drivers says that it failed, and why.
/// Our own mistakes are asserts; these are for what the world did.

#include <string>
#include <utility>

#include <fmt/format.h>
#include <tl/expected.hpp>

namespace sinew {

/// What kind of failure it was; the value is the program's exit code.
enum class ErrorKind {
  check_failed = 1,   ///< parity, compare, or a message under --validate
  usage = 2,          ///< wrong command line, found without opening any file
  bad_input = 3,      ///< a file, or a name or value that the files do not have
  no_device = 4,      ///< no or unknown Vulkan device, no display
  device_failed = 5,  ///< the device was lost or ran out of memory; another try may work
  frames_failed = 6,  ///< some frames failed, the rest are there
  cannot_write = 7,   ///< the output cannot be written, or its encoder is missing
  interrupted = 130,  ///< SIGINT
  terminated = 143,   ///< SIGTERM
};

/// A failure and its reason: what is wrong, where, and what would be right.
struct Error {
  ErrorKind kind = ErrorKind::bad_input;
  std::string message;
};

template <class T>
using Result = tl::expected<T, Error>;

/// An Error to return, its message formatted as by fmt::format.
template <class... Args>
tl::unexpected<Error> failure(ErrorKind kind, fmt::format_string<Args...> format, Args&&... args) {
  return tl::unexpected<Error>(Error{kind, fmt::format(format, std::forward<Args>(args)...)});
}

/// failure() of the commonest kind: a file, name or value that cannot be used.
template <class... Args>
tl::unexpected<Error> bad_input(fmt::format_string<Args...> format, Args&&... args) {
  return failure(ErrorKind::bad_input, format, std::forward<Args>(args)...);
}

/// Hands an inner failure on, whatever its type was.
template <class T>
tl::unexpected<Error> pass_on(Result<T>&& failed) {
  return tl::unexpected<Error>(std::move(failed.error()));
}

}  // namespace sinew
