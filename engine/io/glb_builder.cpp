#include "engine/io/glb_builder.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace sinew {
namespace {

static_assert(std::endian::native == std::endian::little,
              "glTF's numbers are little-endian and are copied as they are");

constexpr int type_u8 = 5121, type_u16 = 5123, type_u32 = 5125, type_float = 5126;
constexpr std::uint32_t chunk_json = 0x4E4F534A, chunk_binary = 0x004E4942;

struct ShapeName {
  const char* name;
  std::size_t width;
};

ShapeName shape_name(AccessorShape shape) {
  switch (shape) {
    case AccessorShape::scalar:
      return {"SCALAR", 1};
    case AccessorShape::vec2:
      return {"VEC2", 2};
    case AccessorShape::vec3:
      return {"VEC3", 3};
    case AccessorShape::vec4:
      return {"VEC4", 4};
    case AccessorShape::mat4:
      return {"MAT4", 16};
  }
  return {};
}

template <class T>
std::span<const unsigned char> as_bytes(std::span<const T> values) {
  return {reinterpret_cast<const unsigned char*>(values.data()), values.size_bytes()};
}

template <class T>
std::vector<T> narrowed(std::span<const std::uint32_t> values) {
  return {values.begin(), values.end()};
}

void write_bounds(std::span<const float> values, std::size_t width, Json& accessor) {
  std::vector<float> low(values.begin(), values.begin() + width), high = low;
  for (std::size_t i = 0; i < values.size(); ++i) {
    low[i % width] = std::min(low[i % width], values[i]);
    high[i % width] = std::max(high[i % width], values[i]);
  }
  accessor["min"] = low;
  accessor["max"] = high;
}

void append_u32(std::uint32_t value, Bytes& out) {
  const auto bytes = as_bytes(std::span<const std::uint32_t>(&value, 1));
  out.insert(out.end(), bytes.begin(), bytes.end());
}

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

void append_chunk(std::uint32_t type, std::span<const unsigned char> data, unsigned char padding, Bytes& out) {
  append_u32(static_cast<std::uint32_t>(padded(data.size())), out);
  append_u32(type, out);
  out.insert(out.end(), data.begin(), data.end());
  out.insert(out.end(), padded(data.size()) - data.size(), padding);
}

}  // namespace

GlbBuilder::GlbBuilder() { json["asset"] = {{"version", "2.0"}, {"generator", "sinew"}}; }

int GlbBuilder::add_view(std::span<const unsigned char> bytes, ViewTarget target) {
  binary_.resize(padded(binary_.size()));
  Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
  if (target != ViewTarget::none) view["target"] = static_cast<int>(target);
  views_.push_back(std::move(view));
  binary_.insert(binary_.end(), bytes.begin(), bytes.end());
  return static_cast<int>(views_.size()) - 1;
}

int GlbBuilder::add_accessor(int view, int component_type, std::size_t count, AccessorShape shape) {
  accessors_.push_back(
      {{"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", shape_name(shape).name}});
  return static_cast<int>(accessors_.size()) - 1;
}

void GlbBuilder::check_finite(const std::string& place, std::span<const float> values, std::size_t width) {
  const auto bad = std::find_if_not(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
  if (bad != values.end())
    fail(fmt::format("{}: number {} of element {} is not finite as a 32-bit float; glTF holds finite numbers only",
                     place, (bad - values.begin()) % width, (bad - values.begin()) / width));
}

int GlbBuilder::add_floats(const std::string& place, std::span<const float> values, AccessorShape shape,
                           ViewTarget target, AccessorBounds bounds) {
  const std::size_t width = shape_name(shape).width;
  assert(!values.empty() && values.size() % width == 0);
  check_finite(place, values, width);
  const int accessor = add_accessor(add_view(as_bytes(values), target), type_float, values.size() / width, shape);
  if (bounds == AccessorBounds::written) write_bounds(values, width, accessors_.back());
  return accessor;
}

int GlbBuilder::add_sparse_floats(const std::string& place, std::span<const float> values, AccessorShape shape,
                                  AccessorBounds bounds) {
  const std::size_t width = shape_name(shape).width, count = values.size() / width;
  assert(!values.empty() && values.size() % width == 0);
  std::vector<std::uint32_t> indices;
  std::vector<float> kept;
  for (std::size_t i = 0; i < count; ++i) {
    const std::span<const float> element = values.subspan(i * width, width);
    if (std::all_of(element.begin(), element.end(), [](float v) { return v == 0.0f; })) continue;
    indices.push_back(static_cast<std::uint32_t>(i));
    kept.insert(kept.end(), element.begin(), element.end());
  }
  if (indices.size() * (width + 1) >= count * width)
    return add_floats(place, values, shape, ViewTarget::vertices, bounds);
  check_finite(place, values, width);
  if (indices.empty()) {
    // A sparse accessor has at least one element.
    indices.push_back(0);
    kept.assign(width, 0.0f);
  }
  const int index_view = add_view(as_bytes(std::span<const std::uint32_t>(indices)), ViewTarget::none);
  const int value_view = add_view(as_bytes(std::span<const float>(kept)), ViewTarget::none);
  accessors_.push_back({{"componentType", type_float},
                        {"count", count},
                        {"type", shape_name(shape).name},
                        {"sparse",
                         {{"count", indices.size()},
                          {"indices", {{"bufferView", index_view}, {"componentType", type_u32}}},
                          {"values", {{"bufferView", value_view}}}}}});
  if (bounds == AccessorBounds::written) write_bounds(values, width, accessors_.back());
  return static_cast<int>(accessors_.size()) - 1;
}

int GlbBuilder::add_unsigned(std::span<const std::uint32_t> values, AccessorShape shape, ViewTarget target) {
  assert(!values.empty());
  const std::uint32_t largest = *std::max_element(values.begin(), values.end());
  const std::size_t count = values.size() / shape_name(shape).width;
  if (target == ViewTarget::indices && largest >= 0xFFFF)
    return add_accessor(add_view(as_bytes(values), target), type_u32, count, shape);
  if (target == ViewTarget::indices || largest > 0xFF) {
    const std::vector<std::uint16_t> narrow = narrowed<std::uint16_t>(values);
    return add_accessor(add_view(as_bytes(std::span(narrow)), target), type_u16, count, shape);
  }
  const std::vector<std::uint8_t> narrow = narrowed<std::uint8_t>(values);
  return add_accessor(add_view(narrow, target), type_u8, count, shape);
}

int GlbBuilder::add_bytes(std::span<const unsigned char> bytes) { return add_view(bytes, ViewTarget::none); }

void GlbBuilder::fail(std::string reason) {
  if (failure_.empty()) failure_ = std::move(reason);
}

Result<Bytes> GlbBuilder::finish() {
  if (!failure_.empty()) return bad_input("{}", failure_);
  if (!binary_.empty()) {
    json["accessors"] = std::move(accessors_);
    json["bufferViews"] = std::move(views_);
    json["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
  }
  // Names come from other people's files; one that is no UTF-8 must not cost the whole export.
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);

  const std::size_t binary_chunk = binary_.empty() ? 0 : 8 + padded(binary_.size());
  const std::size_t size = 12 + 8 + padded(text.size()) + binary_chunk;
  if (size > std::numeric_limits<std::uint32_t>::max())
    return bad_input("a .glb of {} bytes cannot be written: its lengths end at 4 GiB; export fewer frames at once",
                     size);

  Bytes file;
  file.reserve(size);
  append_u32(0x46546C67, file);
  append_u32(2, file);
  append_u32(static_cast<std::uint32_t>(size), file);
  append_chunk(chunk_json, as_bytes(std::span<const char>(text)), ' ', file);
  if (!binary_.empty()) append_chunk(chunk_binary, binary_, 0, file);
  return file;
}

}  // namespace sinew
