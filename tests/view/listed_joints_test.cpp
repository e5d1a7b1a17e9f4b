#include "engine/view/listed_joints.h"

#include "tests/view/opened_document.h"

namespace sinew::test {
namespace {

std::string listed(const Document& document, const std::string& node) {
  for (const ListedJoint& joint : listed_joints(document.stage().characters[0]))
    if (document.stage().characters[0].model->nodes[static_cast<std::size_t>(joint.node)].name == node)
      return joint.name;
  return "";
}

TEST(ListedJoints, AJointOfTwoNamesHasOneTrack) {
  Document document = opened("builtin:woman");
  EXPECT_EQ(listed(document, "l_elbow"), "l_elbow");
  const auto called = [&](const char* name) { return called_joint(document.stage().characters[0], name); };
  EXPECT_EQ(called("leftLowerArm"), "l_elbow");
  EXPECT_EQ(called("nobody"), "nobody");
  Scene scene = document.scene();
  set_joint_degrees(scene.characters[0], "leftLowerArm", 0, {0, -40, 0});
  ASSERT_TRUE(document.edit(scene, "a key by the humanoid name"));
  EXPECT_EQ(listed(document, "l_elbow"), "leftLowerArm") << "the list goes on with the scene's name";
  EXPECT_EQ(called("l_elbow"), "leftLowerArm") << "so does whoever chose it before";
  set_joint_degrees(scene.characters[0], called("l_elbow"), 0, {0, -60, 0});
  EXPECT_EQ(scene.characters[0].keys.size(), 1u);
}

TEST(ListedJoints, AJointWithoutANameIsCalledByItsHumanoidName) {
  const Document document = opened("builtin:woman");
  const StagedCharacter& woman = document.stage().characters[0];
  const auto model = std::make_shared<Model>(*woman.model);
  for (Node& node : model->nodes) node.name.clear();
  StagedCharacter nameless;
  nameless.model = model;
  nameless.mesh = woman.mesh;
  nameless.order = woman.order;
  nameless.humanoid = woman.humanoid;
  const std::vector<ListedJoint> joints = listed_joints(nameless);
  EXPECT_NE(std::ranges::find(joints, "leftLowerArm", &ListedJoint::name), joints.end());
  EXPECT_EQ(std::ranges::find(joints, "", &ListedJoint::name), joints.end()) << "a scene could not name it";
}

}  // namespace
}  // namespace sinew::test
