/// Bones and weights found in examples alone.

#include "engine/fit/rigid_bones.h"

#include <tbb/global_control.h>

#include <chrono>

#include <gtest/gtest.h>

#include "engine/fit/random_poses.h"
#include "engine/fit/rigid_motion.h"
#include "engine/fit/skin_fit.h"
#include "engine/io/gltf_read.h"
#include "engine/rig/clip_sampling.h"
#include "tests/support/assets.h"
#include "tests/support/posed_character.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

double rmse(std::span<const Vec3> a, std::span<const Vec3> b) {
  double squared = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) squared += glm::dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(squared / static_cast<double>(a.size()));
}

/// A mesh that moves, its skeleton forgotten.
struct Moving {
  std::vector<Vec3> rest, places;
  std::vector<std::uint32_t> triangles;
  std::size_t poses = 0;

  RigidBonesJob job(std::size_t count) const {
    RigidBonesJob job{rest, places, triangles, poses};
    job.count = count;
    return job;
  }
  double rmse(const RigidBones& found) const {
    return test::rmse(skinned_places(rest, found.influences, found.bones), places);
  }
};

Moving moving(const Model& model, std::span<const Pose> poses) {
  const CharacterMesh mesh = character_mesh(model);
  const Pose still = rest_pose(model);
  return {posed_places(model, mesh, {&still, 1}), posed_places(model, mesh, poses), mesh.triangles, poses.size()};
}

Moving moving_tube(std::size_t poses) {
  const Model model = tube();
  RandomNumbers random(3);
  return moving(model, random_poses(model, model.skins[0].joints, poses, random));
}

TEST(RigidMotion, ATurnAndAMoveAreFoundAgain) {
  const Quat turn = rotation_xyz_degrees({30, -50, 110});
  const Vec3 by(1, -2, 3);
  RigidMotion motion;
  RandomNumbers random(4);
  for (int i = 0; i < 10; ++i) {
    const Vec3 p(random.normal(), random.normal(), random.normal());
    const double weight = 0.1 + random.uniform();
    motion.add(p, weight * (turn * p + by), weight);
  }
  const Mat34 found = motion.solve({});
  const Vec3 probe(0.3, 0.7, -1.1);
  EXPECT_LT(glm::length(found.transform_point(probe) - (turn * probe + by)), 1e-12);
}

TEST(RigidMotion, AMirrorImageGivesARotationAllTheSame) {
  RigidMotion motion;
  for (const Vec3 p : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(2, 1, 0)})
    motion.add(p, {-p.x, p.y, p.z}, 1.0);
  EXPECT_NEAR(glm::determinant(motion.solve({}).linear()), 1.0, 1e-12);
  EXPECT_EQ(RigidMotion{}.solve({}).row[0], Vec4(1, 0, 0, 0));
}

TEST(RigidBones, AJointedTubeIsTakenApart) {
  const Moving mesh = moving_tube(12);
  const auto found = mesh.job(3).run();
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->bones.bones, 3u);
  // Three bones move it; the tube is 2 long.
  EXPECT_LT(mesh.rmse(*found), 0.002 * 2.0);
  for (const Mat34& f : found->bones.transforms) EXPECT_NEAR(glm::determinant(f.linear()), 1.0, 1e-9);
  const auto fewer = mesh.job(2).run();
  ASSERT_TRUE(fewer);
  EXPECT_GT(mesh.rmse(*fewer), mesh.rmse(*found));
}

TEST(RigidBones, TheNumberOfThreadsChangesNothing) {
  const Moving mesh = moving_tube(6);
  const auto many = mesh.job(4).run();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto single = mesh.job(4).run();
  ASSERT_TRUE(many && single);
  ASSERT_EQ(many->influences.entries.size(), single->influences.entries.size());
  for (std::size_t i = 0; i < many->influences.entries.size(); ++i)
    EXPECT_EQ(many->influences.entries[i].weight, single->influences.entries[i].weight);
  for (std::size_t i = 0; i < many->bones.transforms.size(); ++i)
    EXPECT_EQ(many->bones.transforms[i].row[0], single->bones.transforms[i].row[0]);
}

TEST(RigidBones, MoreThanCanBeToldApartIsRefused) {
  Moving mesh = moving_tube(4);
  for (std::size_t v = 0; v < mesh.rest.size(); ++v)
    for (std::size_t k = 0; k < 4; ++k) mesh.places[v * 4 + k] = mesh.rest[v] + Vec3(static_cast<double>(k), 0, 0);
  const auto two = mesh.job(2).run();
  ASSERT_FALSE(two);
  EXPECT_EQ(two.error().kind, ErrorKind::bad_input);
  EXPECT_NE(two.error().message.find("2 bones are more than can be told apart"), std::string::npos);
  EXPECT_TRUE(mesh.job(1).run());
  EXPECT_FALSE(mesh.job(mesh.rest.size() + 1).run());
  mesh.places[7].z = NAN;
  EXPECT_NE(mesh.job(1).run().error().message.find("pose 3, vertex 1"), std::string::npos);
}

/// Twenty bones for a baked clip, beside the fit by the bones that made it.
void expect_explained(const std::string& file) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "SKIPPED: minutes under the sanitizers, where smaller cases run";
#endif
  SINEW_ASSETS_OR_SKIP(assets);
  const auto model = read_gltf(assets / "characters" / file);
  ASSERT_TRUE(model) << model.error().message;
  const auto longest = std::max_element(model->clips.begin(), model->clips.end(), [](const Clip& a, const Clip& b) {
    return a.channels.size() * 100.0 + std::min(a.duration, 3.0) <
           b.channels.size() * 100.0 + std::min(b.duration, 3.0);
  });
  ASSERT_NE(longest, model->clips.end());
  std::vector<Pose> poses(24, rest_pose(*model));
  for (std::size_t k = 0; k < poses.size(); ++k)
    sample_clip(*longest, longest->duration * static_cast<double>(k) / 23.0, poses[k]);
  const Moving mesh = moving(*model, poses);
  Bounds bounds;
  for (const Vec3& p : mesh.rest) bounds.add(p);
  const auto begin = std::chrono::steady_clock::now();
  const auto found = mesh.job(20).run();
  ASSERT_TRUE(found) << found.error().message;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double height = bounds.high.y - bounds.low.y, share = mesh.rmse(*found) / height;
  testing::Test::RecordProperty("share_of_height", fmt::format("{:.4g}", share));
  fmt::print("{} \"{}\": {} vertices, RMSE {:.3f} % of the height, {} rounds, {:.2f} s\n", file, longest->name,
             mesh.rest.size(), 100.0 * share, found->rounds, seconds);
  EXPECT_LE(share, 0.01);
}

TEST(RigidBones, TwentyExplainAKnight) { expect_explained("kaykit/Knight.glb"); }

}  // namespace
}  // namespace sinew::test
