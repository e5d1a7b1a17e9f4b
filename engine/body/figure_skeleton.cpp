#include "engine/body/figure_skeleton.h"

#include <cassert>
#include <map>

namespace sinew {
namespace {

/// A joint of the full hierarchy. Names that begin with "l_" stand for both sides.
struct JointPlan {
  std::string name, parent;
  int least_count;  ///< the smallest skeleton that has it
  Vec3 position;
};

/// The elbow's axis lies a little before the middle of the arm, so that the point of the elbow stays when it bends.
constexpr double elbow_forward = 0.003;

void plan_trunk(const MeasuredBody& body, std::vector<JointPlan>& plan) {
  const auto at = [&](const char* name) { return body.joint(name); };
  const Vec3 hips = 0.5 * (at("pelvis") + Vec3{0, at("upperleg01").y, at("pelvis").z});
  plan.push_back({"humanoid_root", "", 23, {0, hips.y, hips.z}});
  plan.push_back({"sacroiliac", "humanoid_root", 23, at("pelvis")});
  plan.push_back({"vl5", "humanoid_root", 23, at("spine04")});
  plan.push_back({"vl3", "vl5", 68, at("spine03")});
  plan.push_back({"vl1", "vl3", 23, at("spine02")});
  plan.push_back({"vt10", "vl1", 68, glm::mix(at("spine02"), at("spine01"), 0.5)});
  plan.push_back({"vt6", "vt10", 23, at("spine01")});
  plan.push_back({"vt1", "vt6", 68, glm::mix(at("spine01"), at("neck01"), 0.6)});
  plan.push_back({"vc4", "vt1", 23, at("neck01")});
  plan.push_back({"vc2", "vc4", 68, at("neck03")});
  plan.push_back({"skullbase", "vc2", 23, at("head")});
  plan.push_back({"temporomandibular", "skullbase", 68, at("head") + Vec3{0, 0.006, 0.022}});
}

void plan_leg(const MeasuredBody& body, std::vector<JointPlan>& plan) {
  const auto at = [&](const char* name) { return body.joint(name); };
  plan.push_back({"l_hip", "sacroiliac", 23, at("upperleg01")});
  plan.push_back({"l_knee", "l_hip", 23, at("lowerleg01")});
  plan.push_back({"l_talocrural", "l_knee", 23, at("foot")});
  plan.push_back({"l_tarsometatarsal", "l_talocrural", 68, glm::mix(at("foot"), at("toe2-1"), 0.5)});
  plan.push_back({"l_metatarsophalangeal", "l_tarsometatarsal", 23, at("toe2-1")});
  plan.push_back({"l_tarsal_interphalangeal", "l_metatarsophalangeal", 68, at("toe2-2")});
}

void plan_arm(const MeasuredBody& body, std::vector<JointPlan>& plan) {
  const auto at = [&](const std::string& name) { return body.joint(name); };
  const Vec3 elbow = at("lowerarm01") + Vec3{0, 0, elbow_forward};
  plan.push_back({"l_sternoclavicular", "vt1", 23, at("clavicle")});
  plan.push_back({"l_acromioclavicular", "l_sternoclavicular", 68, at("shoulder01")});
  plan.push_back({"l_shoulder", "l_acromioclavicular", 23, at("upperarm01")});
  plan.push_back({"l_upperarm_twist", "l_shoulder", 68, glm::mix(at("upperarm01"), elbow, 0.5)});
  plan.push_back({"l_elbow", "l_upperarm_twist", 23, elbow});
  plan.push_back({"l_forearm_twist", "l_elbow", 68, glm::mix(elbow, at("wrist"), 0.5)});
  plan.push_back({"l_radiocarpal", "l_forearm_twist", 23, at("wrist")});
  plan.push_back({"l_carpometacarpal_1", "l_radiocarpal", 37, at("finger1-1")});
  plan.push_back({"l_metacarpophalangeal_1", "l_carpometacarpal_1", 37, at("finger1-2")});
  plan.push_back({"l_carpal_interphalangeal_1", "l_metacarpophalangeal_1", 37, at("finger1-3")});
  for (int finger = 2; finger <= 5; ++finger) {
    const std::string number = std::to_string(finger), measured = "finger" + number + "-";
    plan.push_back({"l_metacarpophalangeal_" + number, "l_radiocarpal", 37, at(measured + "1")});
    plan.push_back(
        {"l_carpal_proximal_interphalangeal_" + number, "l_metacarpophalangeal_" + number, 68, at(measured + "2")});
    plan.push_back({"l_carpal_distal_interphalangeal_" + number, "l_carpal_proximal_interphalangeal_" + number, 68,
                    at(measured + "3")});
  }
}

bool is_left(const std::string& name) { return name.starts_with("l_"); }

std::string right_of(std::string name) {
  if (is_left(name)) name[0] = 'r';
  return name;
}

/// All joints of both sides, parents first.
const std::vector<JointPlan> full_plan(const MeasuredBody& body) {
  std::vector<JointPlan> half, plan;
  plan_trunk(body, plan);
  for (const auto part : {plan_leg, plan_arm}) {
    half.clear();
    part(body, half);
    plan.insert(plan.end(), half.begin(), half.end());
    for (const JointPlan& left : half)
      plan.push_back({right_of(left.name),
                      right_of(left.parent),
                      left.least_count,
                      {-left.position.x, left.position.y, left.position.z}});
  }
  return plan;
}

/// Parents in the full hierarchy, for joints that a skeleton lacks.
const std::map<std::string, std::string, std::less<>>& full_parents() {
  static const auto parents = [] {
    std::map<std::string, std::string, std::less<>> out;
    for (const JointPlan& joint : full_plan(measured_body(0.0, 0.0, 0.5))) out[joint.name] = joint.parent;
    return out;
  }();
  return parents;
}

int index_of_name(const std::vector<FigureJoint>& joints, std::string_view name) {
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (joints[i].name == name) return static_cast<int>(i);
  return -1;
}

}  // namespace

bool FigureSkeleton::has(std::string_view name) const { return index_of_name(joints, name) >= 0; }

int FigureSkeleton::find(std::string_view name) const {
  const int found = index_of_name(joints, name);
  if (found >= 0) return found;
  const auto parent = full_parents().find(name);
  assert(parent != full_parents().end() && !parent->second.empty());
  return find(parent->second);
}

FigureSkeleton figure_skeleton(const MeasuredBody& body, int count) {
  FigureSkeleton skeleton;
  for (const JointPlan& plan : full_plan(body)) {
    if (plan.least_count > count) continue;
    FigureJoint joint;
    joint.name = plan.name;
    joint.position = plan.position;
    if (!plan.parent.empty()) joint.parent = skeleton.find(plan.parent);
    skeleton.joints.push_back(joint);
  }
  assert(skeleton.joints.size() == static_cast<std::size_t>(count));
  for (FigureJoint& joint : skeleton.joints) {
    std::string other = joint.name;
    if (other.starts_with("l_") || other.starts_with("r_")) other[0] = other[0] == 'l' ? 'r' : 'l';
    joint.mirror = index_of_name(skeleton.joints, other);
  }
  return skeleton;
}

}  // namespace sinew
