#include "engine/deform/rigid_split.h"

#include <map>

namespace sinew {

RigidSplit split_by_bone(const CharacterMesh& mesh) {
  RigidSplit split;
  split.triangles = mesh.triangles;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> copies;
  const auto joint_of = [&](std::uint32_t v) { return mesh.influences.entries[mesh.influences.first[v]].joint; };
  for (std::size_t i = 0; i + 2 < split.triangles.size(); i += 3) {
    std::uint32_t* corner = &split.triangles[i];
    const std::uint32_t joint = joint_of(corner[1]) == joint_of(corner[2]) ? joint_of(corner[1]) : joint_of(corner[0]);
    for (int k = 0; k < 3; ++k) {
      if (joint_of(corner[k]) == joint) continue;
      const auto number = static_cast<std::uint32_t>(mesh.vertices() + split.duplicates.size());
      const auto [found, added] = copies.try_emplace({corner[k], joint}, number);
      if (added) split.duplicates.push_back({corner[k], joint});
      corner[k] = found->second;
    }
  }
  return split;
}

}  // namespace sinew
