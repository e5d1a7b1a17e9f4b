/// Weights changed by tools: smoothed, mirrored, limited, taken over.

#include "engine/fit/weight_edit.h"

#include <gtest/gtest.h>

#include "engine/body/figure.h"
#include "engine/fit/closest_surface.h"
#include "engine/fit/random_poses.h"
#include "engine/fit/transferred_weights.h"
#include "engine/fit/weight_run.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

double weight_of(const Influences& influences, std::size_t v, std::uint32_t joint) {
  for (const Influence& influence : influences_of(influences, v))
    if (influence.joint == joint) return influence.weight;
  return 0.0;
}

void expect_sums_of_one(const Influences& influences) {
  for (std::size_t v = 0; v < influences.vertices(); ++v) {
    double sum = 0.0;
    for (const Influence& influence : influences_of(influences, v)) sum += influence.weight;
    EXPECT_NEAR(sum, 1.0, 1e-12) << v;
  }
}

/// The tube, every vertex whole on one of two joints.
SkinnedShape stepped_tube() {
  SkinnedShape shape = skinned_shapes(tube()).front();
  shape.influences = {};
  for (const Vec3& p : shape.positions)
    shape.influences.add_vertex({{static_cast<std::uint32_t>(p.y < 1.0 ? tube_upper : tube_lower), 1.0}});
  return shape;
}

TEST(WeightEdit, SmoothingMakesARampOfAStep) {
  const SkinnedShape shape = stepped_tube();
  const Influences smooth = smoothed_weights(shape, shape.influences, 4);
  expect_sums_of_one(smooth);
  double above = 0.0, below = 1.0, far = 0.0;
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    const double lower = weight_of(smooth, v, tube_lower), y = shape.positions[v].y;
    if (std::abs(y - 1.0) < 1e-9) below = std::min(below, lower);
    if (std::abs(y - 0.9375) < 1e-9) above = std::max(above, lower);
    if (y < 0.5) far = std::max(far, lower);
  }
  EXPECT_LT(below, 0.95);
  EXPECT_GT(above, 0.05);
  EXPECT_GT(below, above);
  EXPECT_EQ(far, 0.0);  // four rounds reach four rows
}

TEST(WeightEdit, PruningAndLimitsKeepTheLargest) {
  Influences influences;
  influences.add_vertex({{0, 0.5}, {1, 0.3}, {2, 0.15}, {3, 0.05}});
  const Influences pruned = limited_weights(influences, 8, 0.1);
  ASSERT_EQ(pruned.entries.size(), 3u);
  EXPECT_NEAR(pruned.entries[0].weight, 0.5 / 0.95, 1e-15);
  const Influences two = limited_weights(influences, 2, 0.0);
  ASSERT_EQ(two.entries.size(), 2u);
  EXPECT_NEAR(two.entries[1].weight, 0.375, 1e-15);
  EXPECT_EQ(limited_weights(influences, 8, 0.9).entries.size(), 1u);
}

TEST(WeightEdit, TheMirrorPutsTheLeftOnTheRight) {
  BodyOptions options;
  options.joints = 23;
  Model model = build_figure(options).value();
  const SkinnedShape shape = skinned_shapes(model).front();
  const MirrorPlane plane = mirror_plane(model);
  // A fault on the right: everything follows one joint.
  Influences broken;
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    const auto own = influences_of(shape.influences, v);
    broken.add_vertex(glm::dot(shape.positions[v], plane.left) < plane.middle
                          ? std::vector<Influence>{{0, 1.0}}
                          : std::vector<Influence>(own.begin(), own.end()));
  }
  set_influences(shape, broken, model);
  WeightEdits edits;
  edits.mirror = BodySide::left;
  ASSERT_TRUE(edit_weights(edits, model));
  const SkinnedShape mended = skinned_shapes(model).front();
  expect_sums_of_one(mended.influences);
  double most = 0.0;
  for (std::size_t v = 0; v < shape.positions.size(); ++v)
    for (std::uint32_t joint = 0; joint < model.skins[0].joints.size(); ++joint)
      most = std::max(most, std::abs(weight_of(mended.influences, v, joint) - weight_of(shape.influences, v, joint)));
  // The figure is symmetric to rounding; what is left is the mean in the middle.
  EXPECT_LT(most, 0.05);
}

TEST(WeightEdit, AMirrorWithoutPartnersIsRefused) {
  Model model = tube();
  for (Vec3& p : model.meshes[0].primitives[0].positions) p.x += 1.0;
  for (int node : {tube_root, tube_upper}) model.nodes[node].rest.translation.x = 0.5;
  WeightEdits edits;
  edits.mirror = BodySide::right;
  const auto result = edit_weights(edits, model);
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().message.find("no partner"), std::string::npos);
}

TEST(WeightEdit, WeightsAreTakenOverByPlaceAndName) {
  const Model source = tube();
  Model target = tube({.rows = 21, .columns = 15});
  Primitive& skin = target.meshes[0].primitives[0];
  const Influences wanted = skin.influences;
  skin.influences = {};
  for (std::size_t v = 0; v < skin.positions.size(); ++v) skin.influences.add_vertex({{0, 1.0}});
  target.nodes[tube_twist].name = "other";
  const auto missing = transfer_weights(source, target);
  ASSERT_TRUE(missing) << missing.error().message;
  EXPECT_EQ(*missing, (std::vector<std::string>{"twist"}));
  expect_sums_of_one(skin.influences);
  for (std::size_t v = 0; v < skin.positions.size(); ++v) {
    // A row of the source is a sixteenth high, over which a weight bends by no more than this.
    EXPECT_NEAR(weight_of(skin.influences, v, tube_lower), weight_of(wanted, v, tube_lower), 0.03) << v;
    EXPECT_EQ(weight_of(skin.influences, v, tube_twist), 0.0);
  }
  for (Node& node : target.nodes) node.name = "x";
  EXPECT_FALSE(transfer_weights(source, target));
}

TEST(ClosestSurface, IsThatOfLookingAtEveryTriangle) {
  const SkinnedShape shape = skinned_shapes(tube()).front();
  const ClosestSurface surface(shape.positions, shape.triangles);
  RandomNumbers random(9);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p(random.normal(), 1.0 + random.normal(), random.normal());
    double least = INFINITY;
    for (std::size_t t = 0; t < shape.triangles.size(); t += 3) {
      const std::uint32_t one[] = {0, 1, 2};
      const Vec3 corners[] = {shape.positions[shape.triangles[t]], shape.positions[shape.triangles[t + 1]],
                              shape.positions[shape.triangles[t + 2]]};
      least = std::min(least, ClosestSurface(corners, one).find(p).distance);
    }
    const SurfacePoint found = surface.find(p);
    EXPECT_NEAR(found.distance, least, 1e-12);
    Vec3 place(0.0);
    for (int c = 0; c < 3; ++c) place += found.share[c] * shape.positions[found.vertex[c]];
    EXPECT_NEAR(glm::length(place - p), found.distance, 1e-12);
  }
}

}  // namespace
}  // namespace sinew::test
