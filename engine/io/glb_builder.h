#pragma once
/// Puts a `.glb` together: numbers and pictures into the binary chunk, their accessors and views into the JSON chunk.
/// glTF 2.0 Specification 3.6 (binary data) and 4 (container).
///
/// The container is written here rather than by tinygltf, which decodes and re-encodes the pictures and whose output
/// depends on hash order; a rig that is written twice must give the same bytes.

#include <cstdint>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "engine/core/files.h"
#include "engine/core/result.h"

namespace sinew {

/// Keeps the keys in the order they were set, so that the same data gives the same bytes.
using Json = nlohmann::ordered_json;

enum class AccessorShape { scalar, vec2, vec3, vec4, mat4 };

/// What the data is bound to on a device; the values are glTF's.
enum class ViewTarget { none = 0, vertices = 34962, indices = 34963 };

/// Whether an accessor says its smallest and largest values; glTF asks for it on positions and key times.
enum class AccessorBounds { omitted, written };

class GlbBuilder {
 public:
  GlbBuilder();

  /// Everything but `accessors`, `bufferViews` and `buffers`, which the builder adds itself. `asset` is there already.
  Json json;

  /// Appends an accessor over floats and gives its index. `values` holds whole elements of `shape` and is not empty.
  /// A value that is not finite makes finish() fail and name `place`.
  int add_floats(const std::string& place, std::span<const float> values, AccessorShape shape, ViewTarget target,
                 AccessorBounds bounds = AccessorBounds::omitted);

  /// The same as vertex data of which most elements are 0: only the others are stored (glTF 2.0, 3.6.2.3) where that is
  /// smaller.
  int add_sparse_floats(const std::string& place, std::span<const float> values, AccessorShape shape,
                        AccessorBounds bounds = AccessorBounds::omitted);

  /// Appends an accessor over unsigned integers in the narrowest of the given types that holds them all and gives its
  /// index. Triangle indices (ViewTarget::indices) are 16 or 32 bits wide; the largest number of a type is never used,
  /// for it would restart the primitive. Other numbers are 8 or 16 bits wide.
  int add_unsigned(std::span<const std::uint32_t> values, AccessorShape shape, ViewTarget target);

  /// Appends bytes as they are and gives their buffer view's index.
  int add_bytes(std::span<const unsigned char> bytes);

  /// Keeps the first reason why the file cannot be written; finish() returns it.
  void fail(std::string reason);

  /// The whole file. Fails as bad_input where a number was not finite, where fail() was called, or where the file
  /// would pass the 4 GiB that its 32-bit lengths can say.
  Result<Bytes> finish();

 private:
  int add_view(std::span<const unsigned char> bytes, ViewTarget target);
  void check_finite(const std::string& place, std::span<const float> values, std::size_t width);
  int add_accessor(int view, int component_type, std::size_t count, AccessorShape shape);

  Bytes binary_;
  Json accessors_ = Json::array();
  Json views_ = Json::array();
  std::string failure_;
};

}  // namespace sinew
