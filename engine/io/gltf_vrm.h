#pragma once
/// The humanoid map that VRM files carry: VRM 1.0 (VRMC_vrm), VRM 0.x (VRM) and VRM animations (VRMC_vrm_animation).

#include <map>
#include <string>

#include "engine/io/gltf_document.h"

namespace sinew::gltf {

/// Humanoid name in VRM 1.0's spelling -> node. Entries that name no node of the file are left out and noted. A file
/// with both extensions is read by VRMC_vrm.
std::map<std::string, int> read_vrm_bones(Document& document);

}  // namespace sinew::gltf
