#pragma once
/// A glTF file opened: its JSON checked, its buffers in memory, nothing decoded yet.
///
/// The way of a file: container -> JSON -> conform() -> tinygltf's plain structs -> the readers (gltf_scene, gltf_mesh,
/// gltf_clip, gltf_material, gltf_vrm), each of which turns one part into the Model's. tinygltf checks next to nothing
/// and opens files by itself; so it is shown only what conform() let through, and never a buffer or an image.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <tiny_gltf.h>
#include <nlohmann/json.hpp>

#include "engine/core/files.h"
#include "engine/core/result.h"

namespace sinew::gltf {

/// Bytes that may come in from files, all buffers and images together.
constexpr std::size_t largest_input = std::size_t{512} << 20;
/// Bytes that may be made of them. A short file can ask for any number of vertices; this is where it is stopped.
constexpr std::size_t largest_model = std::size_t{768} << 20;

class Document {
 public:
  nlohmann::json source;  ///< as the file holds it, unchecked: for extensions and extras only
  tinygltf::Model gltf;   ///< checked: types, references, byte ranges of views and accessors
  std::filesystem::path folder;
  std::vector<std::string> problems;

  std::span<const unsigned char> buffer(std::size_t index) const { return buffers_[index]; }
  std::span<const unsigned char> view(int buffer_view) const;

  /// Writes a sentence into `problems`; after the first few hundred only their number is kept.
  template <class... Args>
  void problem(fmt::format_string<Args...> format, Args&&... args) {
    add_problem(fmt::format(format, std::forward<Args>(args)...));
  }

  /// To be asked before memory is taken for the model; fails, naming the place, where the file claims too much.
  Result<void> take_memory(std::size_t bytes, const std::string& place);

  /// The bytes of a file or data URI; counts towards largest_input.
  Result<Bytes> fetch(const std::string& uri);

  bool uses_extension(std::string_view name) const;

  /// The last line of `problems`: how many more there were.
  void close_problems();

 private:
  friend Result<Document> open_document(const std::filesystem::path& file, Bytes bytes);
  void add_problem(std::string sentence);
  Result<void> load_buffers(const nlohmann::json& buffers, std::span<const unsigned char> binary, bool has_binary);

  Bytes file_;
  std::vector<Bytes> loaded_;
  std::vector<std::span<const unsigned char>> buffers_;
  std::size_t input_left_ = largest_input;
  std::size_t memory_left_ = largest_model;
  std::size_t problems_left_out_ = 0;
};

/// Opens .glb, .gltf or .vrm, `bytes` being what `file` holds. Fails as bad_input; messages name the place but not the
/// file.
Result<Document> open_document(const std::filesystem::path& file, Bytes bytes);

}  // namespace sinew::gltf
