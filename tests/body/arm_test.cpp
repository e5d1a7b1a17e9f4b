#include "engine/body/arm.h"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace sinew {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Points = std::vector<Vec3>;

const Primitive& skin_of(const Model& model) { return model.meshes[0].primitives[0]; }

/// Six times the signed volume is the sum of the triple products: positive where triangles face outwards.
double volume(const Points& points, const std::vector<std::uint32_t>& indices) {
  double sum = 0.0;
  for (std::size_t i = 0; i < indices.size(); i += 3)
    sum += glm::dot(points[indices[i]], glm::cross(points[indices[i + 1]], points[indices[i + 2]]));
  return sum / 6.0;
}

/// Length of the cut of the surface by the plane through `x`.
double girth(const Primitive& skin, double x) {
  double length = 0.0;
  for (std::size_t i = 0; i < skin.indices.size(); i += 3) {
    std::vector<Vec3> cuts;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3& a = skin.positions[skin.indices[i + corner]];
      const Vec3& b = skin.positions[skin.indices[i + (corner + 1) % 3]];
      if ((a.x < x) != (b.x < x)) cuts.push_back(glm::mix(a, b, (x - a.x) / (b.x - a.x)));
    }
    if (cuts.size() == 2) length += glm::distance(cuts[0], cuts[1]);
  }
  return length;
}

/// Linear blend skinning with the elbow flexed; lower arm and hand are the skin's joints 2 and 3.
Points flexed(const Primitive& skin, const Vec3& elbow, double degrees) {
  const Quat turn = rotation_xyz_degrees({0, -degrees, 0});
  Points posed;
  for (std::size_t v = 0; v < skin.positions.size(); ++v) {
    const Vec3& rest = skin.positions[v];
    Vec3 sum{0.0};
    for (std::uint32_t k = skin.influences.first[v]; k < skin.influences.first[v + 1]; ++k) {
      const Influence& influence = skin.influences.entries[k];
      sum += influence.weight * (influence.joint >= 2 ? elbow + turn * (rest - elbow) : rest);
    }
    posed.push_back(sum);
  }
  return posed;
}

TEST(Arm, HasTheSizeThatWasPlanned) {
  const Model arm = make_arm();
  const Primitive& skin = skin_of(arm);
  EXPECT_GE(skin.positions.size(), 2300u);
  EXPECT_LE(skin.positions.size(), 2500u);
  EXPECT_EQ(skin.normals.size(), skin.positions.size());
  EXPECT_EQ(skin.influences.vertices(), skin.positions.size());
  EXPECT_EQ(arm.materials.size(), 1u);
  EXPECT_EQ(skin.material, 0);
}

TEST(Arm, IsOneClosedSurfaceWithoutHoles) {
  const Model arm = make_arm();
  const Primitive& skin = skin_of(arm);
  std::map<Edge, int> directed;
  for (std::size_t i = 0; i < skin.indices.size(); i += 3)
    for (std::size_t corner = 0; corner < 3; ++corner)
      ++directed[{skin.indices[i + corner], skin.indices[i + (corner + 1) % 3]}];
  for (const auto& [edge, count] : directed) {
    ASSERT_EQ(count, 1) << edge.first << " to " << edge.second;
    ASSERT_TRUE(directed.contains({edge.second, edge.first})) << edge.first << " to " << edge.second;
  }
  const auto vertices = static_cast<long>(skin.positions.size());
  const auto edges = static_cast<long>(directed.size() / 2), faces = static_cast<long>(skin.indices.size() / 3);
  EXPECT_EQ(vertices - edges + faces, 2);
}

TEST(Arm, FacesOutwardsAndHasAnArmsVolume) {
  const Model arm = make_arm();
  const Primitive& skin = skin_of(arm);
  const double cubic_metres = volume(skin.positions, skin.indices);
  EXPECT_GT(cubic_metres, 0.0035);
  EXPECT_LT(cubic_metres, 0.0060);
  for (std::size_t i = 0; i < skin.indices.size(); i += 3) {
    const Vec3& a = skin.positions[skin.indices[i]];
    const Vec3 normal = glm::cross(skin.positions[skin.indices[i + 1]] - a, skin.positions[skin.indices[i + 2]] - a);
    for (std::size_t corner = 0; corner < 3; ++corner)
      EXPECT_GT(glm::dot(normal, skin.normals[skin.indices[i + corner]]), 0.0) << "triangle " << i / 3;
  }
  for (const Vec3& normal : skin.normals) EXPECT_NEAR(glm::length(normal), 1.0, 1e-12);
}

TEST(Arm, HasNoThinTriangles) {
  const Model arm = make_arm();
  const Primitive& skin = skin_of(arm);
  for (std::size_t i = 0; i < skin.indices.size(); i += 3) {
    const std::array<Vec3, 3> p{skin.positions[skin.indices[i]], skin.positions[skin.indices[i + 1]],
                                skin.positions[skin.indices[i + 2]]};
    double smallest = 180.0;
    for (std::size_t corner = 0; corner < 3; ++corner)
      smallest = std::min(smallest, angle_degrees(p[(corner + 1) % 3] - p[corner], p[(corner + 2) % 3] - p[corner]));
    EXPECT_GT(smallest, 10.0) << "triangle " << i / 3 << " at x = " << p[0].x;
    EXPECT_GT(0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0])), 1e-6) << "triangle " << i / 3;
  }
}

TEST(Arm, WeightsAreFourAtMostAndSumToOne) {
  const Model arm = make_arm();
  const Influences& influences = skin_of(arm).influences;
  for (std::size_t v = 0; v < influences.vertices(); ++v) {
    const std::uint32_t begin = influences.first[v], end = influences.first[v + 1];
    ASSERT_GE(end - begin, 1u);
    ASSERT_LE(end - begin, 4u);
    double sum = 0.0;
    for (std::uint32_t k = begin; k < end; ++k) {
      EXPECT_GT(influences.entries[k].weight, 0.0);
      EXPECT_LT(influences.entries[k].joint, arm.skins[0].joints.size());
      if (k > begin) {
        EXPECT_LE(influences.entries[k].weight, influences.entries[k - 1].weight);
      }
      sum += influences.entries[k].weight;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST(Arm, WeightsFollowThePlaceAlongTheLimb) {
  const Model arm = make_arm();
  const Primitive& skin = skin_of(arm);
  const auto bone_at = [&](std::size_t v) {
    return arm
        .nodes[static_cast<std::size_t>(arm.skins[0].joints[skin.influences.entries[skin.influences.first[v]].joint])]
        .name;
  };
  for (std::size_t v = 0; v < skin.positions.size(); ++v) {
    const double x = skin.positions[v].x;
    if (x < -0.05) {
      EXPECT_EQ(bone_at(v), "leftShoulder");
    }
    if (x > 0.00 && x < 0.26) {
      EXPECT_EQ(bone_at(v), "leftUpperArm");
    }
    if (x > 0.31 && x < 0.55) {
      EXPECT_EQ(bone_at(v), "leftLowerArm");
    }
    // Over the joint the flexor side is still the upper arm's, the olecranon behind it already the lower arm's.
    if (x > 0.282 && x < 0.295) {
      if (skin.positions[v].z > 0.0) {
        EXPECT_EQ(bone_at(v), "leftUpperArm");
      }
      if (skin.positions[v].z < -0.031) {
        EXPECT_EQ(bone_at(v), "leftLowerArm");
      }
    }
    if (x > 0.57) {
      EXPECT_EQ(bone_at(v), "leftHand");
    }
  }
}

TEST(Arm, HasTheGirthsOfAnAthleticAdult) {
  const Model arm = make_arm();
  const Primitive& skin = skin_of(arm);
  const double upper = girth(skin, 0.15), elbow = girth(skin, 0.28), fullest_below = girth(skin, 0.345),
               middle = girth(skin, 0.43), wrist = girth(skin, 0.55);
  EXPECT_GT(upper, 0.28);
  EXPECT_LT(upper, 0.36);
  EXPECT_LT(elbow, upper);
  EXPECT_GT(fullest_below, elbow);
  EXPECT_GT(middle, 0.21);
  EXPECT_LT(middle, 0.27);
  EXPECT_GT(wrist, 0.15);
  EXPECT_LT(wrist, 0.19);
}

/// How far the surface reaches at most in `direction` within half a centimetre of `x`.
double reach(const Primitive& skin, double x, const Vec3& direction) {
  double most = -1.0;
  for (const Vec3& p : skin.positions)
    if (std::abs(p.x - x) < 0.005) most = std::max(most, glm::dot(p, direction));
  return most;
}

TEST(Arm, ShowsWhatLiesUnderTheSkin) {
  const Model arm = make_arm();
  const Primitive& skin = skin_of(arm);
  const Vec3 outer{0, 1, 0}, front{0, 0, 1}, inner{0, -1, 0}, rear{0, 0, -1};
  EXPECT_GT(reach(skin, 0.01, outer), reach(skin, 0.15, outer) + 0.020) << "deltoid, and where it ends";
  EXPECT_GT(reach(skin, 0.15, front), reach(skin, 0.27, front) + 0.004) << "biceps over the crook of the elbow";
  EXPECT_GT(reach(skin, 0.12, rear), reach(skin, 0.24, rear) + 0.012) << "triceps over its tendon";
  EXPECT_GT(reach(skin, 0.285, rear), reach(skin, 0.245, rear) + 0.002) << "olecranon";
  EXPECT_GT(reach(skin, 0.285, inner), reach(skin, 0.25, inner) + 0.002) << "inner epicondyle";
  EXPECT_GT(reach(skin, 0.335, outer), reach(skin, 0.27, outer) + 0.006) << "brachioradialis";
  EXPECT_GT(reach(skin, 0.52, outer) + reach(skin, 0.52, inner),
            1.4 * (reach(skin, 0.52, front) + reach(skin, 0.52, rear)))
      << "flat wrist";
}

TEST(Arm, IsCutOffAtTheShoulderByAPlane) {
  const Model arm = make_arm();
  const Primitive& skin = skin_of(arm);
  const Vec3 outwards = glm::normalize(Vec3{-1.0, -0.30, 0.0});
  double nearest = 1.0, farthest = -1.0;
  int on_cut = 0;
  for (std::size_t v = 0; v < skin.positions.size(); ++v) {
    if (skin.positions[v].x > 0.0 || glm::dot(skin.normals[v], outwards) < 0.95) continue;
    const double height = glm::dot(skin.positions[v], outwards);
    nearest = std::min(nearest, height);
    farthest = std::max(farthest, height);
    ++on_cut;
  }
  EXPECT_GT(on_cut, 30);
  EXPECT_LT(farthest - nearest, 0.003);
}

TEST(Arm, HandReachesItsLengthWithTheThumbUp) {
  const Model arm = make_arm();
  Bounds all, hand;
  for (const Vec3& p : skin_of(arm).positions) {
    all.add(p);
    if (p.x > 0.60) hand.add(p);
  }
  EXPECT_NEAR(all.high.x, 0.75, 0.002);
  EXPECT_GT(hand.high.y, 0.08);
  EXPECT_LT(hand.low.y, -0.03);
}

TEST(Arm, JointsLieAlongTheAxisAndTheBindPoseIsTheRestPose) {
  const Model arm = make_arm();
  const std::map<std::string, double> expected = {
      {"leftUpperArm", 0.0}, {"leftLowerArm", 0.30}, {"leftHand", 0.56}, {"leftHandTip", 0.75}};
  Mat4 global{1.0};
  for (std::size_t joint = 0; joint < arm.skins[0].joints.size(); ++joint) {
    const Node& node = arm.nodes[static_cast<std::size_t>(arm.skins[0].joints[joint])];
    EXPECT_EQ(node.parent, static_cast<int>(joint) - 1);
    global = global * node.rest_local();
    if (expected.contains(node.name)) {
      EXPECT_NEAR(global[3].x, expected.at(node.name), 1e-12) << node.name;
    }
    const Mat4 product = global * arm.skins[0].inverse_bind[joint];
    for (int column = 0; column < 4; ++column)
      EXPECT_LT(glm::distance(product[column], Mat4{1.0}[column]), 1e-12) << node.name;
  }
  EXPECT_EQ(arm.nodes[0].name, "leftShoulder");
  EXPECT_EQ(arm.nodes.back().mesh, 0);
  EXPECT_EQ(arm.nodes.back().skin, 0);
}

TEST(Arm, KeepsItsVolumeWhenTheElbowIsFlexed) {
  const Model arm = make_arm();
  const Primitive& skin = skin_of(arm);
  const double at_rest = volume(skin.positions, skin.indices);
  for (double degrees : {45.0, 90.0, 130.0})
    EXPECT_GT(volume(flexed(skin, {0.30, 0, 0}, degrees), skin.indices), 0.85 * at_rest) << degrees;
}

TEST(Arm, FollowsItsMeasures) {
  const Model arm =
      make_arm({.upper_arm_length = 0.33, .lower_arm_length = 0.24, .hand_length = 0.18, .thickness = 0.9});
  Bounds bounds;
  for (const Vec3& p : skin_of(arm).positions) bounds.add(p);
  EXPECT_NEAR(bounds.high.x, 0.75, 0.002);
  EXPECT_NEAR(arm.nodes[2].rest.translation.x, 0.33, 1e-12);
  EXPECT_NEAR(girth(skin_of(arm), 0.165), 0.9 * girth(skin_of(make_arm()), 0.15), 0.002);
  EXPECT_GT(volume(skin_of(arm).positions, skin_of(arm).indices), 0.0);
}

}  // namespace
}  // namespace sinew
