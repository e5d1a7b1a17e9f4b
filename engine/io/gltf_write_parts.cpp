#include "engine/io/gltf_write_parts.h"

namespace sinew {
namespace {

template <class Vector>
std::vector<float> flattened(std::span<const Vector> vectors) {
  std::vector<float> out;
  out.reserve(vectors.size() * Vector::length());
  for (const Vector& v : vectors)
    for (int i = 0; i < Vector::length(); ++i) out.push_back(static_cast<float>(v[i]));
  return out;
}

}  // namespace

std::vector<float> floats(std::span<const Vec2> vectors) { return flattened(vectors); }
std::vector<float> floats(std::span<const Vec3> vectors) { return flattened(vectors); }
std::vector<float> floats(std::span<const Vec4> vectors) { return flattened(vectors); }

void set_unless_empty(Json& object, const char* key, Json array) {
  if (!array.empty()) object[key] = std::move(array);
}

}  // namespace sinew
