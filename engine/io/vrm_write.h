#pragma once
/// VRM 1.0 out: a rig as .glb with the extension VRMC_vrm.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/files.h"
#include "engine/core/result.h"
#include "engine/model/model.h"

namespace sinew {

/// What a VRM file says of its making and use, by VRM 1.0's keys. Keys that are not given have defaults: name "figure",
/// authors "unknown", licenseUrl that of the VRM public licence 1.0; the others are then left out, and VRM takes the
/// strictest.
struct VrmMeta {
  std::map<std::string, std::vector<std::string>> values;  ///< authors and references may have several
};

/// Adds "KEY=VALUE"; authors and references grow by one. Fails as usage, naming the known keys or values.
Result<void> add_vrm_meta(VrmMeta& meta, std::string_view word);

/// An expression of the face: the morph targets of that name, all of them. Overrides are VRM's words: none, block,
/// blend.
struct VrmExpression {
  std::string name;
  std::string mouth = "none", blink = "none", look = "none";
};

/// The model as rig_glb writes it, with the humanoid map (VRM 1.0 bone to node of the model), meta, and those of the
/// expressions that a mesh has morph targets for. The model should stand in a T pose (rig/t_pose.h). Fails as rig_glb
/// does.
Result<Bytes> vrm_glb(const Model& model, const std::map<std::string, int>& bones, const VrmMeta& meta,
                      std::span<const VrmExpression> expressions = {});

}  // namespace sinew
