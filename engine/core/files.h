#pragma once
/// Reading whole files, and writing them so that a half-written one never stands under its final name.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/core/result.h"

namespace sinew {

using Bytes = std::vector<unsigned char>;

/// The whole file. Fails as bad_input, naming the file, where it is missing, no regular file, or over `limit` bytes.
Result<Bytes> read_file(const std::filesystem::path& file, std::size_t limit = std::size_t{2} << 30);

/// Writes `data` to a temporary file beside `file`, flushes it to the disk and renames it. On any failure
/// (cannot_write) nothing new is left, and what stood there before stays. A character device (/dev/null) is written to
/// directly.
Result<void> write_file(const std::filesystem::path& file, std::span<const unsigned char> data);
Result<void> write_file(const std::filesystem::path& file, const std::string& text);

/// Fails as cannot_write where `file` cannot be created: its folder is missing or not writable, or it is a folder
/// itself. Leaves no trace. Meant to be asked before long work starts.
Result<void> check_writable(const std::filesystem::path& file);

/// SHA-256 of data that comes in pieces.
class Sha256 {
 public:
  Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;
  ~Sha256();

  void add(std::span<const unsigned char> data);
  /// The bytes of numbers, as they lie in memory.
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void add_all(const std::vector<T>& values) {
    add({reinterpret_cast<const unsigned char*>(values.data()), values.size() * sizeof(T)});
  }
  /// 64 lower-case hexadecimal digits. To be called once, last.
  std::string finish();

 private:
  void* context_;
};

/// SHA-256 of the bytes as 64 lower-case hexadecimal digits.
std::string sha256(std::span<const unsigned char> data);
std::string sha256(const std::string& text);

}  // namespace sinew
