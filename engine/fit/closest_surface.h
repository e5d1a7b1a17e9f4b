#pragma once
/// The point of a triangle mesh that is nearest to any other point.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

struct SurfacePoint {
  std::array<std::uint32_t, 3> vertex{};       ///< of the triangle, in its order
  std::array<double, 3> share{1.0, 0.0, 0.0};  ///< barycentric coordinates
  double distance = INFINITY;
};

/// A tree of boxes over triangles; both spans outlive it.
class ClosestSurface {
 public:
  ClosestSurface(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles);

  /// Of points equally near the one in the first triangle. There has to be a triangle.
  SurfacePoint find(const Vec3& p) const;

 private:
  struct Box {
    Bounds bounds;
    std::uint32_t first = 0, count = 0;  ///< of a leaf; count 0: its children are `left` and `left + 1`
    std::uint32_t left = 0;
  };
  void build(std::uint32_t box, std::uint32_t first, std::uint32_t count);
  void visit(std::uint32_t box, const Vec3& p, SurfacePoint& best, std::uint32_t& triangle) const;

  std::span<const Vec3> positions_;
  std::span<const std::uint32_t> triangles_;
  std::vector<std::uint32_t> order_;  ///< triangles, leaf after leaf
  std::vector<Box> boxes_;
};

}  // namespace sinew
