#include "engine/fit/nearest_bones.h"

#include <queue>
#include <tuple>

#include "engine/core/interrupt.h"

namespace sinew {
namespace {

constexpr double air_cost = 20.0;

/// A voxel that may be reached at `distance`; `direct`: if the straight line to the segment is free.
struct Reach {
  double distance;
  std::size_t cell;
  std::uint32_t segment;
  bool direct;
  double way;  ///< the distance if it is not

  auto key() const { return std::tuple(distance, segment, cell); }
  bool operator>(const Reach& other) const { return key() > other.key(); }
};

class Search {
 public:
  Search(const VoxelSolid& solid, std::span<const BoneSegment> segments, const StopCheck& check)
      : solid_(solid),
        segments_(segments),
        check_(check),
        nearest_(solid.cells.size(), no_segment),
        best_(solid.cells.size(), INFINITY),
        surface_left_(static_cast<std::size_t>(std::count(solid.cells.begin(), solid.cells.end(), Voxel::surface))) {
    for (std::uint32_t s = 0; s < segments.size(); ++s) seed(s);
  }

  Result<std::vector<std::uint32_t>> run() {
    for (std::size_t steps = 0; surface_left_ > 0 && !queue_.empty(); ++steps) {
      if (steps % 65536 == 0)
        if (auto ok = check_(); !ok) return pass_on(std::move(ok));
      Reach reach = queue_.top();
      queue_.pop();
      if (nearest_[reach.cell] != no_segment) continue;
      if (reach.direct && !solid_.sees(solid_.centre(reach.cell), nearest_point(reach))) {
        queue_.push({reach.way, reach.cell, reach.segment, false, reach.way});
        continue;
      }
      settle(reach);
    }
    return std::move(nearest_);
  }

 private:
  Vec3 nearest_point(const Reach& reach) const { return segments_[reach.segment].nearest(solid_.centre(reach.cell)); }

  void seed(std::uint32_t s) {
    const BoneSegment& segment = segments_[s];
    const int steps = static_cast<int>(std::ceil(2.0 * glm::length(segment.to - segment.from) / solid_.size));
    for (int i = 0; i <= steps; ++i) {
      const double t = steps == 0 ? 0.0 : static_cast<double>(i) / steps;
      const std::size_t cell = solid_.cell(glm::mix(segment.from, segment.to, t));
      if (!solid_.solid(cell)) continue;
      const Vec3 centre = solid_.centre(cell);
      const double distance = glm::length(centre - segment.nearest(centre));
      queue_.push({distance, cell, s, false, distance});
    }
  }

  void settle(const Reach& reach) {
    nearest_[reach.cell] = reach.segment;
    if (solid_.cells[reach.cell] == Voxel::surface) --surface_left_;
    const std::array<int, 3> at = solid_.place(reach.cell);
    std::array<int, 3> next{};
    for (next[0] = std::max(at[0] - 1, 0); next[0] <= std::min(at[0] + 1, solid_.count[0] - 1); ++next[0])
      for (next[1] = std::max(at[1] - 1, 0); next[1] <= std::min(at[1] + 1, solid_.count[1] - 1); ++next[1])
        for (next[2] = std::max(at[2] - 1, 0); next[2] <= std::min(at[2] + 1, solid_.count[2] - 1); ++next[2])
          offer(reach, solid_.index(next));
  }

  void offer(const Reach& from, std::size_t cell) {
    if (nearest_[cell] != no_segment) return;
    const bool solid = solid_.solid(cell);
    const Vec3 centre = solid_.centre(cell);
    const double step = glm::length(centre - solid_.centre(from.cell)) * (solid ? 1.0 : air_cost);
    const double way = from.distance + step;
    // The line may be free only where the body was never left.
    const double straight = glm::length(centre - segments_[from.segment].nearest(centre));
    const bool direct = solid && straight < way;
    const double distance = direct ? std::max(straight, from.distance - solid_.size) : way;
    if (distance >= best_[cell]) return;
    best_[cell] = std::min(best_[cell], static_cast<float>(way));
    queue_.push({distance, cell, from.segment, direct, way});
  }

  const VoxelSolid& solid_;
  std::span<const BoneSegment> segments_;
  const StopCheck& check_;
  std::vector<std::uint32_t> nearest_;
  std::vector<float> best_;  ///< [cells] the shortest way so far
  std::size_t surface_left_;
  std::priority_queue<Reach, std::vector<Reach>, std::greater<>> queue_;
};

}  // namespace

Result<std::vector<std::uint32_t>> nearest_bones(const VoxelSolid& solid, std::span<const BoneSegment> segments,
                                                 const StopCheck& check) {
  return Search(solid, segments, check).run();
}

}  // namespace sinew
