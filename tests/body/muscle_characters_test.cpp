/// The default muscles on real characters: the figures of engine/definitions.md 7.

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "engine/deform/reference.h"
#include "engine/io/gltf_read.h"
#include "tests/body/fleshed_skeleton.h"
#include "tests/support/assets.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

Fleshed read(const std::filesystem::path& file) {
  auto model = read_gltf(file);
  EXPECT_TRUE(model) << model.error().message;
  return Fleshed(model ? *model : Model());
}

/// Both of the preset's muscles.
std::vector<PlacedMuscle> muscles_of(const Fleshed& body, MusclePreset preset) {
  std::vector<std::string> problems;
  std::vector<PlacedMuscle> found;
  for (const PlacedMuscle& placed : default_muscles(body.context(), problems))
    if (placed.muscle.name.starts_with(preset == MusclePreset::biceps ? "biceps" : "calf")) found.push_back(placed);
  EXPECT_EQ(found.size(), 2u);
  EXPECT_TRUE(problems.empty());
  return found;
}

double share_of(const PlacedMuscle& placed) {
  return static_cast<double>(placed.region.vertices.size()) / static_cast<double>(placed.region.segment_vertices);
}

/// Where the centre lies between the bone's joint and the child's.
double centre_of(const PlacedMuscle& placed) {
  const ProjectionPlane& plane = placed.region.plane;
  return glm::dot(placed.region.centre - plane.bone, plane.axis) / plane.length;
}

/// r of engine/definitions.md 7, once more: the segment's nodes are listed by hand.
double radius_of(const Fleshed& body, const PlacedMuscle& placed, std::initializer_list<const char*> segment) {
  const ProjectionPlane& plane = placed.region.plane;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t v = 0; v < body.mesh.vertices(); ++v) {
    const std::string& bone = body.model.nodes[body.mesh.bone(v)].name;
    const Vec3 from_bone = body.rest.positions[v] - plane.bone;
    const double t = glm::dot(from_bone, plane.axis) / plane.length;
    if (std::find(segment.begin(), segment.end(), bone) == segment.end() || std::abs(t - centre_of(placed)) > 0.05)
      continue;
    sum += glm::length(glm::cross(from_bone, plane.axis));
    ++count;
  }
  EXPECT_GT(count, 10u);
  return sum / static_cast<double>(count);
}

TEST(MuscleCharacters, TheBicepsOfTheMaleIsThePapersShare) {
  SINEW_ASSETS_OR_SKIP(assets);
  const Fleshed male = read(assets / "characters/makehuman/mh_male_game.glb");
  const std::vector<PlacedMuscle> biceps = muscles_of(male, MusclePreset::biceps);
  for (const PlacedMuscle& placed : biceps) {
    EXPECT_EQ(placed.region.vertices.size(), 65u);
    EXPECT_EQ(placed.region.segment_vertices, 305u);
    EXPECT_GT(share_of(placed), 0.15);
    EXPECT_LT(share_of(placed), 0.25);
    EXPECT_NEAR(centre_of(placed), 0.64, 0.005);  // two digits are given
    EXPECT_NEAR(placed.muscle.rest_angle, 180 - 46, 0.5);
    EXPECT_GT(placed.region.plane.normal.z, 0.95) << "to the front";
    EXPECT_EQ(placed.muscle.reference_angle, 35.0);
  }
  EXPECT_NEAR(biceps[0].muscle.peak, 0.30 * radius_of(male, biceps[0], {"upperarm_l"}), 1e-12);
  EXPECT_NEAR(biceps[1].muscle.peak, 0.30 * radius_of(male, biceps[1], {"upperarm_r"}), 1e-12);
}

TEST(MuscleCharacters, TheCalfOfTheMaleIsThePapersShare) {
  SINEW_ASSETS_OR_SKIP(assets);
  const Fleshed male = read(assets / "characters/makehuman/mh_male_game.glb");
  const std::vector<PlacedMuscle> calves = muscles_of(male, MusclePreset::calf);
  for (const PlacedMuscle& placed : calves) {
    EXPECT_GT(share_of(placed), 0.10);
    EXPECT_LT(share_of(placed), 0.20);
    EXPECT_NEAR(share_of(placed), 0.14, 0.005);
    EXPECT_NEAR(centre_of(placed), 0.26, 0.005);
    EXPECT_NEAR(placed.muscle.rest_angle, 115, 0.5);
    EXPECT_LT(placed.region.plane.normal.z, -0.95) << "to the back";
    EXPECT_EQ(placed.muscle.reference_angle, 150.0);
  }
  EXPECT_NEAR(calves[0].muscle.peak, 0.12 * radius_of(male, calves[0], {"calf_l"}), 1e-12);
  EXPECT_NEAR(calves[1].muscle.peak, 0.12 * radius_of(male, calves[1], {"calf_r"}), 1e-12);
}

TEST(MuscleCharacters, ARigWithTwistJointsHasTheSameMuscles) {
  // The same body on another rig, whose upper arm and lower leg are split in two.
  SINEW_ASSETS_OR_SKIP(assets);
  const Fleshed game = read(assets / "characters/makehuman/mh_male_game.glb"),
                split = read(assets / "characters/makehuman/mh_male_default.glb");
  for (const MusclePreset preset : {MusclePreset::biceps, MusclePreset::calf}) {
    const PlacedMuscle a = muscles_of(game, preset)[0], b = muscles_of(split, preset)[0];
    // Weights at the joints differ, so that the segments' ends do.
    EXPECT_NEAR(share_of(a), share_of(b), 0.02);
    EXPECT_NEAR(a.muscle.peak, b.muscle.peak, 0.01 * a.muscle.peak);
    EXPECT_LT(glm::distance(a.region.centre, b.region.centre), 0.001);
  }
}

/// Length of the convex hull of the points seen along the axis: what a tape round them measures.
double tape_girth(const ProjectionPlane& plane, const std::vector<Vec3>& points) {
  std::vector<Vec2> flat;
  for (const Vec3& p : points)
    flat.push_back({glm::dot(p - plane.bone, plane.side), glm::dot(p - plane.bone, plane.normal)});
  std::sort(flat.begin(), flat.end(), [](const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Vec2> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t begin = hull.size();
    for (const Vec2& p : flat) {
      while (hull.size() >= begin + 2) {
        const Vec2 a = hull[hull.size() - 2], b = hull.back();
        if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0) break;
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(flat.begin(), flat.end());
  }
  double length = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i) length += glm::distance(hull[i], hull[(i + 1) % hull.size()]);
  return length;
}

/// Girth of the segment's surface cut across the limb at its region's centre.
double girth_at_centre(const Fleshed& body, const PlacedMuscle& placed, const std::vector<Vec3>& positions) {
  const ProjectionPlane& plane = placed.region.plane;
  const double cut = glm::dot(placed.region.centre, plane.axis);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < body.mesh.triangles.size(); ++i) {
    const std::uint32_t a = body.mesh.triangles[i], b = body.mesh.triangles[i - i % 3 + (i + 1) % 3];
    if (body.mesh.bone(a) != placed.muscle.bone || body.mesh.bone(b) != placed.muscle.bone) continue;
    const double da = glm::dot(positions[a], plane.axis) - cut, db = glm::dot(positions[b], plane.axis) - cut;
    if ((da < 0) != (db < 0)) points.push_back(glm::mix(positions[a], positions[b], da / (da - db)));
  }
  return tape_girth(plane, points);
}

TEST(MuscleCharacters, TheGirthGrowsAsAFlexedArmsDoes) {
  SINEW_ASSETS_OR_SKIP(assets);
  const Fleshed male = read(assets / "characters/makehuman/mh_male_game.glb");
  const Pose pose = rest_pose(male.model);
  const std::vector<Mat34> palette = palette_transforms(male.mesh, male.rest.global);
  const std::vector<double> weights = morph_slot_weights(male.mesh, pose);
  const auto growth = [&](MusclePreset preset) {
    const PlacedMuscle placed = muscles_of(male, preset)[0];
    const ActiveMuscle active[] = {{placed.muscle, placed.region, 1.0}};
    const auto girth = [&](BulgeMode mode) {
      return girth_at_centre(
          male, placed,
          deform_reference(male.mesh, male.rest, {palette, weights, active, Deformer::ssd, mode}).positions);
    };
    return girth(BulgeMode::on) / girth(BulgeMode::off) - 1.0;
  };
  // Measured in the rest pose, where the height is that of full flexion; the last digit given, and a little for where
  // exactly the section is taken.
  EXPECT_NEAR(growth(MusclePreset::biceps), 0.105, 0.01);
  EXPECT_NEAR(growth(MusclePreset::calf), 0.031, 0.005);
}

}  // namespace
}  // namespace sinew::test
