#include "engine/io/gltf_uri.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace sinew::gltf {
namespace {

int hexadecimal(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

constexpr std::array<std::int8_t, 256> base64_digits() {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::int8_t, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < digits.size(); ++i)
    values[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
  // The URL-safe alphabet of the same RFC; some writers use it.
  values['-'] = 62;
  values['_'] = 63;
  return values;
}

/// A single letter before the colon is a drive or a file's name, not a scheme.
bool has_scheme(std::string_view uri) {
  const auto colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 1) return false;
  return std::ranges::all_of(uri.substr(0, colon), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '+' || c == '-' ||
           c == '.';
  });
}

Result<Bytes> read_data_uri(std::string_view uri, std::size_t limit) {
  const auto comma = uri.find(',');
  if (comma == std::string_view::npos) return bad_input("a data URI without a comma before its data");
  const std::string_view payload = uri.substr(comma + 1);
  if (payload.size() / 4 * 3 > limit) return bad_input("a data URI of over {} bytes", limit);
  if (!uri.substr(0, comma).ends_with(";base64")) {
    const auto plain = decode_percent(payload);
    if (!plain || plain->size() > limit) return bad_input("a data URI whose data cannot be decoded");
    return Bytes(plain->begin(), plain->end());
  }
  auto bytes = decode_base64(payload);
  if (!bytes && payload.find('%') != std::string_view::npos)
    if (const auto plain = decode_percent(payload)) bytes = decode_base64(*plain);
  if (!bytes) return bad_input("a data URI whose data is not base64");
  return std::move(*bytes);
}

}  // namespace

std::optional<std::string> decode_percent(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      plain.push_back(text[i]);
      continue;
    }
    const int high = i + 2 < text.size() ? hexadecimal(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? hexadecimal(text[i + 2]) : -1;
    if (high < 0 || low < 0) return std::nullopt;
    plain.push_back(static_cast<char>(high * 16 + low));
    i += 2;
  }
  return plain;
}

std::optional<Bytes> decode_base64(std::string_view text) {
  static constexpr auto digits = base64_digits();
  for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t held = 0;
  int bits = 0;
  for (const char c : text) {
    const int digit = digits[static_cast<unsigned char>(c)];
    if (digit < 0) return std::nullopt;
    held = (held << 6 | static_cast<std::uint32_t>(digit)) & 0xFFFF;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<unsigned char>(held >> bits));
  }
  return bytes;
}

Result<Bytes> read_uri(std::string_view uri, const std::filesystem::path& folder, std::size_t limit) {
  if (uri.starts_with("data:")) return read_data_uri(uri, limit);
  if (uri.empty()) return bad_input("an empty URI");
  if (has_scheme(uri)) return bad_input("\"{:.60}\": only data URIs and files beside the model can be read", uri);
  const auto name = decode_percent(uri);
  // A name may hold a plain percent sign although a URI must not.
  const std::string decoded = name ? *name : std::string(uri);
  if (decoded.find('\0') != std::string::npos) return bad_input("\"{:.60}\": a file name with a zero byte", uri);
  return read_file(folder / std::filesystem::path(decoded), limit);
}

}  // namespace sinew::gltf
