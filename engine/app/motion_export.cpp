#include "engine/app/motion_export.h"

#include "engine/app/built_in_model.h"
#include "engine/core/text.h"
#include "engine/io/bvh.h"
#include "engine/io/gltf_read.h"
#include "engine/io/gltf_write.h"
#include "engine/io/vrm_animation.h"
#include "engine/model/character_mesh.h"
#include "engine/model/scene_words.h"
#include "engine/rig/pose.h"
#include "engine/rig/retarget.h"
#include "engine/rig/t_pose_motion.h"

namespace sinew {
namespace {

Result<Bytes> as_vrm_animation(const Motion& motion) {
  const auto posed = t_pose_motion(motion);
  if (!posed) return tl::unexpected<Error>(posed.error());
  std::map<std::string, int> bones;
  for (std::size_t i = 0; i < humanoid_bone_count; ++i)
    if (posed->humanoid.node[i] >= 0)
      bones[std::string(humanoid_name(static_cast<HumanoidBone>(i)))] = posed->humanoid.node[i];
  return vrm_animation_glb(posed->model, bones);
}

Result<Bytes> on_model(const Motion& motion, const std::filesystem::path& file) {
  auto model = is_built_in_model(file.string()) ? built_in_model(file.string()) : read_gltf(file);
  if (!model) return pass_on(std::move(model));
  const std::vector<Mat4> rest = global_transforms(*model, hierarchy_order(*model), rest_pose(*model));
  auto retargeted = retarget(motion, *model, find_humanoid(*model, rest));
  if (!retargeted) return pass_on(std::move(retargeted));
  model->clips = {std::move(retargeted->clip)};
  return rig_glb(*model);
}

}  // namespace

Result<Bytes> motion_file_bytes(const Motion& motion, const std::filesystem::path& output,
                                const std::optional<std::filesystem::path>& model) {
  const std::string extension = lower(output.extension().string());
  if (extension == ".bvh") {
    const std::string text = bvh_text(motion);
    return Bytes(text.begin(), text.end());
  }
  if (extension == ".vrma") return as_vrm_animation(motion);
  if (extension != ".glb")
    return failure(ErrorKind::usage, "{}: motions are written as .bvh, .vrma, or as .glb on a model", output.string());
  if (!model)
    return failure(ErrorKind::usage, "{}: a glTF animation moves a model: name it, such as --model builtin:figure",
                   output.string());
  return on_model(motion, *model);
}

Result<void> export_motion(const Motion& motion, const std::filesystem::path& output,
                           const std::optional<std::filesystem::path>& model) {
  auto bytes = motion_file_bytes(motion, output, model);
  if (!bytes) return pass_on(std::move(bytes));
  return write_file(output, *bytes);
}

}  // namespace sinew
