#include "engine/deform/ssd.h"

#include <gtest/gtest.h>

#include "tests/deform/dense_skin.h"
#include "tests/support/test_character.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

/// Roundings of a dozen sums and products of numbers of size one.
constexpr double rounding = 1e-13;

/// Loose vertices on random joints, up to eight each.
struct Cloud {
  std::vector<Vec3> positions, normals;
  Influences influences;
  std::vector<Mat34> palette;
  std::vector<Vec3> posed, posed_normals;
  std::vector<Mat3> blend;

  explicit Cloud(std::size_t vertices, std::size_t joints, unsigned seed = 1) {
    Random random(seed);
    for (std::size_t v = 0; v < vertices; ++v) {
      positions.push_back(random.vector());
      normals.push_back(glm::normalize(random.vector()));
      std::vector<Influence> run;
      double sum = 0.0;
      const std::size_t first = random.index(joints);
      for (std::size_t i = 0; i < 1 + v % std::min(joints, max_influences); ++i) {
        run.push_back({static_cast<std::uint32_t>((first + i) % joints), random.between(0.1, 1.0)});
        sum += run.back().weight;
      }
      for (Influence& i : run) i.weight /= sum;
      influences.add_vertex(sorted_run(run));
    }
    palette.resize(joints);
    posed.resize(vertices);
    posed_normals.resize(vertices);
    blend.resize(vertices);
  }

  SsdJob job() { return {{positions, normals, palette, influences}, {posed, posed_normals, blend}}; }
  void run() {
    ASSERT_TRUE(job().validate());
    job().run();
  }
  Eigen::Matrix4d dense(std::size_t v) const {
    return dense_blend(dense_weights(influences, palette.size()), palette, v);
  }
};

TEST(Ssd, IsTheWeightedSumOfTheMatricesTimesTheVertex) {
  Cloud cloud(300, 12);
  Random random(2);
  for (Mat34& m : cloud.palette) m = Mat34::from(random.rigid_motion());
  cloud.run();
  for (std::size_t v = 0; v < cloud.positions.size(); ++v) {
    const Eigen::Matrix4d blend = cloud.dense(v);
    EXPECT_LT(glm::length(cloud.posed[v] - dense_point(blend, cloud.positions[v])), rounding);
    EXPECT_LT((eigen(cloud.blend[v]) - blend.topLeftCorner<3, 3>()).norm(), rounding);
  }
}

TEST(Ssd, NormalsGoByTheInverseTransposeUnderUniformAndNonUniformScale) {
  Random random(3);
  for (const Vec3& scale : {Vec3(1), Vec3(2.5), Vec3(0.01), Vec3(1, 3, 0.5), Vec3(-1, 1, 1), Vec3(-2, -0.5, 3)}) {
    Cloud cloud(200, 1);
    const Transform t{random.vector(), random.rotation(), scale};
    cloud.palette = {Mat34::from(t.matrix())};
    cloud.run();
    for (std::size_t v = 0; v < cloud.normals.size(); ++v)
      EXPECT_LT(glm::length(cloud.posed_normals[v] - dense_normal(cloud.dense(v), cloud.normals[v])), rounding);
  }
}

TEST(Ssd, NormalsOfBlendsGoByTheInverseTransposeOfTheBlend) {
  Cloud cloud(300, 6);
  Random random(4);
  for (Mat34& m : cloud.palette) {
    // Near enough to each other that no blend of them is singular.
    const Transform t{random.vector(), rotation_xyz_degrees(random.vector(40)), Vec3(1) + random.vector(0.3)};
    m = Mat34::from(t.matrix());
  }
  cloud.run();
  for (std::size_t v = 0; v < cloud.normals.size(); ++v)
    EXPECT_LT(glm::length(cloud.posed_normals[v] - dense_normal(cloud.dense(v), cloud.normals[v])), rounding);
}

TEST(Ssd, CarriedNormalsStandOnTheCarriedSurface) {
  // Independent of any formula for normals: tangents are carried by the blend itself and stay at right angles.
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Vec3 n = glm::normalize(random.vector()), t1 = glm::cross(n, random.vector()), t2 = glm::cross(n, t1);
    const Mat3 blend(random.vector(), random.vector(), random.vector());
    const Vec3 carried = carry_normal(blend, n);
    EXPECT_NEAR(glm::length(carried), 1.0, rounding);
    EXPECT_NEAR(glm::dot(carried, blend * t1), 0.0, rounding);
    EXPECT_NEAR(glm::dot(carried, blend * t2), 0.0, rounding);
    EXPECT_GT(glm::dot(carried, blend * n), 0.0);
  }
}

TEST(Ssd, TheBindPoseIsTheIdentity) {
  const TestCharacter straight(tube());
  const DeformedVertices out = deformed(straight, rest_pose(straight.model), {.bulge = BulgeMode::off});
  EXPECT_LT(largest_distance(out.positions, straight.mesh.positions), rounding);
  EXPECT_LT(largest_distance(out.normals, straight.mesh.normals), rounding);
}

TEST(Ssd, ABentRestPoseIsNotTheBindPose) {
  const TestCharacter bent(tube({.rest_bend = 46}));
  EXPECT_GT(largest_distance(bent.rest.positions, bent.mesh.positions), 0.5);
  const DeformedVertices back = deformed(bent, bent.turned(tube_lower, {-46, 0, 0}), {.bulge = BulgeMode::off});
  EXPECT_LT(largest_distance(back.positions, bent.mesh.positions), rounding);
}

TEST(Ssd, ARigidMotionOfThePaletteMovesTheSkinRigidly) {
  const TestCharacter bent(tube({.rest_bend = 30}));
  const Pose pose = bent.turned(tube_lower, {50, 20, -10});
  Random random(6);
  for (int i = 0; i < 5; ++i) {
    const Mat4 motion = random.rigid_motion();
    const DeformedVertices there = deformed(bent, pose, {.placement = motion}), here = deformed(bent, pose);
    for (std::size_t v = 0; v < here.positions.size(); ++v) {
      EXPECT_LT(glm::length(there.positions[v] - Vec3(motion * Vec4(here.positions[v], 1))), rounding);
      EXPECT_LT(glm::length(there.normals[v] - Mat3(motion) * here.normals[v]), rounding);
    }
  }
}

TEST(Ssd, SingularBlendsGiveNumbers) {
  const auto turn = [](const Vec3& degrees) { return Mat34::from(glm::mat4_cast(rotation_xyz_degrees(degrees))); };
  const Mat34 nothing{{Vec4(0), Vec4(0), Vec4(0)}};
  const Mat34 flat{{Vec4(1, 0, 0, 0), Vec4(0, 1, 0, 0), Vec4(0)}};
  // A candy wrapper's middle, a fold back on itself, and matrices that are singular by themselves.
  const std::pair<Mat34, Mat34> pairs[] = {{Mat34(), turn({0, 180, 0})}, {Mat34(), turn({180, 0, 0})},
                                           {nothing, nothing},           {flat, flat},
                                           {Mat34(), nothing},           {turn({0, 0, 90}), turn({0, 0, -90})}};
  for (const auto& [a, b] : pairs) {
    Cloud cloud(50, 2);
    cloud.palette = {a, b};
    cloud.influences = {};
    for (std::size_t v = 0; v < cloud.positions.size(); ++v) cloud.influences.add_vertex({{0, 0.5}, {1, 0.5}});
    cloud.run();
    for (std::size_t v = 0; v < cloud.positions.size(); ++v) {
      EXPECT_TRUE(std::isfinite(glm::length(cloud.posed[v])));
      EXPECT_NEAR(glm::length(cloud.posed_normals[v]), 1.0, rounding);
    }
  }
}

TEST(Ssd, AFlattenedSurfacesNormalIsItsPlanes) {
  EXPECT_EQ(carry_normal(Mat3(Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0)), {0.6, 0, 0.8}), Vec3(0, 0, 1));
  EXPECT_EQ(carry_normal(Mat3(0.0), {0, 2, 0}), Vec3(0, 1, 0)) << "no direction at all: the bind pose's";
  EXPECT_EQ(carry_normal(Mat3(1.0), {0, 0, 0}), Vec3(0, 0, 1)) << "not even a normal";
}

TEST(Ssd, MirroredInputGivesMirroredOutput) {
  const TestCharacter one(tube({.rest_bend = 20})), other(mirrored(tube({.rest_bend = 20})));
  const DeformedVertices a = deformed(one, one.turned(tube_lower, {40, 15, 25}), {.bulge = BulgeMode::off});
  const DeformedVertices b = deformed(other, other.turned(tube_lower, {40, -15, -25}), {.bulge = BulgeMode::off});
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    EXPECT_LT(glm::length(mirrored(a.positions[v]) - b.positions[v]), rounding);
    EXPECT_LT(glm::length(mirrored(a.normals[v]) - b.normals[v]), rounding);
  }
}

TEST(Ssd, NobodyHasToAskForTheBlend) {
  Cloud cloud(20, 3);
  cloud.run();
  const std::vector<Vec3> asked = cloud.posed;
  cloud.blend.clear();
  cloud.run();
  EXPECT_EQ(cloud.posed, asked);
}

TEST(Ssd, EveryInvalidSpanIsNamed) {
  const auto expect = [](const char* what, auto spoil) {
    Cloud cloud(10, 4);
    ASSERT_TRUE(cloud.job().validate());
    spoil(cloud);
    const Result<void> result = cloud.job().validate();
    ASSERT_FALSE(result) << what;
    EXPECT_EQ(result.error().kind, ErrorKind::bad_input);
    EXPECT_NE(result.error().message.find(what), std::string::npos) << result.error().message;
  };
  expect("normals has 10 entries, expected 9", [](Cloud& c) { c.positions.pop_back(); });
  expect("normals has 9 entries, expected 10", [](Cloud& c) { c.normals.pop_back(); });
  expect("influences has 9 entries", [](Cloud& c) { c.influences.first.pop_back(); });
  expect("influences has 11 entries", [](Cloud& c) { c.influences.add_vertex({{0, 1.0}}); });
  expect("posed positions has 9 entries", [](Cloud& c) { c.posed.pop_back(); });
  expect("posed positions has 11 entries", [](Cloud& c) { c.posed.push_back({}); });
  expect("posed normals has 9 entries", [](Cloud& c) { c.posed_normals.pop_back(); });
  expect("blend has 9 entries", [](Cloud& c) { c.blend.pop_back(); });
  expect("vertex 9 names joint 4, the palette has 4", [](Cloud& c) { c.influences.entries.back().joint = 4; });
  expect("the palette has 0", [](Cloud& c) { c.palette.clear(); });
  expect("vertex 9 follows no joint", [](Cloud& c) { c.influences.first.back() = c.influences.first[9]; });
}

}  // namespace
}  // namespace sinew::test
