/// Motions from every kind of file, and back out as VRM and glTF animations.

#include "engine/rig/motion_file.h"

#include <gtest/gtest.h>

#include "engine/io/bvh.h"
#include "engine/io/gltf_read.h"
#include "engine/io/gltf_write.h"
#include "engine/io/vrm_animation.h"
#include "engine/model/character_mesh.h"
#include "engine/rig/clip_motion.h"
#include "engine/rig/clip_sampling.h"
#include "engine/rig/motion_rig.h"
#include "engine/rig/pose.h"
#include "engine/rig/retarget.h"
#include "engine/rig/t_pose_motion.h"
#include "tests/support/assets.h"
#include "tests/support/motion_samples.h"

namespace sinew::test {
namespace {

using enum HumanoidBone;
namespace fs = std::filesystem;

constexpr std::pair<HumanoidBone, HumanoidBone> limbs[] = {
    {left_upper_arm, left_lower_arm},   {left_lower_arm, left_hand},        {left_upper_leg, left_lower_leg},
    {left_lower_leg, left_foot},        {right_upper_arm, right_lower_arm}, {right_lower_arm, right_hand},
    {right_upper_leg, right_lower_leg}, {right_lower_leg, right_foot},
};

/// The largest angle between the limbs of two motions of the same frames, degrees; both with up as +Y.
double worst_limb(const Motion& a, const Motion& b) {
  const MotionRig rig_a = motion_rig(a), rig_b = motion_rig(b);
  EXPECT_EQ(a.frames.size(), b.frames.size());
  double worst = 0.0;
  for (std::size_t f = 0; f < std::min(a.frames.size(), b.frames.size()); ++f) {
    const MotionPose pa = motion_pose(a, f), pb = motion_pose(b, f);
    for (const auto& [from, to] : limbs)
      worst = std::max(worst, angle_degrees(pa.places[rig_a.humanoid.find(to)] - pa.places[rig_a.humanoid.find(from)],
                                            pb.places[rig_b.humanoid.find(to)] - pb.places[rig_b.humanoid.find(from)]));
  }
  return worst;
}

std::map<std::string, int> bone_map(const Humanoid& humanoid) {
  std::map<std::string, int> bones;
  for (std::size_t i = 0; i < humanoid_bone_count; ++i)
    if (humanoid.node[i] >= 0) bones[std::string(humanoid_name(static_cast<HumanoidBone>(i)))] = humanoid.node[i];
  return bones;
}

TEST(MotionFile, EveryMotionOfTheAssetsIsReadAndItsBodyFound) {
  SINEW_ASSETS_OR_SKIP(folder);
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "motions")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".bvh" && extension != ".amc") continue;
    ++files;
    const auto motion = read_motion(entry.path());
    ASSERT_TRUE(motion) << motion.error().message;
    const MotionRig rig = motion_rig(*motion);
    EXPECT_TRUE(rig.humanoid.complete()) << entry.path();
    // A grown body's hips are 0.75 to 1.05 m over its ankles, whatever the file's unit.
    EXPECT_NEAR(rig.height * rig.metres_per_unit, 0.85, 0.15) << entry.path();
  }
  EXPECT_EQ(files, 8);
}

TEST(MotionFile, ContentTellsTheFormatAndNotTheName) {
  const auto format = [](const std::string& name, const std::string& text) {
    return motion_format(name, bytes_of(text));
  };
  EXPECT_EQ(format("x.txt", "\n hierarchy\nROOT a"), MotionFormat::bvh);
  EXPECT_EQ(format("x.txt", small_asf), MotionFormat::asf);
  EXPECT_EQ(format("x.txt", small_amc), MotionFormat::amc);
  EXPECT_EQ(format("x.bvh", "glTF..."), MotionFormat::gltf);
  EXPECT_EQ(format("x.bvh", "nonsense"), MotionFormat::bvh);
  EXPECT_EQ(format("x.txt", "nonsense"), std::nullopt);
}

TEST(MotionFile, ClipsOfAModelAreItsOwnAnimation) {
  SINEW_ASSETS_OR_SKIP(folder);
  const fs::path file = folder / "characters/khronos/CesiumMan_named.gltf";
  const auto model = read_gltf(file);
  ASSERT_TRUE(model);
  const auto motions = read_motions(file);
  ASSERT_TRUE(motions) << motions.error().message;
  ASSERT_EQ(motions->size(), 1u);
  const Motion& motion = motions->front();
  EXPECT_NEAR(motion.duration(), model->clips[0].duration, 1e-6);
  const std::vector<int> order = hierarchy_order(*model);
  for (const std::size_t f : {std::size_t{0}, motion.frames.size() / 2, motion.frames.size() - 1}) {
    Pose pose = rest_pose(*model);
    sample_clip(model->clips[0], static_cast<double>(f) * motion.frame_time, pose);
    const std::vector<Mat4> global = global_transforms(*model, order, pose);
    const MotionPose found = motion_pose(motion, f);
    for (std::size_t j = 0; j < motion.skeleton.joints.size(); ++j) {
      const auto node = std::find_if(model->nodes.begin(), model->nodes.end(),
                                     [&](const Node& n) { return n.name == motion.skeleton.joints[j].name; });
      ASSERT_NE(node, model->nodes.end());
      // Offsets that change by less than 1e-5 of the body count as still.
      EXPECT_LT(glm::length(Vec3(global[static_cast<std::size_t>(node - model->nodes.begin())][3]) - found.places[j]),
                1e-4)
          << motion.skeleton.joints[j].name;
    }
  }
}

TEST(MotionFile, VrmAnimationsComeBackAlike) {
  SINEW_ASSETS_OR_SKIP(folder);
  for (const char* name :
       {"motions/cmu_12_01_walk.bvh", "motions/cmu_asfamc/02_01.amc", "motions/bvh-toolbox/walk01.bvh"}) {
    const auto motion = read_motion(folder / name);
    ASSERT_TRUE(motion) << motion.error().message;
    const auto posed = t_pose_motion(*motion);
    ASSERT_TRUE(posed) << posed.error().message;
    const auto bytes = vrm_animation_glb(posed->model, bone_map(posed->humanoid));
    ASSERT_TRUE(bytes) << bytes.error().message;
    const auto back = read_motions("walk.vrma", *bytes);
    ASSERT_TRUE(back) << back.error().message;
    ASSERT_EQ(back->size(), 1u);
    EXPECT_NEAR(back->front().frame_time, motion->frame_time, 1e-5);
    // Its own bones by its own map; floats.
    EXPECT_LT(worst_limb(*motion, back->front()), 0.05) << name;
    EXPECT_EQ(back->front().skeleton.humanoid.count("hips"), 1u);
    const MotionRig rig = motion_rig(back->front());
    EXPECT_NEAR(rig.rest_axes.front.z, 1.0, 1e-9);
    // Arms lie along x in the rest pose.
    const Vec3 arm = Vec3(rig.rest_global[rig.humanoid.find(left_lower_arm)][3] -
                          rig.rest_global[rig.humanoid.find(left_upper_arm)][3]);
    EXPECT_LT(angle_degrees(arm, Vec3(1, 0, 0)), 0.01);
  }
}

TEST(MotionFile, GltfAnimationsOfAModelComeBackAlike) {
  SINEW_ASSETS_OR_SKIP(folder);
  const auto motion = read_motion(folder / "motions/cmu_12_01_walk.bvh");
  ASSERT_TRUE(motion);
  auto model = read_gltf(folder / "characters/makehuman/mh_male_game.glb");
  ASSERT_TRUE(model);
  const std::vector<Mat4> rest = global_transforms(*model, hierarchy_order(*model), rest_pose(*model));
  auto retargeted = retarget(*motion, *model, find_humanoid(*model, rest));
  ASSERT_TRUE(retargeted);
  model->clips = {retargeted->clip};
  const auto bytes = rig_glb(*model);
  ASSERT_TRUE(bytes) << bytes.error().message;
  const auto back = read_motions("man.glb", *bytes);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_LT(worst_limb(*motion, back->front()), 0.05);
  // And as BVH, whose joints rest parallel to the world.
  const auto bvh = parse_bvh(bytes_of(bvh_text(back->front())), "man.bvh");
  ASSERT_TRUE(bvh) << bvh.error().message;
  EXPECT_LT(worst_limb(*motion, *bvh), 0.05);
}

TEST(MotionFile, AClipIsChosenByName) {
  SINEW_ASSETS_OR_SKIP(folder);
  const fs::path fox = folder / "characters/khronos/Fox.glb";
  const auto run = read_motion(fox, "Run");
  ASSERT_TRUE(run) << run.error().message;
  EXPECT_EQ(run->name, "Run");
  const auto none = read_motion(fox, "Rum");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("did you mean \"Run\"?"), std::string::npos) << none.error().message;
}

TEST(MotionFile, AnAmcWithoutItsSkeletonSaysWhatItNeeds) {
  const auto motion = read_motions("/nowhere/02_01.amc", bytes_of(small_amc));
  ASSERT_FALSE(motion);
  EXPECT_NE(motion.error().message.find("02.asf"), std::string::npos) << motion.error().message;
}

}  // namespace
}  // namespace sinew::test
