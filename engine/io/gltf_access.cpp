#include "engine/io/gltf_access.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace sinew::gltf {
namespace {

using tinygltf::Accessor;
using tinygltf::BufferView;

std::size_t component_bytes(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    default:
      return 4;
  }
}

std::size_t width_of(const Accessor& accessor) {
  return static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
}

/// Columns of matrices begin at multiples of four bytes (glTF 2.0 section 3.6.2.4).
std::size_t element_bytes(const Accessor& accessor) {
  const std::size_t component = component_bytes(accessor.componentType);
  const auto columns = [&](std::size_t n) { return n * ((n * component + 3) / 4 * 4); };
  switch (accessor.type) {
    case TINYGLTF_TYPE_MAT2:
      return columns(2);
    case TINYGLTF_TYPE_MAT3:
      return columns(3);
    case TINYGLTF_TYPE_MAT4:
      return columns(4);
    default:
      return component * width_of(accessor);
  }
}

/// The padding behind the last column, which the last element may go without.
std::size_t trailing_padding(const Accessor& accessor) {
  const std::size_t component = component_bytes(accessor.componentType);
  if (accessor.type == TINYGLTF_TYPE_MAT2) return (4 - 2 * component % 4) % 4;
  return accessor.type == TINYGLTF_TYPE_MAT3 ? (4 - 3 * component % 4) % 4 : 0;
}

/// `count` elements, `stride` apart, the last of `bytes`, from `offset` on: do they lie inside the view?
bool fits(const BufferView& view, std::uint64_t offset, std::uint64_t count, std::uint64_t stride,
          std::uint64_t bytes) {
  return offset + (count - 1) * stride + bytes <= view.byteLength;
}

Result<void> check_sparse(const Document& document, const Accessor& accessor, std::size_t index) {
  const auto& sparse = accessor.sparse;
  const auto count = static_cast<std::size_t>(sparse.count);
  if (count > accessor.count)
    return bad_input("accessors/{}/sparse: replaces {} elements of {}", index, count, accessor.count);
  const std::size_t index_bytes = component_bytes(sparse.indices.componentType);
  if (!fits(document.gltf.bufferViews[static_cast<std::size_t>(sparse.indices.bufferView)],
            static_cast<std::uint64_t>(sparse.indices.byteOffset), count, index_bytes, index_bytes))
    return bad_input("accessors/{}/sparse/indices: {} indices do not fit bufferViews/{}", index, count,
                     sparse.indices.bufferView);
  const std::size_t bytes = element_bytes(accessor);
  if (!fits(document.gltf.bufferViews[static_cast<std::size_t>(sparse.values.bufferView)],
            static_cast<std::uint64_t>(sparse.values.byteOffset), count, bytes, bytes - trailing_padding(accessor)))
    return bad_input("accessors/{}/sparse/values: {} elements do not fit bufferViews/{}", index, count,
                     sparse.values.bufferView);
  return {};
}

Result<void> check_accessor(const Document& document, std::size_t index) {
  const Accessor& accessor = document.gltf.accessors[index];
  const std::size_t bytes = element_bytes(accessor);
  if (accessor.bufferView >= 0) {
    const BufferView& view = document.gltf.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    const std::size_t stride = view.byteStride != 0 ? view.byteStride : bytes;
    if (stride < bytes)
      return bad_input("accessors/{}: bufferViews/{} has a byteStride of {}, less than an element's {} bytes", index,
                       accessor.bufferView, stride, bytes);
    if (!fits(view, accessor.byteOffset, accessor.count, stride, bytes - trailing_padding(accessor)))
      return bad_input("accessors/{}: {} elements of {} bytes from byte {} on do not fit bufferViews/{} ({} bytes)",
                       index, accessor.count, bytes, accessor.byteOffset, accessor.bufferView, view.byteLength);
  }
  if (accessor.sparse.isSparse) return check_sparse(document, accessor, index);
  return {};
}

/// One component as a number; normalized integers as glTF 2.0 section 3.11 says.
double component(const unsigned char* at, int type, bool normalized) {
  const auto load = [at]<class T>(T value) {
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
  };
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const double x = load(std::int8_t{});
      return normalized ? std::max(x / 127.0, -1.0) : x;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return normalized ? *at / 255.0 : *at;
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      const double x = load(std::int16_t{});
      return normalized ? std::max(x / 32767.0, -1.0) : x;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
      const double x = load(std::uint16_t{});
      return normalized ? x / 65535.0 : x;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load(std::uint32_t{});
    default:
      return load(float{});
  }
}

/// Elements that stand one after another, their components side by side: true of all but small-integer matrices, which
/// no property that is read may have.
void copy_element(const unsigned char* from, const Accessor& accessor, std::size_t width, double* to) {
  const std::size_t bytes = component_bytes(accessor.componentType);
  for (std::size_t c = 0; c < width; ++c)
    to[c] = component(from + c * bytes, accessor.componentType, accessor.normalized);
}

Result<void> apply_sparse(const Document& document, const Accessor& accessor, const std::string& place,
                          Numbers& numbers) {
  const auto& sparse = accessor.sparse;
  const auto indices =
      document.view(sparse.indices.bufferView).subspan(static_cast<std::size_t>(sparse.indices.byteOffset));
  const auto values =
      document.view(sparse.values.bufferView).subspan(static_cast<std::size_t>(sparse.values.byteOffset));
  const std::size_t index_bytes = component_bytes(sparse.indices.componentType);
  const std::size_t bytes = element_bytes(accessor);
  double previous = -1.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
    const double index = component(&indices[i * index_bytes], sparse.indices.componentType, false);
    if (index <= previous || index >= static_cast<double>(accessor.count))
      return bad_input("{}/sparse/indices: number {} is {}; they must rise and stay below {}", place, i, index,
                       accessor.count);
    previous = index;
    copy_element(&values[i * bytes], accessor, numbers.width,
                 &numbers.values[static_cast<std::size_t>(index) * numbers.width]);
  }
  return {};
}

}  // namespace

bool Numbers::finite(std::size_t i) const {
  return std::ranges::all_of(at(i), [](double x) { return std::isfinite(x); });
}

Result<void> check_layout(const Document& document) {
  for (std::size_t i = 0; i < document.gltf.bufferViews.size(); ++i) {
    const BufferView& view = document.gltf.bufferViews[i];
    // Empty where the file has a buffer without data.
    const std::size_t size = document.buffer(static_cast<std::size_t>(view.buffer)).size();
    if (view.byteOffset + view.byteLength > size)
      return bad_input("bufferViews/{}: bytes {} to {} of buffers/{}, which has only {}", i, view.byteOffset,
                       view.byteOffset + view.byteLength, view.buffer, size);
  }
  for (std::size_t i = 0; i < document.gltf.accessors.size(); ++i)
    if (auto fine = check_accessor(document, i); !fine) return fine;
  return {};
}

Result<Numbers> read_accessor(Document& document, int index, const std::string& place, const AccessorFormat& format) {
  const Accessor& accessor = document.gltf.accessors[static_cast<std::size_t>(index)];
  const std::string where = fmt::format("{} (accessors/{})", place, index);
  if (accessor.type != format.type || std::ranges::count(format.components, accessor.componentType) == 0)
    return bad_input("{}: must be {}", where, format.words);

  Numbers numbers;
  numbers.width = width_of(accessor);
  numbers.integer = accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT;
  const std::size_t bytes = element_bytes(accessor);
  // Twice: these numbers, and what the reader makes of them.
  if (auto taken = document.take_memory(2 * accessor.count * numbers.width * sizeof(double), where); !taken)
    return pass_on(std::move(taken));
  numbers.values.resize(accessor.count * numbers.width);
  if (accessor.bufferView >= 0) {
    const auto& view = document.gltf.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    const std::size_t stride = view.byteStride != 0 ? view.byteStride : bytes;
    const unsigned char* data = document.view(accessor.bufferView).data() + accessor.byteOffset;
    for (std::size_t i = 0; i < accessor.count; ++i)
      copy_element(data + i * stride, accessor, numbers.width, &numbers.values[i * numbers.width]);
  }
  if (accessor.sparse.isSparse)
    if (auto applied = apply_sparse(document, accessor, where, numbers); !applied) return pass_on(std::move(applied));
  return numbers;
}

}  // namespace sinew::gltf
