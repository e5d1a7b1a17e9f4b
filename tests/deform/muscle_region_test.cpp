#include "engine/deform/muscle_region.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/deform/dense_skin.h"
#include "tests/support/gltf_builder.h"
#include "tests/support/test_character.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

/// Roundings of a dozen sums and products of numbers of size one; of angles in degrees.
constexpr double rounding = 1e-13, angle_rounding = 1e-10;

Muscle upper_muscle() {
  Muscle muscle;
  muscle.name = "belly";
  muscle.bone = tube_upper;
  muscle.child = muscle.driver = tube_lower;
  muscle.facing = {0.3, 0.2, 1.0};
  muscle.from = 0.25;
  muscle.to = 0.875;
  muscle.spread = 70;
  return muscle;
}

std::set<std::uint32_t> vertices_of(const MuscleRegion& region) {
  std::set<std::uint32_t> vertices;
  for (const RegionVertex& v : region.vertices) vertices.insert(v.vertex);
  return vertices;
}

TEST(ProjectionPlane, ContainsTheLimbAndFacesTheBelly) {
  const TestCharacter limb(tube({.rest_bend = 40}));
  Muscle muscle = upper_muscle();
  muscle.bone = tube_lower;
  muscle.child = tube_hand;
  const ProjectionPlane plane = projection_plane(muscle, limb.rest.global).value();
  EXPECT_LT(glm::length(plane.bone - Vec3(0, 1, 0)), rounding);
  const double bend = 40 * degrees_to_radians;
  EXPECT_LT(glm::length(plane.child - Vec3(0, 1 + std::cos(bend), std::sin(bend))), rounding);
  EXPECT_NEAR(plane.length, 1.0, rounding);
  EXPECT_LT(glm::length(plane.bone + plane.length * plane.axis - plane.child), rounding);
  // An orthonormal frame: axis, side, normal are right-handed as x, y, z are, so that side = normal x axis.
  const Mat3 frame(plane.axis, plane.side, plane.normal);
  EXPECT_NEAR(glm::determinant(frame), 1.0, rounding);
  EXPECT_LT((eigen(frame) * eigen(frame).transpose() - Eigen::Matrix3d::Identity()).norm(), rounding);
  EXPECT_GT(glm::dot(plane.normal, muscle.facing), 0.0);
  EXPECT_NEAR(glm::dot(plane.side, muscle.facing), 0.0, rounding) << "facing less its part along the axis";
  Muscle longer = muscle;
  longer.facing = 1e6 * muscle.facing + 12.0 * plane.axis;
  EXPECT_LT(glm::length(projection_plane(longer, limb.rest.global)->normal - plane.normal), 1e-9)
      << "neither the facing's length nor its part along the limb matter";
}

TEST(ProjectionPlane, SaysWhyThereIsNone) {
  const TestCharacter limb(tube());
  const auto expect = [&](const Muscle& muscle, const char* part) {
    for (const Result<void>& failed : {projection_plane(muscle, limb.rest.global).map([](auto) {}),
                                       muscle_region(limb.model, limb.mesh, limb.rest, muscle).map([](auto) {})}) {
      ASSERT_FALSE(failed);
      EXPECT_EQ(failed.error().kind, ErrorKind::bad_input);
      EXPECT_NE(failed.error().message.find("\"belly\""), std::string::npos) << failed.error().message;
      EXPECT_NE(failed.error().message.find(part), std::string::npos) << failed.error().message;
    }
  };
  Muscle muscle = upper_muscle();
  muscle.child = tube_root;
  expect(muscle, "same place");
  for (const Vec3& facing : {Vec3(0, 3, 0), Vec3(0, -1, 0), Vec3(1e-8, 1, 0), Vec3(0, 0, 0)}) {
    muscle = upper_muscle();
    muscle.facing = facing;
    expect(muscle, "runs along the limb");
  }
}

/// The definition by brute force: nodes listed by hand, weights from dense rows, angles by arc cosines.
void expect_region(const TestCharacter& limb, const Muscle& muscle, const std::set<int>& segment_nodes) {
  const MuscleRegion region = limb.region(muscle);
  const Eigen::MatrixXd weights = dense_weights(limb.mesh.influences, limb.mesh.palette.size());
  const Eigen::Vector3d bone = eigen(Vec3(limb.rest.global[muscle.bone][3]));
  const Eigen::Vector3d child = eigen(Vec3(limb.rest.global[muscle.child][3]));
  const Eigen::Vector3d axis = (child - bone).normalized();
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
  const Eigen::Vector3d normal = (across * eigen(muscle.facing)).normalized(), side = normal.cross(axis);
  std::vector<RegionVertex> expected;
  std::size_t segment = 0;
  for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
    Eigen::Index strongest = 0;
    weights.row(static_cast<Eigen::Index>(v)).maxCoeff(&strongest);
    if (!segment_nodes.contains(limb.mesh.palette[static_cast<std::size_t>(strongest)].node)) continue;
    ++segment;
    const Eigen::Vector3d p = eigen(limb.rest.positions[v]), n = across * eigen(limb.rest.normals[v]);
    RegionVertex r{.vertex = static_cast<std::uint32_t>(v)};
    r.t = (p - bone).dot(axis) / (child - bone).norm();
    r.angle = std::acos(std::clamp(n.normalized().dot(normal), -1.0, 1.0)) * radians_to_degrees;
    if (r.t < muscle.from || r.t > muscle.to || r.angle > muscle.spread) continue;
    r.x = (p - child).dot(axis);
    r.y = (p - child).dot(side);
    for (std::size_t j = 0; j < limb.mesh.palette.size(); ++j)
      if (segment_nodes.contains(limb.mesh.palette[j].node))
        r.share += weights(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(j));
    expected.push_back(r);
  }
  ASSERT_GT(expected.size(), 10u);
  double mean_x = 0.0, mean_y = 0.0;
  for (const RegionVertex& r : expected) {
    mean_x += r.x / static_cast<double>(expected.size());
    mean_y += r.y / static_cast<double>(expected.size());
  }
  EXPECT_EQ(region.segment_vertices, segment);
  EXPECT_LT((eigen(region.centre) - child - mean_x * axis - mean_y * side).norm(), rounding);
  ASSERT_EQ(region.vertices.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const RegionVertex &got = region.vertices[i], &want = expected[i];
    EXPECT_EQ(got.vertex, want.vertex);
    EXPECT_NEAR(got.x, want.x - mean_x, rounding);
    EXPECT_NEAR(got.y, want.y - mean_y, rounding);
    EXPECT_NEAR(got.t, want.t, rounding);
    EXPECT_NEAR(got.angle, want.angle, 1e-5) << "an arc cosine near 0 degrees";
    EXPECT_NEAR(got.share, want.share, rounding);
  }
}

TEST(MuscleRegion, IsTheDefinitionsWhereTwistJointsBelongToTheSegment) {
  expect_region(TestCharacter(tube()), upper_muscle(), {tube_upper, tube_twist});
  expect_region(TestCharacter(tube({.rest_bend = 46})), upper_muscle(), {tube_upper, tube_twist});
}

TEST(MuscleRegion, IsMeasuredInTheRestPose) {
  Muscle muscle = upper_muscle();
  muscle.bone = tube_lower;
  muscle.child = tube_hand;
  expect_region(TestCharacter(tube({.rest_bend = 46})), muscle, {tube_lower});
}

TEST(MuscleRegion, LeavesOutTheChildsSubtree) {
  Model model = tube();
  const int thumb = add_node(model, "thumb", tube_lower, {.translation = {0, 0.5, 0}});
  // The upper arm's front now follows a joint far below the child: that is no part of the upper arm.
  model.skins[0].joints.push_back(thumb);
  model.skins[0].inverse_bind.push_back(Mat4(1.0));
  Primitive& skin = model.meshes[0].primitives[0];
  Influences changed;
  for (std::size_t v = 0; v < skin.positions.size(); ++v) {
    const std::uint32_t first = skin.influences.first[v], last = skin.influences.first[v + 1];
    std::vector<Influence> run(skin.influences.entries.begin() + first, skin.influences.entries.begin() + last);
    if (skin.positions[v].z > 0.1 && skin.positions[v].y == 0.5) run = {{5, 0.75}, {tube_upper, 0.25}};
    changed.add_vertex(run);
  }
  skin.influences = changed;
  model.skins[0].inverse_bind[5] = glm::inverse(glm::translate(Mat4(1.0), {0, 1.5, 0}));
  const TestCharacter limb(model);
  expect_region(limb, upper_muscle(), {tube_upper, tube_twist});
  for (const std::uint32_t v : vertices_of(limb.region(upper_muscle())))
    EXPECT_FALSE(skin.positions[v].y == 0.5 && skin.positions[v].z > 0.1);
  // Where the child is another joint, everything below the bone but that belongs to the segment.
  Muscle to_thumb = upper_muscle();
  to_thumb.child = thumb;
  expect_region(limb, to_thumb, {tube_upper, tube_twist, tube_lower, tube_hand});
}

TEST(MuscleRegion, EndsAreIncluded) {
  const TestCharacter limb(tube());  // rings stand at multiples of 1/16
  Muscle muscle = upper_muscle();
  const auto ends = [&] {
    const MuscleRegion region = limb.region(muscle);
    double low = INFINITY, high = -INFINITY;
    for (const RegionVertex& v : region.vertices) {
      low = std::min(low, v.t);
      high = std::max(high, v.t);
    }
    return std::pair(low, high);
  };
  EXPECT_EQ(ends(), std::pair(0.25, 0.875));
  muscle.from = 0.251;
  muscle.to = 0.874;
  EXPECT_EQ(ends(), std::pair(0.3125, 0.8125));
}

TEST(MuscleRegion, SpreadCountsDegreesToEitherSide) {
  const TestCharacter limb(tube());  // 15 degrees from column to column, the first one on +Z
  Muscle muscle = upper_muscle();
  muscle.facing = {0, 0, 1};
  muscle.from = muscle.to = 0.5;
  for (const auto& [spread, columns] :
       {std::pair(0.0, 1u), {14.0, 1u}, {16.0, 3u}, {44.0, 5u}, {179.0, 23u}, {180.0, 24u}}) {
    muscle.spread = spread;
    EXPECT_EQ(limb.region(muscle).vertices.size(), columns) << spread;
  }
}

TEST(MuscleRegion, ANormalAlongTheLimbFacesNeitherSide) {
  Model model = tube();
  std::vector<Vec3>& normals = model.meshes[0].primitives[0].normals;
  for (std::size_t v = 0; v < normals.size(); v += 2) normals[v] = {0, v % 4 == 0 ? 1.0 : -1.0, 0};
  const TestCharacter limb(model);
  const auto vertices = vertices_of(limb.region(upper_muscle()));
  ASSERT_FALSE(vertices.empty());
  for (const std::uint32_t v : vertices) EXPECT_EQ(v % 2, 1u);
}

TEST(MuscleRegion, CountsAllMeshesTogether) {
  Model model = tube();
  model.meshes.push_back({"sleeve", {tube_surface({.radius = 0.25})}, {}});
  add_node(model, "sleeve", -1, {});
  model.nodes.back().mesh = 1;
  model.nodes.back().skin = 0;
  const TestCharacter both(model), one(tube());
  const MuscleRegion two_layers = both.region(upper_muscle()), bare = one.region(upper_muscle());
  EXPECT_EQ(two_layers.vertices.size(), 2 * bare.vertices.size());
  EXPECT_EQ(two_layers.segment_vertices, 2 * bare.segment_vertices);
}

TEST(MuscleRegion, MovesWithTheCharacter) {
  const TestCharacter here(tube({.rest_bend = 20}));
  Random random(5);
  Model moved = tube({.rest_bend = 20});
  moved.nodes[tube_root].rest = {random.vector(), random.rotation(), Vec3(1)};
  const TestCharacter there(moved);
  Muscle muscle = upper_muscle();
  const MuscleRegion a = here.region(muscle);
  muscle.facing = moved.nodes[tube_root].rest.rotation * muscle.facing;
  const MuscleRegion b = there.region(muscle);
  ASSERT_EQ(vertices_of(a), vertices_of(b));
  EXPECT_LT(glm::length(Vec3(moved.nodes[tube_root].rest.matrix() * Vec4(a.centre, 1)) - b.centre), rounding);
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    EXPECT_NEAR(a.vertices[i].x, b.vertices[i].x, rounding);
    EXPECT_NEAR(a.vertices[i].y, b.vertices[i].y, rounding);
    EXPECT_NEAR(a.vertices[i].t, b.vertices[i].t, rounding);
    EXPECT_NEAR(a.vertices[i].angle, b.vertices[i].angle, angle_rounding);
  }
}

TEST(MuscleRegion, MayBeEmpty) {
  const TestCharacter limb(tube());
  Muscle muscle = upper_muscle();
  muscle.from = 1.5;
  muscle.to = 1.9;
  const MuscleRegion region = limb.region(muscle);
  EXPECT_TRUE(region.vertices.empty());
  EXPECT_GT(region.segment_vertices, 0u);
  EXPECT_EQ(region.centre, Vec3(0, 1, 0)) << "the mean of nothing is where it is counted from";
}

TEST(MuscleRegion, AVertexsBoneIsTheFirstOfEqualSumsInTheSkinsList) {
  // As files have it: joints in any order, one of them twice. Vertex 0: a tie; 1: two weights on one joint; 2: largest.
  GltfBuilder b;
  auto primitive = b.triangle();
  primitive["attributes"]["JOINTS_0"] = b.integers<unsigned char>("VEC4", {2, 1, 0, 0, 2, 1, 1, 0, 1, 2, 0, 0});
  primitive["attributes"]["WEIGHTS_0"] = b.floats("VEC4", {0.5, 0.5, 0, 0, 0.375, 0.3125, 0.3125, 0, 0.25, 0.75, 0, 0});
  b.draw(primitive, 3);
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  const CharacterMesh mesh = character_mesh(*model);
  const std::vector<int>& joints = model->skins[0].joints;
  EXPECT_EQ(mesh.bone(0), joints[1]);
  EXPECT_EQ(mesh.bone(1), joints[1]);
  EXPECT_EQ(mesh.bone(2), joints[2]);
}

TEST(LimbRadius, IsTheMeanDistanceToTheAxisNearTheCentre) {
  Model model = tube({.radius = 0.2});
  // A trumpet: its radius 0.2 + 0.2 y^2 grows faster and faster, so that a mean over more rings is another.
  for (Vec3& p : model.meshes[0].primitives[0].positions) p *= Vec3(1 + p.y * p.y, 1, 1 + p.y * p.y);
  const TestCharacter limb(model);
  const Muscle muscle = upper_muscle();
  const MuscleRegion region = limb.region(muscle);
  EXPECT_NEAR(region.centre.y, 0.5625, rounding);
  // Within 0.05 of 0.5625 stands one ring, the next ones are 1/16 away.
  EXPECT_NEAR(limb_radius(limb.model, limb.mesh, limb.rest, muscle, region), 0.2 + 0.2 * 0.5625 * 0.5625, rounding);
}

TEST(LimbRadius, TakesTheNearestWhereNoneIsThatNear) {
  const TestCharacter limb(tube({.radius = 0.3, .rows = 5}));
  Muscle muscle = upper_muscle();
  muscle.from = muscle.to = 0.25;  // no ring there: 0, 0.5, 1
  const MuscleRegion region = limb.region(muscle);
  ASSERT_TRUE(region.vertices.empty());
  EXPECT_NEAR(limb_radius(limb.model, limb.mesh, limb.rest, muscle, region), 0.3, rounding);
  muscle.bone = tube_hand;  // without a vertex of its own
  muscle.child = tube_root;
  EXPECT_EQ(limb_radius(limb.model, limb.mesh, limb.rest, muscle, limb.region(muscle)), 0.0);
}

}  // namespace
}  // namespace sinew::test
