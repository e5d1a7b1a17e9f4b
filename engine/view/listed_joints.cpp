#include "engine/view/listed_joints.h"

#include <map>

namespace sinew {

std::vector<ListedJoint> listed_joints(const StagedCharacter& character) {
  const Model& model = *character.model;
  std::vector<bool> is_joint(model.nodes.size(), false);
  for (const PaletteSource& entry : character.mesh.palette)
    if (entry.node >= 0) is_joint[static_cast<std::size_t>(entry.node)] = true;
  // A joint goes on being called what the scene calls it.
  std::map<int, std::string> called;
  for (const auto& [name, track] : character.scene.keys)
    if (const auto node = find_joint(model, character.humanoid, name)) called[*node] = name;
  std::vector<int> depth(model.nodes.size(), 0);
  std::vector<ListedJoint> out;
  for (const int node : character.order) {
    const auto n = static_cast<std::size_t>(node);
    const int parent = model.nodes[n].parent;
    depth[n] =
        parent < 0 ? 0 : depth[static_cast<std::size_t>(parent)] + (is_joint[static_cast<std::size_t>(parent)] ? 1 : 0);
    if (!is_joint[n]) continue;
    ListedJoint joint{model.nodes[n].name, model.nodes[n].name, depth[n], node};
    for (std::size_t bone = 0; bone < character.humanoid.node.size(); ++bone)
      if (character.humanoid.node[bone] == node) {
        const std::string humanoid(humanoid_name(static_cast<HumanoidBone>(bone)));
        if (joint.name.empty())
          joint.name = joint.shown = humanoid;
        else if (humanoid != joint.name)
          joint.shown += "  (" + humanoid + ")";
      }
    // Scenes name joints: what has no name cannot be keyed.
    if (joint.name.empty()) continue;
    if (const auto name = called.find(node); name != called.end()) joint.name = name->second;
    out.push_back(std::move(joint));
  }
  return out;
}

std::string called_joint(const StagedCharacter& character, const std::string& name) {
  const auto node = find_joint(*character.model, character.humanoid, name);
  const std::string called = node ? joint_name(character, *node) : "";
  return called.empty() ? name : called;
}

std::string joint_name(const StagedCharacter& character, int node) {
  for (const ListedJoint& joint : listed_joints(character))
    if (joint.node == node) return joint.name;
  return {};
}

}  // namespace sinew
