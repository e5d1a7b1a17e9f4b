#include "engine/io/gltf_document.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "engine/io/gltf_access.h"
#include "engine/io/gltf_container.h"
#include "engine/io/gltf_schema.h"
#include "engine/io/gltf_uri.h"
#include "engine/io/json_reader.h"

namespace sinew::gltf {
namespace {

using nlohmann::json;

constexpr std::size_t most_problems = 300;
constexpr JsonLimits json_limits{largest_input, 64, 2'000'000};

/// What a file may insist on: the reader obeys these, or they do not touch what it reads.
constexpr std::array<std::string_view, 8> supported = {"KHR_mesh_quantization",
                                                       "KHR_texture_transform",
                                                       "KHR_materials_unlit",
                                                       "KHR_materials_emissive_strength",
                                                       "KHR_materials_specular",
                                                       "KHR_materials_pbrSpecularGlossiness",
                                                       "VRMC_vrm",
                                                       "VRM"};

/// Extensions that may be used without a word: how a surface shines, lights, and what VRM adds for its own players.
bool quietly_ignored(std::string_view name) {
  return std::ranges::count(supported, name) != 0 || name.starts_with("KHR_materials_") || name.starts_with("VRMC_") ||
         name == "KHR_lights_punctual" || name == "KHR_xmp" || name == "KHR_xmp_json_ld";
}

Result<void> check_extensions(Document& document) {
  for (const std::string& name : document.gltf.extensionsRequired)
    if (std::ranges::count(supported, std::string_view(name)) == 0)
      return bad_input(
          "extensionsRequired: the file needs the extension {:.80}, which is not supported; supported are {}", name,
          fmt::join(supported, ", "));
  for (const std::string& name : document.gltf.extensionsUsed)
    if (!quietly_ignored(name)) document.problem("extensionsUsed: {:.80} is not read", name);
  return {};
}

/// "2.0" as 2 and 0.
std::optional<std::pair<long, long>> version(const std::string& text) {
  const auto dot = text.find('.');
  const auto digits = [](std::string_view part) {
    return !part.empty() && part.size() < 4 && std::ranges::all_of(part, [](char c) { return c >= '0' && c <= '9'; });
  };
  if (dot == std::string::npos || !digits(text.substr(0, dot)) || !digits(text.substr(dot + 1))) return std::nullopt;
  return std::pair(std::stol(text.substr(0, dot)), std::stol(text.substr(dot + 1)));
}

Result<void> check_version(const json& asset) {
  const auto& written = asset["version"].get_ref<const std::string&>();
  const auto major_minor = version(written);
  if (!major_minor || major_minor->first != 2)
    return bad_input("asset/version: \"{:.20}\"; only glTF 2.x can be read", written);
  if (!asset.contains("minVersion")) return {};
  const auto& least = asset["minVersion"].get_ref<const std::string&>();
  const auto needed = version(least);
  if (!needed || *needed > std::pair(2L, 0L))
    return bad_input("asset/minVersion: \"{:.20}\"; files that need more than 2.0 cannot be read", least);
  return {};
}

/// tinygltf wants a view behind every list of indices, which the specification does not.
Result<void> check_indices_have_views(const json& checked) {
  if (!checked.contains("meshes")) return {};
  for (std::size_t m = 0; m < checked["meshes"].size(); ++m) {
    const json& primitives = checked["meshes"][m]["primitives"];
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      if (!primitives[p].contains("indices")) continue;
      const std::size_t accessor = primitives[p]["indices"].get<std::size_t>();
      if (!checked["accessors"][accessor].contains("bufferView"))
        return bad_input("meshes/{}/primitives/{}/indices: accessors/{} has no bufferView, so there are no indices", m,
                         p, accessor);
    }
  }
  return {};
}

Result<tinygltf::Model> as_structs(json checked) {
  checked.erase("buffers");
  checked.erase("images");
  const std::string text = checked.dump();
  tinygltf::Model model;
  tinygltf::TinyGLTF loader;
  std::string error, warning;
  if (!loader.LoadASCIIFromString(&model, &error, &warning, text.data(), static_cast<unsigned>(text.size()), ""))
    return bad_input("the glTF JSON cannot be read: {}", error);
  return model;
}

}  // namespace

std::span<const unsigned char> Document::view(int buffer_view) const {
  const tinygltf::BufferView& view = gltf.bufferViews[static_cast<std::size_t>(buffer_view)];
  return buffers_[static_cast<std::size_t>(view.buffer)].subspan(view.byteOffset, view.byteLength);
}

Result<void> Document::take_memory(std::size_t bytes, const std::string& place) {
  if (bytes > memory_left_)
    return bad_input("{}: the model would take over {} MiB of memory; what it claims is not plausible", place,
                     largest_model >> 20);
  memory_left_ -= bytes;
  return {};
}

Result<Bytes> Document::fetch(const std::string& uri) {
  auto bytes = read_uri(uri, folder, input_left_);
  if (bytes) input_left_ -= bytes->size();
  return bytes;
}

bool Document::uses_extension(std::string_view name) const {
  return std::ranges::count(gltf.extensionsUsed, name) + std::ranges::count(gltf.extensionsRequired, name) > 0;
}

void Document::add_problem(std::string sentence) {
  if (problems.size() < most_problems)
    problems.push_back(std::move(sentence));
  else
    ++problems_left_out_;
}

void Document::close_problems() {
  if (problems_left_out_ > 0) problems.push_back(fmt::format("and {} more problems", problems_left_out_));
}

Result<void> Document::load_buffers(const json& list, std::span<const unsigned char> binary, bool has_binary) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto length = list[i]["byteLength"].get<std::size_t>();
    std::span<const unsigned char> bytes;
    if (list[i].contains("uri")) {
      auto fetched = fetch(list[i]["uri"].get_ref<const std::string&>());
      if (!fetched) return bad_input("buffers/{}/uri: {}", i, fetched.error().message);
      loaded_.push_back(std::move(*fetched));
      bytes = loaded_.back();
    } else if (i == 0 && has_binary) {
      bytes = binary;
    } else {
      problem("buffers/{}: has no uri, and there is no binary chunk for it; it is empty", i);
      buffers_.emplace_back();
      continue;
    }
    if (bytes.size() < length)
      return bad_input("buffers/{}: byteLength is {}, but there are only {} bytes", i, length, bytes.size());
    buffers_.push_back(bytes.first(length));
  }
  return {};
}

Result<Document> open_document(const std::filesystem::path& file, Bytes bytes) {
  Document document;
  document.folder = file.parent_path();
  if (bytes.size() > largest_input)
    return bad_input("{} bytes are more than the {} that are read", bytes.size(), largest_input);
  document.file_ = std::move(bytes);
  document.input_left_ -= document.file_.size();

  const auto container = open_container(document.file_, document.problems);
  if (!container) return tl::unexpected(container.error());
  auto source = parse_json(container->json, file.string(), json_limits);
  if (!source) return pass_on(std::move(source));
  document.source = std::move(*source);
  auto checked = conform(document.source);
  if (!checked) return pass_on(std::move(checked));
  if (auto version = check_version((*checked)["asset"]); !version) return pass_on(std::move(version));
  if (auto indices = check_indices_have_views(*checked); !indices) return pass_on(std::move(indices));

  const json buffers = checked->value("buffers", json::array());
  auto gltf = as_structs(std::move(*checked));
  if (!gltf) return pass_on(std::move(gltf));
  document.gltf = std::move(*gltf);
  if (auto extensions = check_extensions(document); !extensions) return pass_on(std::move(extensions));
  if (auto loaded = document.load_buffers(buffers, container->binary, container->has_binary); !loaded)
    return pass_on(std::move(loaded));
  if (auto layout = check_layout(document); !layout) return pass_on(std::move(layout));
  return document;
}

}  // namespace sinew::gltf
