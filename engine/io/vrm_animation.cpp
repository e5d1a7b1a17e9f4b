#include "engine/io/vrm_animation.h"

#include <algorithm>

#include "engine/io/gltf_write_parts.h"

namespace sinew {

Result<Bytes> vrm_animation_glb(const Model& model, const std::map<std::string, int>& bones) {
  Model written = model;
  written.clips.resize(std::min<std::size_t>(written.clips.size(), 1));
  const auto hips = bones.find("hips");
  const auto allowed = [&](const Channel& channel) {
    if (channel.path == ChannelPath::translation) return hips != bones.end() && channel.node == hips->second;
    return channel.path == ChannelPath::rotation &&
           std::ranges::any_of(bones, [&](const auto& bone) { return bone.second == channel.node; });
  };
  for (Clip& clip : written.clips)
    std::erase_if(clip.channels, [&](const Channel& channel) { return !allowed(channel); });
  GlbBuilder glb;
  write_rig(written, glb);
  Json human_bones = Json::object();
  for (const auto& [bone, node] : bones) human_bones[bone] = {{"node", node}};
  glb.json["extensionsUsed"] = Json::array({"VRMC_vrm_animation"});
  glb.json["extensions"]["VRMC_vrm_animation"] = {{"specVersion", "1.0"}, {"humanoid", {{"humanBones", human_bones}}}};
  return glb.finish();
}

}  // namespace sinew
