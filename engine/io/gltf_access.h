#pragma once
/// Accessors: numbers out of buffers, whatever their component type, stride and sparseness (glTF 2.0 section 3.6.2).

#include <span>
#include <string>
#include <vector>

#include "engine/core/math.h"
#include "engine/core/result.h"
#include "engine/io/gltf_document.h"

namespace sinew::gltf {

/// Decoded elements, one after another.
struct Numbers {
  std::vector<double> values;  ///< [count * width]; integers that are normalized lie in -1..1 or 0..1
  std::size_t width = 1;       ///< numbers an element: 1 for SCALAR, 3 for VEC3, 16 for MAT4 (by columns)
  bool integer = false;        ///< the file stores integers, normalized or not

  std::size_t count() const { return values.size() / width; }
  std::span<const double> at(std::size_t i) const { return {values.data() + i * width, width}; }
  Vec3 vec3(std::size_t i) const { return {values[i * width], values[i * width + 1], values[i * width + 2]}; }
  bool finite(std::size_t i) const;  ///< all numbers of element i
  /// How far from 1 the length of a unit vector may be. Small integers cannot hold one better than 2e-2 (glTF's
  /// KHR_mesh_quantization: 8 bits).
  double unit_tolerance() const { return integer ? 2e-2 : 1e-3; }
};

/// What a property accepts: a tinygltf type (TINYGLTF_TYPE_VEC3) and component types, and the words for both.
struct AccessorFormat {
  int type = 0;
  std::span<const int> components;
  const char* words = "";
};

/// Every view lies inside its buffer, and every accessor, sparse parts included, inside its views. Offsets are added in
/// 64 bits of numbers below 2^31, so that none can overflow.
Result<void> check_layout(const Document& document);

/// The accessor's elements. Fails as bad_input, `place` first, where its format is another, its sparse indices do not
/// rise or leave the range, or the memory that a model may take is used up.
Result<Numbers> read_accessor(Document& document, int accessor, const std::string& place, const AccessorFormat& format);

}  // namespace sinew::gltf
