#pragma once
/// Triangles in a tree of boxes: which of them is nearest to a place, and whether a way is free of them.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

/// A place on a triangle.
struct SurfacePoint {
  std::size_t triangle = 0;
  Vec3 position{0.0};
  Vec3 shares{0.0};  ///< of the three corners, sum 1
  double distance = INFINITY;
};

class TriangleTree {
 public:
  using Filter = std::function<bool(std::size_t triangle)>;

  /// `triangles`: three indices each. Both are kept by reference and must outlive the tree.
  TriangleTree(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles);

  /// The nearest place that is no farther than `reach`, on a triangle that the filter lets pass.
  std::optional<SurfacePoint> nearest(const Vec3& p, double reach, const Filter& filter) const;
  /// The first crossing of the way from `start` in this direction, no farther than `reach` lengths of it.
  std::optional<double> first_crossing(const Vec3& start, const Vec3& direction, double reach) const;

 private:
  struct Box {
    Bounds bounds;
    std::uint32_t first = 0, count = 0;  ///< of `order_`; a node where count is 0
    std::uint32_t right = 0;             ///< the left child stands behind its parent
  };
  void build(std::uint32_t first, std::uint32_t count);
  std::array<Vec3, 3> corners(std::size_t triangle) const;

  std::span<const Vec3> positions_;
  std::span<const std::uint32_t> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Vec3> centres_;
  std::vector<Box> boxes_;
};

}  // namespace sinew
