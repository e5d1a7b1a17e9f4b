#pragma once
/// Deformed vertices to files: `sinew export`.

#include "engine/app/stage.h"
#include "engine/core/progress.h"
#include "engine/gpu/device.h"
#include "engine/io/vrm_write.h"
#include "engine/model/baked_mesh.h"

namespace sinew {

struct BakeOptions {
  SceneOptions scene;
  std::string output;   ///< .obj, .ply or .glb; with a run of '#', a file a frame
  bool by_cpu = false;  ///< vertices from the reference instead of the compute pass
  bool rig = false;     ///< skeleton, weights and morph targets instead of baked vertices; .glb or .vrm
  VrmMeta vrm;          ///< of a .vrm
  ProgressStyle progress = ProgressStyle::automatic;
};

struct BakeReport {
  std::size_t frames = 0, vertices = 0, triangles = 0;
};

/// What the name and the options ask for, checked without opening anything. Fails as usage.
Result<void> check_mesh_name(const BakeOptions& options);

/// Deforms frames and hands them out one by one. `device` may be null where `by_cpu` is set.
Result<BakedMesh> bake_frames(Device* device, const Stage& stage, const BakeOptions& options,
                              const std::vector<int>& frames);

/// Writes what was asked for.
Result<BakeReport> bake(Device* device, const Stage& stage, const BakeOptions& options);

}  // namespace sinew
