/// Weights for meshes that have none: against those that riggers painted.

#include "engine/fit/automatic_weights.h"

#include <gtest/gtest.h>

#include "engine/fit/bound_model.h"
#include "engine/fit/random_poses.h"
#include "engine/fit/weight_run.h"
#include "engine/io/gltf_read.h"
#include "engine/rig/humanoid.h"
#include "tests/support/assets.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

Model read_character(const std::filesystem::path& file) {
  auto model = read_gltf(file);
  EXPECT_TRUE(model) << model.error().message;
  return model ? *model : Model{};
}

/// The model on its own skeleton, its weights forgotten and made anew.
Model bound_anew(const Model& model, AutomaticWeightReport& report, const AutomaticWeightOptions& options = {}) {
  auto bound = bound_model(model, model, {.keep_hung = true});
  EXPECT_TRUE(bound) << bound.error().message;
  const auto made = set_automatic_weights(options, *bound);
  EXPECT_TRUE(made) << made.error().message;
  if (made) report = *made;
  return std::move(*bound);
}

std::vector<Vec3> posed(const Model& model, const CharacterMesh& mesh, std::span<const Pose> poses) {
  const std::vector<int> order = hierarchy_order(model);
  BonePoses bones(mesh.palette.size(), poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const std::vector<Mat34> palette = palette_transforms(mesh, global_transforms(model, order, poses[k]));
    for (std::size_t b = 0; b < palette.size(); ++b) bones.at(b, k) = palette[b];
  }
  return skinned_places(mesh.positions, mesh.influences, bones);
}

/// Mean distance in ten random poses between a character by its painted weights and by ours.
double mean_difference(const Model& painted, const Model& ours) {
  RandomNumbers random(7);
  const std::vector<Pose> poses = random_poses(painted, ours.skins[0].joints, 10, random);
  std::vector<Pose> same(poses.size(), rest_pose(ours));
  for (std::size_t k = 0; k < poses.size(); ++k)
    std::copy(poses[k].local.begin(), poses[k].local.end(), same[k].local.begin());
  const std::vector<Vec3> a = posed(painted, character_mesh(painted), poses),
                          b = posed(ours, character_mesh(ours), same);
  EXPECT_EQ(a.size(), b.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += glm::length(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

/// How much of a vertex's weight goes to joints at or below `top`.
double weight_below(const Model& model, const CharacterMesh& mesh, std::size_t v, int top) {
  double sum = 0.0;
  for (const Influence& influence : influences_of(mesh.influences, v))
    for (int node = mesh.palette[influence.joint].node; node >= 0; node = model.nodes[node].parent)
      if (node == top) sum += influence.weight;
  return sum;
}

/// The most that a vertex of one leg (by its painted weights wholly so) follows the other leg by ours.
double follows_other_leg(const Model& painted, const Model& ours) {
  const Humanoid humanoid =
      find_humanoid(painted, global_transforms(painted, hierarchy_order(painted), rest_pose(painted)));
  const int left = humanoid.find(HumanoidBone::left_upper_leg), right = humanoid.find(HumanoidBone::right_upper_leg);
  EXPECT_TRUE(left >= 0 && right >= 0);
  const CharacterMesh theirs = character_mesh(painted), mine = character_mesh(ours);
  double most = 0.0;
  for (std::size_t v = 0; v < theirs.vertices(); ++v) {
    if (weight_below(painted, theirs, v, left) > 0.999) most = std::max(most, weight_below(ours, mine, v, right));
    if (weight_below(painted, theirs, v, right) > 0.999) most = std::max(most, weight_below(ours, mine, v, left));
  }
  return most;
}

void expect_like_painted(const std::string& file, double share_of_height) {
  SINEW_ASSETS_OR_SKIP(assets);
  const Model painted = read_character(assets / "characters" / file);
  AutomaticWeightReport report;
  const Model ours = bound_anew(painted, report);
  const double difference = mean_difference(painted, ours), leg = follows_other_leg(painted, ours);
  testing::Test::RecordProperty("mean_difference_share_of_height", fmt::format("{:.4g}", difference / report.height));
  testing::Test::RecordProperty("follows_other_leg", fmt::format("{:.4g}", leg));
  fmt::print("{}: {:.3f} % of the height, other leg {:.4f}, {:.0f} ms, outside {}, idle {}, far {}\n", file,
             100.0 * difference / report.height, leg, report.milliseconds, fmt::join(report.outside, " "),
             fmt::join(report.idle, " "), report.far);
  EXPECT_LE(difference, share_of_height * report.height);
  EXPECT_LE(leg, 0.0);
}

TEST(AutomaticWeights, PoseAMakeHumanCharacterLikeItsOwn) { expect_like_painted("makehuman/mh_male_game.glb", 0.01); }

TEST(AutomaticWeights, PoseCesiumManLikeItsOwn) { expect_like_painted("khronos/CesiumMan.glb", 0.01); }

TEST(AutomaticWeights, PoseSintelLikeItsOwn) { expect_like_painted("mesh2motion/human-sintel.glb", 0.015); }

TEST(AutomaticWeights, PoseAKnightLikeItsOwn) { expect_like_painted("kaykit/Knight.glb", 0.015); }

}  // namespace
}  // namespace sinew::test
