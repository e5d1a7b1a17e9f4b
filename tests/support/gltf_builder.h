#pragma once
/// Small glTF files made in memory, for tests: numbers go in, accessors and one data-URI buffer come out.

#include <atomic>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "engine/io/gltf_read.h"

namespace sinew::test {

/// A file in the temporary folder that goes away with this object.
class ScratchFile {
 public:
  explicit ScratchFile(std::string_view content, const std::string& ending = ".gltf") {
    static std::atomic<int> counter{0};
    path_ = std::filesystem::temp_directory_path() /
            ("sinew_test_" + std::to_string(::getpid()) + "_" + std::to_string(counter++) + ending);
    std::ofstream(path_, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
  }
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline Result<Model> read_text(std::string_view content) { return read_gltf(ScratchFile(content).path()); }

class GltfBuilder {
 public:
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};

  /// A view of the values as type T; its number.
  template <class T, class Values>
  int view(const Values& values, int stride = 0) {
    while (bytes_.size() % 4 != 0) bytes_.push_back('\0');
    const std::size_t begin = bytes_.size();
    for (const auto value : values) {
      const T stored = static_cast<T>(value);
      bytes_.append(reinterpret_cast<const char*>(&stored), sizeof stored);
    }
    nlohmann::json view = {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes_.size() - begin}};
    if (stride > 0) view["byteStride"] = stride;
    return add("bufferViews", view);
  }

  int accessor(int view, int component_type, const std::string& type, std::size_t count, bool normalized = false,
               std::size_t offset = 0) {
    nlohmann::json accessor = {{"bufferView", view},
                               {"byteOffset", offset},
                               {"componentType", component_type},
                               {"type", type},
                               {"count", count}};
    if (normalized) accessor["normalized"] = true;
    return add("accessors", accessor);
  }

  int floats(const std::string& type, const std::vector<double>& values) {
    return accessor(view<float>(values), 5126, type, values.size() / width(type));
  }
  template <class T>
  int integers(const std::string& type, const std::vector<double>& values, bool normalized = false) {
    return accessor(view<T>(values), component_type<T>(), type, values.size() / width(type), normalized);
  }

  int add(const std::string& list, const nlohmann::json& item) {
    json[list].push_back(item);
    return static_cast<int>(json[list].size()) - 1;
  }

  /// One triangle of three vertices; attributes may be added before it is used.
  nlohmann::json triangle() { return {{"attributes", {{"POSITION", floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})}}}}; }

  /// A mesh of this primitive on a node of its own, skinned to `joints` nodes at the origin if there are any: the first
  /// is the parent of the others.
  void draw(const nlohmann::json& primitive, int joints = 0) {
    const int mesh = add("meshes", {{"primitives", {primitive}}});
    nlohmann::json node = {{"mesh", mesh}};
    if (joints > 0) {
      nlohmann::json list = nlohmann::json::array();
      for (int j = 0; j < joints; ++j) list.push_back(add("nodes", {{"name", "joint"}}));
      node["skin"] = add("skins", {{"joints", list}});
      for (std::size_t j = 1; j < list.size(); ++j) json["nodes"][list[0].get<int>()]["children"].push_back(list[j]);
    }
    add("nodes", node);
  }

  std::string text() const {
    nlohmann::json whole = json;
    if (!bytes_.empty())
      whole["buffers"] = {
          {{"byteLength", bytes_.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}};
    return whole.dump();
  }

  /// The same as a binary container.
  std::string binary() const {
    nlohmann::json whole = json;
    std::string data = bytes_;
    data.resize((data.size() + 3) / 4 * 4);
    if (!data.empty()) whole["buffers"] = {{{"byteLength", bytes_.size()}}};
    std::string text = whole.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string body = number(static_cast<unsigned>(text.size())) + "JSON" + text;
    if (!data.empty()) body += number(static_cast<unsigned>(data.size())) + std::string("BIN\0", 4) + data;
    return "glTF" + number(2) + number(static_cast<unsigned>(body.size()) + 12) + body;
  }

  Result<Model> read() const { return read_text(text()); }

  static std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      unsigned held = 0;
      for (std::size_t k = 0; k < 3; ++k)
        held = held << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
      for (std::size_t k = 0; k < 4; ++k) text += k <= bytes.size() - i ? digits[held >> (18 - 6 * k) & 63] : '=';
    }
    return text;
  }

 private:
  static std::size_t width(const std::string& type) {
    if (type == "SCALAR") return 1;
    return type == "MAT4" ? 16 : static_cast<std::size_t>(type[3] - '0');
  }
  template <class T>
  static constexpr int component_type() {
    if (std::is_same_v<T, signed char>) return 5120;
    if (std::is_same_v<T, unsigned char>) return 5121;
    if (std::is_same_v<T, short>) return 5122;
    return std::is_same_v<T, unsigned short> ? 5123 : 5125;
  }
  static std::string number(unsigned n) {
    return {static_cast<char>(n), static_cast<char>(n >> 8), static_cast<char>(n >> 16), static_cast<char>(n >> 24)};
  }

  std::string bytes_;
};

/// The message of a file that must be refused.
inline std::string refusal(const std::string& content) {
  const auto model = read_text(content);
  if (model) return "(read)";
  EXPECT_EQ(model.error().kind, ErrorKind::bad_input);
  return model.error().message;
}

inline void expect_refused(const GltfBuilder& builder, std::string_view part) {
  const std::string message = refusal(builder.text());
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

/// True where one of the model's problems holds `part`.
inline bool mentions(const Model& model, std::string_view part) {
  for (const std::string& problem : model.problems)
    if (problem.find(part) != std::string::npos) return true;
  return false;
}

}  // namespace sinew::test
