#pragma once
/// Which bone each voxel of a body is nearest to, measured inside the body.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/interrupt.h"
#include "engine/core/task_watch.h"
#include "engine/fit/bone_segments.h"
#include "engine/fit/voxel_solid.h"

namespace sinew {

/// No segment: see nearest_bones().
constexpr std::uint32_t no_segment = ~0u;

/// The segment nearest to every surface voxel, [cells], no_segment for voxels that were not needed. Dijkstra's search
/// from all segments at once over 26 neighbours; where a straight line to the segment stays in the solid its length
/// counts instead of the way's. Air is crossed at twenty times the cost: loose pieces find a bone too, and no bone
/// reaches across a gap that has a way round. Fails as `check` does, asked now and then.
Result<std::vector<std::uint32_t>> nearest_bones(const VoxelSolid& solid, std::span<const BoneSegment> segments,
                                                 const StopCheck& check = check_interrupt);

}  // namespace sinew
