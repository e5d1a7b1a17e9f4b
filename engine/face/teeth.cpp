#include "engine/face/head_parts.h"

namespace sinew {
namespace {

constexpr int teeth = 12, steps_a_tooth = 4;
constexpr double arch_end = 0.92;

/// The row's profile from the inside over the edge and the front to the gum: out of the arch, and along the height.
constexpr double profile[][2] = {{-0.07, 0.10},  {-0.05, 0.0},  {-0.012, -0.01}, {0.006, 0.10}, {0.012, 0.45},
                                 {-0.005, 0.92}, {0.004, 1.03}, {-0.045, 1.45},  {-0.12, 1.6}};
constexpr std::uint32_t profile_points = std::size(profile), first_gum = 5;

struct Arch {
  double half_width, depth, front;

  /// u from -1 (right) to 1.
  Vec3 at(double u) const {
    const double a = 0.5 * std::numbers::pi * u;
    return {half_width * std::sin(a), 0.0, front - depth * (1.0 - std::pow(std::cos(a), 0.75))};
  }
  Vec3 outward(double u) const {
    const Vec3 along = at(u + 1e-3) - at(u - 1e-3);
    return glm::normalize(Vec3(-along.z, 0.0, along.x));
  }
};

}  // namespace

HeadSurface build_teeth(const HeadPlan& plan, bool upper) {
  const double scale = plan.mouth_scale, sign = upper ? 1.0 : -1.0;
  const double height = (upper ? 0.19 : 0.17) * scale, edge = plan.mouth + (upper ? 0.0 : -0.05);
  const Arch arch{0.86 * plan.m.mouth_width, 0.75 * scale, plan.lip_line - 0.068};
  HeadSurface out;
  constexpr int steps = teeth * steps_a_tooth;
  for (int i = 0; i <= steps; ++i) {
    // From the middle outwards both ways, so that the halves mirror each other exactly.
    const double u = (2 * i - steps) / double(steps) * arch_end;
    const int in_tooth = std::min(i % steps_a_tooth, steps_a_tooth - i % steps_a_tooth);
    const double bulge = std::sqrt(std::sin(std::numbers::pi * in_tooth / steps_a_tooth));
    const Vec3 middle = arch.at(std::abs(u)), away = arch.outward(std::abs(u));
    for (const auto& [out_of_arch, along] : profile) {
      const double notch = along < 1 ? 0.006 * (1 - bulge) : 0.0;
      const double rise = sign * (along * height + (along < 0.05 ? 0.006 * (1 - bulge) : 0.0));
      Vec3 p = middle + (out_of_arch - notch) * away;
      if (2 * i == steps) p.x = 0.0;
      out.positions.emplace_back(u < 0 ? -p.x : p.x, edge + rise, p.z);
    }
  }
  for (std::uint32_t i = 0; i < steps; ++i)
    for (std::uint32_t k = 0; k + 1 < profile_points; ++k) {
      const std::uint32_t a = i * profile_points + k, b = a + profile_points;
      const HeadMaterial material = k < first_gum ? HeadMaterial::teeth : HeadMaterial::gum;
      if (upper)
        out.quad(a, b, b + 1, a + 1, material);
      else
        out.quad(a, a + 1, b + 1, b, material);
    }
  return out;
}

HeadSurface build_tongue(const HeadPlan& plan) {
  constexpr std::uint32_t rings = 10, round = 16;
  const Vec3 centre(0.0, plan.mouth - 0.10, plan.lip_line - 0.59), radii(0.24 * plan.mouth_scale, 0.085, 0.42);
  HeadSurface out;
  // Counted from the top; the right half is the left's mirror image to the bit.
  const auto add = [&](double polar, std::uint32_t k) {
    const double s = std::sin(polar), turn = 2 * std::numbers::pi * std::min(k, round - k) / round;
    const double x = 2 * k % round == 0 ? 0.0 : (2 * k < round ? -1.0 : 1.0) * s * std::sin(turn);
    out.positions.push_back(centre + radii * Vec3(x, s * std::cos(turn), std::cos(polar)));
  };
  add(0.0, 0);
  for (std::uint32_t r = 1; r < rings; ++r)
    for (std::uint32_t k = 0; k < round; ++k) add(std::numbers::pi * r / rings, k);
  add(std::numbers::pi, 0);
  const auto at = [](std::uint32_t r, std::uint32_t k) { return 1 + (r - 1) * round + k % round; };
  const auto back = static_cast<std::uint32_t>(out.positions.size() - 1);
  for (std::uint32_t k = 0; k < round; ++k) {
    out.triangles.push_back({{0, at(1, k), at(1, k + 1)}, HeadMaterial::tongue});
    for (std::uint32_t r = 1; r + 1 < rings; ++r)
      out.quad(at(r, k), at(r + 1, k), at(r + 1, k + 1), at(r, k + 1), HeadMaterial::tongue);
    out.triangles.push_back({{at(rings - 1, k), back, at(rings - 1, k + 1)}, HeadMaterial::tongue});
  }
  return out;
}

}  // namespace sinew
