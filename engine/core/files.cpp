#include "engine/core/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include <openssl/evp.h>

#include "engine/core/temporary_file.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

std::string reason() { return std::strerror(errno); }

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool open() const { return number_ >= 0; }
  int number() const { return number_; }
  /// False where the kernel reports a late write error.
  bool close() {
    const int n = std::exchange(number_, -1);
    return n < 0 || ::close(n) == 0;
  }

 private:
  int number_;
};

bool write_all(int descriptor, std::span<const unsigned char> data) {
  while (!data.empty()) {
    const ssize_t written = ::write(descriptor, data.data(), data.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    data = data.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

Result<void> write_device(const fs::path& file, std::span<const unsigned char> data) {
  Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!out.open() || !write_all(out.number(), data) || !out.close())
    return failure(ErrorKind::cannot_write, "{}: cannot be written: {}", file.string(), reason());
  return {};
}

}  // namespace

Result<Bytes> read_file(const fs::path& file, std::size_t limit) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) return bad_input("{}: no such file", file.string());
  if (fs::is_directory(status)) return bad_input("{}: is a folder, not a file", file.string());
  if (!fs::is_regular_file(status)) return bad_input("{}: is not a regular file", file.string());
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) return bad_input("{}: {}", file.string(), error.message());
  if (size > limit) return bad_input("{}: {} bytes are more than the {} that are read", file.string(), size, limit);

  Bytes data(static_cast<std::size_t>(size));
  std::ifstream in(file, std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(data.data()), static_cast<std::streamsize>(data.size())))
    return bad_input("{}: cannot be read: {}", file.string(), reason());
  return data;
}

Result<void> write_file(const fs::path& file, std::span<const unsigned char> data) {
  std::error_code error;
  if (fs::is_character_file(file, error)) return write_device(file, data);
  if (fs::is_directory(file, error))
    return failure(ErrorKind::cannot_write, "{}: is a folder; name a file in it", file.string());

  auto temporary = TemporaryFile::create(file);
  if (!temporary) return pass_on(std::move(temporary));
  if (auto ok = temporary->write(data); !ok) return ok;
  return temporary->appear();
}

Result<void> write_file(const fs::path& file, const std::string& text) {
  return write_file(file, std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
}

Result<void> check_writable(const fs::path& file) {
  std::error_code error;
  if (fs::is_character_file(file, error)) return {};
  if (fs::is_directory(file, error))
    return failure(ErrorKind::cannot_write, "{}: is a folder; name a file in it", file.string());
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    return failure(ErrorKind::cannot_write, "{}: the folder {} does not exist", file.string(), folder.string());
  const auto probe = TemporaryFile::create(file);
  if (!probe) return tl::unexpected<Error>(probe.error());
  return {};
}

Sha256::Sha256() : context_(EVP_MD_CTX_new()) {
  EVP_DigestInit_ex(static_cast<EVP_MD_CTX*>(context_), EVP_sha256(), nullptr);
}

Sha256::~Sha256() { EVP_MD_CTX_free(static_cast<EVP_MD_CTX*>(context_)); }

void Sha256::add(std::span<const unsigned char> data) {
  EVP_DigestUpdate(static_cast<EVP_MD_CTX*>(context_), data.data(), data.size());
}

std::string Sha256::finish() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  EVP_DigestFinal_ex(static_cast<EVP_MD_CTX*>(context_), digest.data(), &size);
  std::string text;
  for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

std::string sha256(std::span<const unsigned char> data) {
  Sha256 hash;
  hash.add(data);
  return hash.finish();
}

std::string sha256(const std::string& text) {
  return sha256(std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
}

}  // namespace sinew
