#include "engine/io/gltf_container.h"

#include <cstdint>

namespace sinew::gltf {
namespace {

constexpr std::uint32_t magic = 0x46546C67;       // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t binary_chunk = 0x004E4942;
constexpr std::size_t file_header = 12, chunk_header = 8;

std::uint32_t little_endian(std::span<const unsigned char> bytes, std::size_t at) {
  return bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 | static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

std::string_view as_text(std::span<const unsigned char> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk {
  std::uint32_t type = 0;
  std::span<const unsigned char> data;
};

/// The chunk at `at`, which moves past it.
Result<Chunk> read_chunk(std::span<const unsigned char> file, std::size_t& at) {
  if (file.size() - at < chunk_header)
    return bad_input("byte {}: the file ends inside a chunk's header; it was cut short", at);
  const std::size_t length = little_endian(file, at);
  const std::uint32_t type = little_endian(file, at + 4);
  if (length > file.size() - at - chunk_header)
    return bad_input("byte {}: a chunk of {} bytes, but only {} follow; the file was cut short", at, length,
                     file.size() - at - chunk_header);
  const std::size_t begin = at + chunk_header;
  at = begin + length;
  return Chunk{type, file.subspan(begin, length)};
}

Result<std::span<const unsigned char>> check_header(std::span<const unsigned char> file,
                                                    std::vector<std::string>& problems) {
  if (file.size() < file_header)
    return bad_input("the file ends inside the binary glTF header ({} of {} bytes)", file.size(), file_header);
  if (const auto version = little_endian(file, 4); version != 2)
    return bad_input("binary glTF container version {}; only version 2 can be read", version);
  const std::size_t length = little_endian(file, 8);
  if (length > file.size())
    return bad_input("the header says {} bytes, but the file has {}; it was cut short", length, file.size());
  if (length < file_header + chunk_header)
    return bad_input("the header says {} bytes, too few for a binary glTF file", length);
  if (length < file.size())
    problems.push_back(fmt::format("{} bytes after the end of the binary glTF data; ignored", file.size() - length));
  return file.first(length);
}

Result<Container> open_binary(std::span<const unsigned char> file, std::vector<std::string>& problems) {
  auto body = check_header(file, problems);
  if (!body) return pass_on(std::move(body));
  std::size_t at = file_header;
  auto first = read_chunk(*body, at);
  if (!first) return pass_on(std::move(first));
  if (first->type != json_chunk)
    return bad_input("the first chunk is of type 0x{:08x}; it must be JSON (0x{:08x})", first->type, json_chunk);
  Container container{as_text(first->data), {}, false};
  while (at < body->size()) {
    auto chunk = read_chunk(*body, at);
    if (!chunk) return pass_on(std::move(chunk));
    if (chunk->type == json_chunk) return bad_input("two JSON chunks; a binary glTF file has one");
    if (chunk->type != binary_chunk) continue;
    if (container.has_binary) return bad_input("two BIN chunks; a binary glTF file has at most one");
    container.binary = chunk->data;
    container.has_binary = true;
  }
  return container;
}

}  // namespace

Result<Container> open_container(std::span<const unsigned char> file, std::vector<std::string>& problems) {
  if (file.empty()) return bad_input("the file is empty; expected glTF 2.0, binary or JSON");
  Container container;
  if (file.size() >= 4 && little_endian(file, 0) == magic) {
    auto binary = open_binary(file, problems);
    if (!binary) return binary;
    container = *binary;
  } else {
    container.json = as_text(file);
  }
  // Some exporters pad with zero bytes where the specification asks for spaces.
  while (container.json.ends_with('\0')) container.json.remove_suffix(1);
  if (container.json.starts_with("\xEF\xBB\xBF")) container.json.remove_prefix(3);
  if (const auto begin = container.json.find_first_not_of(" \t\r\n");
      begin == std::string_view::npos || container.json[begin] != '{')
    return bad_input("neither binary glTF (it would begin with \"glTF\") nor a JSON object (with \"{{\")");
  return container;
}

}  // namespace sinew::gltf
