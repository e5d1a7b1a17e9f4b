#pragma once
/// Real and broken glTF files, and what the Khronos validator says of the broken ones.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace sinew::test {

/// Every glTF file below the folder, sorted.
inline std::vector<std::filesystem::path> gltf_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (entry.is_regular_file() && (ending == ".glb" || ending == ".gltf" || ending == ".vrm"))
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// The codes of the errors (not the warnings) in the validator's report beside the file; none where there is no report.
inline std::vector<std::string> validator_errors(const std::filesystem::path& file) {
  std::vector<std::string> codes;
  std::ifstream report(file.string() + ".report.json");
  if (!report) return codes;
  const auto json = nlohmann::json::parse(report);
  for (const auto& message : json["issues"]["messages"])
    if (message["severity"] == 0) codes.push_back(message["code"]);
  return codes;
}

/// Errors of the Khronos validator that may pass without a word: code -> why. With a path before the code (a folder or
/// a file of the validator's cases) the reason holds there only.
inline const std::map<std::string, std::string> allowed_errors = {
    {"EMPTY_ENTITY", "an empty list is read as no list"},
    {"ACCESSOR_MIN_MISMATCH", "min and max are not read; bounds come from the vertices"},
    {"ACCESSOR_MAX_MISMATCH", "min and max are not read"},
    {"ACCESSOR_ELEMENT_OUT_OF_MIN_BOUND", "min and max are not read"},
    {"ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND", "min and max are not read"},
    {"MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS", "min and max are not read"},
    {"accessor_data/ ACCESSOR_INVALID_FLOAT", "no mesh uses the accessor, so its numbers are not read"},
    {"buffer/ INVALID_URI", "a stray semicolon before base64; the data is clear"},
    {"BUFFER_DATA_URI_MIME_TYPE_INVALID", "the media type changes nothing"},
    {"BUFFER_VIEW_TOO_BIG_BYTE_STRIDE", "what matters is that accessors fit the view, and that is checked"},
    {"BUFFER_VIEW_INVALID_BYTE_STRIDE", "no accessor uses the view"},
    {"camera/ UNDEFINED_PROPERTY", "cameras are not read"},
    {"camera/ ONE_OF_MISMATCH", "cameras are not read"},
    {"CAMERA_ZFAR_LEQUAL_ZNEAR", "cameras are not read"},
    {"bom.gl INVALID_JSON", "a byte order mark is skipped"},
    {"IMAGE_DATA_INVALID", "images are decoded by decode_image, not on reading"},
    {"IMAGE_UNEXPECTED_EOS", "images are decoded by decode_image"},
    {"MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_UNSIGNED_INT", "attributes of unknown name are not read"},
    {"MESH_PRIMITIVE_INVALID_ATTRIBUTE", "attributes of unknown name are not read"},
    {"UNDECLARED_EXTENSION", "an extension is read or not whether it is declared or not"},
    {"SKIN_SKELETON_INVALID", "skin.skeleton says nothing that the joints do not"},
};

/// The entry of allowed_errors that holds for an error of this code in this file; none where there is none.
inline std::string allowance(const std::string& code, const std::string& file) {
  for (const auto& [entry, reason] : allowed_errors) {
    const auto space = entry.find(' ');
    const std::string place = space == std::string::npos ? "" : entry.substr(0, space);
    if (entry.substr(space == std::string::npos ? 0 : space + 1) == code && file.find(place) != std::string::npos)
      return entry;
  }
  return {};
}

}  // namespace sinew::test
