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

}  // namespace
}  // namespace sinew::test
