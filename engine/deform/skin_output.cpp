#include "engine/deform/skin_output.h"

namespace sinew {

Result<void> validate_skinning(const SkinInput& input, const SkinOutput& output) {
  const std::size_t vertices = input.positions.size();
  const auto check = [&](const char* what, std::size_t size) -> Result<void> {
    if (size == vertices) return {};
    return bad_input("skinning: {} has {} entries, expected {} (one a vertex)", what, size, vertices);
  };
  const std::pair<const char*, std::size_t> spans[] = {{"normals", input.normals.size()},
                                                       {"influences", input.influences.vertices()},
                                                       {"posed positions", output.positions.size()},
                                                       {"posed normals", output.normals.size()}};
  for (const auto& [what, size] : spans)
    if (auto ok = check(what, size); !ok) return ok;
  if (!output.blend.empty())
    if (auto ok = check("blend", output.blend.size()); !ok) return ok;

  for (std::size_t v = 0; v < vertices; ++v) {
    if (input.influences.first[v] == input.influences.first[v + 1])
      return bad_input("skinning: vertex {} follows no joint", v);
    for (std::uint32_t i = input.influences.first[v]; i < input.influences.first[v + 1]; ++i)
      if (input.influences.entries[i].joint >= input.palette.size())
        return bad_input("skinning: vertex {} names joint {}, the palette has {}", v, input.influences.entries[i].joint,
                         input.palette.size());
  }
  return {};
}

Vec3 carry_normal(const Mat3& blend, const Vec3& normal) {
  const Mat3 cofactors = cofactor(blend);
  const double side = glm::dot(blend[0], cofactors[0]) < 0.0 ? -1.0 : 1.0;
  return unit_or(side * (cofactors * normal), unit_or(normal, Vec3(0, 0, 1)));
}

Vec4 carry_tangent(const Mat3& blend, const Vec4& tangent) {
  return Vec4(blend * Vec3(tangent), glm::determinant(blend) < 0.0 ? -tangent.w : tangent.w);
}

Vec4 tangent_in_plane(const Vec4& tangent, const Vec3& normal) {
  const Vec3 t(tangent);
  return Vec4(unit_or(t - glm::dot(t, normal) * normal, Vec3(0.0)), tangent.w);
}

}  // namespace sinew
