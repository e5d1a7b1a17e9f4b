#include "engine/face/head_parts.h"

namespace sinew {
namespace {

constexpr std::uint32_t meridians = 32;
/// Radii as shares of the iris' angle.
constexpr double pupil_share = 0.47, limbus_share = 0.86;

struct Ring {
  double degrees;        ///< from the axis
  HeadMaterial outside;  ///< covers what lies between this ring and the next
};

std::vector<Ring> rings(double iris) {
  std::vector<Ring> out{{pupil_share * iris, HeadMaterial::iris},
                        {0.66 * iris, HeadMaterial::iris},
                        {limbus_share * iris, HeadMaterial::limbus},
                        {iris, HeadMaterial::sclera}};
  constexpr int back_rings = 17;
  for (int i = 1; i < back_rings; ++i)
    out.push_back({glm::mix(iris, 180.0, double(i) / back_rings), HeadMaterial::sclera});
  return out;
}

}  // namespace

HeadSurface build_eyeball(const HeadPlan& plan) {
  const std::vector<Ring> all = rings(plan.m.iris_angle);
  HeadSurface out;
  const auto add = [&](double degrees, double turn) {
    const double a = degrees * degrees_to_radians, s = std::sin(a);
    out.positions.push_back(plan.eye_centre +
                            plan.m.eye_radius * Vec3(s * std::cos(turn), s * std::sin(turn), std::cos(a)));
  };
  add(0.0, 0.0);
  for (const Ring& ring : all)
    for (std::uint32_t k = 0; k < meridians; ++k) add(ring.degrees, 2 * std::numbers::pi * k / meridians);
  add(180.0, 0.0);
  const auto back = static_cast<std::uint32_t>(out.positions.size() - 1);
  const auto at = [](std::size_t ring, std::uint32_t k) {
    return static_cast<std::uint32_t>(1 + ring * meridians + k % meridians);
  };
  for (std::uint32_t k = 0; k < meridians; ++k) {
    out.triangles.push_back({{0, at(0, k), at(0, k + 1)}, HeadMaterial::pupil});
    for (std::size_t r = 0; r + 1 < all.size(); ++r)
      out.quad(at(r, k), at(r + 1, k), at(r + 1, k + 1), at(r, k + 1), all[r].outside);
    out.triangles.push_back({{at(all.size() - 1, k), back, at(all.size() - 1, k + 1)}, HeadMaterial::sclera});
  }
  return out;
}

void HeadSurface::quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, HeadMaterial material) {
  triangles.push_back({{a, b, c}, material});
  triangles.push_back({{a, c, d}, material});
}

HeadSurface HeadSurface::mirrored() const {
  HeadSurface out = *this;
  for (Vec3& p : out.positions) p.x = -p.x;
  for (HeadTriangle& t : out.triangles) std::swap(t.corners[1], t.corners[2]);
  return out;
}

}  // namespace sinew
