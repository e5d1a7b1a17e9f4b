#include "tools/motion_report.h"

#include "engine/rig/motion_file.h"
#include "engine/rig/motion_rig.h"

namespace sinew::tools {

Result<nlohmann::ordered_json> motion_report(const std::filesystem::path& file) {
  using Json = nlohmann::ordered_json;
  const auto motions = read_motions(file);
  if (!motions) return tl::unexpected<Error>(motions.error());
  const Motion& motion = motions->front();
  const MotionRig rig = motion_rig(motion);
  Json clips = Json::array(), joints = Json::array(), humanoid = Json::object();
  for (const Motion& m : *motions)
    clips.push_back({{"name", m.name}, {"duration", m.duration()}, {"frames", m.frames.size()}});
  for (const MotionJoint& joint : motion.skeleton.joints) joints.push_back(joint.name);
  for (std::size_t i = 0; i < humanoid_bone_count; ++i)
    if (const int node = rig.humanoid.node[i]; node >= 0)
      humanoid[std::string(humanoid_name(static_cast<HumanoidBone>(i)))] =
          rig.model.nodes[static_cast<std::size_t>(node)].name;
  std::vector<std::string> problems = motion.problems;
  problems.insert(problems.end(), rig.notes.begin(), rig.notes.end());
  return Json{{"name", motion.name},
              {"frames", motion.frames.size()},
              {"duration", motion.duration()},
              {"fps", 1.0 / motion.frame_time},
              {"joints", motion.skeleton.joints.size()},
              {"joint_names", joints},
              {"clips", clips},
              {"humanoid", humanoid},
              {"up", {rig.up.x, rig.up.y, rig.up.z}},
              {"hip_height", rig.height},
              {"metres_per_unit", rig.metres_per_unit},
              {"problems", problems}};
}

}  // namespace sinew::tools
