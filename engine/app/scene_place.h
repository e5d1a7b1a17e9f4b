#pragma once
/// Where in a scene file something was asked for.

#include <string>

#include "engine/core/result.h"

namespace sinew {

/// An error, with the place in the scene file that asked for what went wrong; a bare model has no such place.
class ScenePlace {
 public:
  ScenePlace(std::string source, bool bare_model, std::size_t character)
      : prefix_(bare_model ? "" : fmt::format("{}: /characters/{}", source, character)) {}

  template <class T>
  tl::unexpected<Error> at(const std::string& pointer, Result<T>&& failed) const {
    Error error = std::move(failed.error());
    if (!prefix_.empty()) error.message = fmt::format("{}{}: {}", prefix_, pointer, error.message);
    return tl::unexpected<Error>(std::move(error));
  }

  /// The same where the message begins with the rest of the pointer.
  template <class T>
  tl::unexpected<Error> inside(const std::string& pointer, Result<T>&& failed) const {
    Error error = std::move(failed.error());
    error.message = prefix_ + pointer + error.message;
    return tl::unexpected<Error>(std::move(error));
  }

 private:
  std::string prefix_;
};

}  // namespace sinew
