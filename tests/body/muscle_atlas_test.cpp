#include "engine/body/muscle_atlas.h"

#include <iostream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/body/muscle_spec.h"
#include "engine/io/gltf_read.h"
#include "engine/model/scene_words.h"
#include "tests/body/posed_character.h"
#include "tests/support/assets.h"

namespace sinew::test {
namespace {

MuscleSpec preset_spec(MusclePreset preset, MuscleSide side) {
  MuscleSpec spec;
  spec.preset = preset;
  spec.side = side;
  return spec;
}

std::string word_of(MusclePreset preset) { return muscle_preset_names()[static_cast<std::size_t>(preset)]; }

/// Every file of the folder that holds a whole humanoid with a skin.
std::vector<std::pair<std::string, Fleshed>> humanoids(const std::filesystem::path& folder) {
  std::vector<std::pair<std::string, Fleshed>> found;
  for (const char* family : {"kaykit", "makehuman", "mesh2motion", "quaternius"})
    for (const auto& entry : std::filesystem::directory_iterator(folder / family)) {
      const auto extension = entry.path().extension();
      if (extension != ".glb" && extension != ".gltf") continue;
      auto model = read_gltf(entry.path());
      EXPECT_TRUE(model) << model.error().message;
      if (!model) continue;
      Fleshed body(std::move(*model));
      if (body.humanoid.complete() && body.mesh.vertices() > 0)
        found.emplace_back(entry.path().filename().string(), std::move(body));
    }
  return found;
}

TEST(MuscleAtlas, StandsInTheOrderOfItsWordsAndMakesSense) {
  ASSERT_EQ(muscle_atlas().size(), muscle_preset_names().size());
  for (std::size_t i = 0; i < muscle_atlas().size(); ++i) {
    const AtlasMuscle& m = muscle_atlas()[i];
    EXPECT_EQ(static_cast<std::size_t>(m.preset), i);
    EXPECT_LT(m.from, m.to) << word_of(m.preset);
    EXPECT_FALSE(m.drivers.empty());
    EXPECT_GT(m.peak, 0.0);
    EXPECT_LE(m.peak, 0.30) << "no muscle swells more than the biceps";
    EXPECT_GT(m.spread, 20.0) << "the fade alone takes 20 degrees";
    EXPECT_GT(m.reason.size(), 60u) << word_of(m.preset);
  }
}

TEST(MuscleAtlas, EveryHumanoidOfTheFolderHasItsMuscles) {
  SINEW_ASSETS_OR_SKIP(assets);
  const auto bodies = humanoids(assets / "characters");
  EXPECT_GE(bodies.size(), 14u);
  for (const auto& [file, body] : bodies) {
    const Vec3 left = body_left(body.model, body.humanoid, body.rest.global),
               front = body_front(body.model, body.humanoid, body.rest.global);
    const Vec3 middle(body.rest.global[body.node("hips")][3]);
    for (const AtlasMuscle& m : muscle_atlas())
      for (const MuscleSide side : {MuscleSide::left, MuscleSide::right}) {
        const std::string name = fmt::format("{}: {}", file, muscle_name(preset_spec(m.preset, side)));
        const auto placed = place_muscle(body.context(), preset_spec(m.preset, side));
        ASSERT_TRUE(placed) << name << ": " << placed.error().message;
        const std::size_t count = placed->region.vertices.size();
        EXPECT_EQ(placement_problems(*placed).empty(), count >= 5 && placed->note.empty()) << name;
        // The limb's own side of the body.
        Vec3 mean(0.0);
        for (const RegionVertex& v : placed->region.vertices)
          mean += body.rest.positions[v.vertex] / static_cast<double>(count);
        const double sideways = glm::dot(mean - middle, left);
        // This robot wears an open coat on a tilted spine: its pectorals reach across the middle.
        const bool coat = file.starts_with("cyberpunk") && m.preset == MusclePreset::pectoral;
        if (count >= 5 && !coat) {
          EXPECT_GT(side == MuscleSide::left ? sideways : -sideways, 0.0) << name;
        }
        const Vec3 normal = placed->region.plane.normal;
        if (m.preset == MusclePreset::calf || m.preset == MusclePreset::hamstrings) {
          EXPECT_LT(glm::dot(normal, front), -0.7) << name;
        }
        if (m.preset == MusclePreset::quadriceps || m.preset == MusclePreset::pectoral) {
          EXPECT_GT(glm::dot(normal, front), 0.7) << name;
        }
        if (m.preset == MusclePreset::biceps || m.preset == MusclePreset::calf) {
          const double share = double(count) / double(placed->region.segment_vertices);
          std::cout << fmt::format("{}: {} of {} vertices, {:.0f} %\n", name, count, placed->region.segment_vertices,
                                   100 * share);
          // The thesis' 22 and 14 % are of evenly meshed limbs; boots and cuffs are denser than what they cover.
          EXPECT_GT(share, m.preset == MusclePreset::biceps ? 0.12 : 0.02) << name;
          EXPECT_LT(share, 0.33) << name;
        }
      }
  }
}

TEST(MuscleAtlas, NoMuscleMovesTheRestPose) {
  SINEW_ASSETS_OR_SKIP(assets);
  for (const auto& [file, body] : humanoids(assets / "characters")) {
    std::vector<PlacedMuscle> muscles;
    for (const AtlasMuscle& m : muscle_atlas())
      for (const MuscleSide side : {MuscleSide::left, MuscleSide::right})
        if (auto placed = place_muscle(body.context(), preset_spec(m.preset, side)))
          muscles.push_back(std::move(*placed));
    const PosedCharacter rest(body);
    for (const PlacedMuscle& placed : muscles) EXPECT_EQ(rest.activation(placed), 0.0) << file << placed.muscle.name;
    const DeformedVertices with = rest.deformed(muscles), without = rest.deformed({}, BulgeMode::off);
    EXPECT_EQ(with.positions, without.positions) << file << ": to the bit";
    EXPECT_EQ(with.normals, without.normals) << file;
  }
}

/// One muscle, the joint that is moved, and how: the muscle must swell, and the other way must not.
TEST(MuscleAtlas, SwellsWhenItsMuscleWorks) {
  SINEW_ASSETS_OR_SKIP(assets);
  auto model = read_gltf(assets / "characters/makehuman/mh_male_game.glb");
  ASSERT_TRUE(model);
  const Fleshed body(std::move(*model));
  const Vec3 left(1, 0, 0), up(0, 1, 0), front(0, 0, 1);
  struct Case {
    MusclePreset preset;
    const char* joint;
    Vec3 axis;
    double works, rests;  ///< degrees about the axis
  };
  const PlacedMuscle biceps = *place_muscle(body.context(), preset_spec(MusclePreset::biceps, MuscleSide::left));
  const Vec3 hinge = glm::cross(biceps.region.plane.axis, biceps.region.plane.normal);  // positive: the elbow flexes
  for (const Case& c : {Case{MusclePreset::biceps, "leftLowerArm", hinge, 60, -30},
                        {MusclePreset::triceps, "leftLowerArm", hinge, -40, 40},
                        {MusclePreset::calf, "leftFoot", left, 30, -20},
                        {MusclePreset::quadriceps, "leftUpperLeg", left, -80, 0},
                        {MusclePreset::hamstrings, "leftLowerLeg", left, 90, 0},
                        {MusclePreset::deltoid, "leftUpperArm", front, 60, -30},
                        {MusclePreset::pectoral, "leftUpperArm", up, -100, 0}}) {
    const auto placed = place_muscle(body.context(), preset_spec(c.preset, MuscleSide::left));
    ASSERT_TRUE(placed) << placed.error().message;
    const int joint = body.node(c.joint);
    EXPECT_EQ(placed->muscle.driver, joint) << word_of(c.preset);
    PosedCharacter works(body), rests(body);
    EXPECT_GT(works.turn(joint, c.axis, c.works).activation(*placed), 0.4) << word_of(c.preset);
    EXPECT_LT(works.activation(*placed), 1.05) << word_of(c.preset);
    EXPECT_LT(rests.turn(joint, c.axis, c.rests).activation(*placed), 0.01) << word_of(c.preset);
    const std::vector<double> heights = works.deformed({*placed}).heights;
    // Vertices stand beside the centre and the fade begins early: the peak itself is hardly reached.
    EXPECT_GT(*std::max_element(heights.begin(), heights.end()), 0.75 * works.activation(*placed) * placed->muscle.peak)
        << word_of(c.preset);
  }
}

TEST(MuscleAtlas, ASecondDriverHasItsOwnReferenceAngle) {
  const Fleshed body(arms_of({}));
  MuscleSpec spec = preset_spec(MusclePreset::calf, MuscleSide::right);
  EXPECT_EQ(place_muscle(body.context(), spec)->muscle.reference_angle, 150.0);
  spec.driver = "rightLowerLeg";
  EXPECT_EQ(place_muscle(body.context(), spec)->muscle.reference_angle, 60.0);
  spec.reference_angle = 90.0;
  EXPECT_EQ(place_muscle(body.context(), spec)->muscle.reference_angle, 90.0);
}

TEST(MuscleAtlas, AnExtensorNeedsRoomToStraighten) {
  // A straight arm leaves the triceps nothing; one bent by 20 degrees a part of its peak; by 60 all of it.
  const auto triceps = [](double bend) {
    const double turn = bend * degrees_to_radians;
    const Fleshed body(arms_of(
        {.elbow = {0.46, 1.43, 0}, .hand = Vec3(0.46, 1.43, 0) + 0.26 * Vec3(std::cos(turn), 0, std::sin(turn))}));
    auto placed = place_muscle(body.context(), preset_spec(MusclePreset::triceps, MuscleSide::left));
    return placed ? Result<double>(placed->muscle.peak) : tl::unexpected<Error>(placed.error());
  };
  const auto straight = triceps(0.0);
  ASSERT_FALSE(straight);
  EXPECT_NE(straight.error().message.find("nothing to grow by"), std::string::npos) << straight.error().message;
  ASSERT_TRUE(triceps(20.0));
  EXPECT_NEAR(*triceps(20.0), 20.0 / 45.0 * *triceps(60.0), 1e-9);
  EXPECT_NEAR(*triceps(60.0), 0.20 * arm_radius, 1e-9);
}

TEST(MuscleAtlas, WrittenOutInFullAMuscleIsTheSame) {
  SINEW_ASSETS_OR_SKIP(assets);
  for (const auto& [file, body] : humanoids(assets / "characters"))
    for (const AtlasMuscle& m : muscle_atlas()) {
      const auto placed = place_muscle(body.context(), preset_spec(m.preset, MuscleSide::right));
      ASSERT_TRUE(placed);
      const auto spec = explicit_muscle(body.context(), *placed);
      ASSERT_TRUE(spec) << spec.error().message;
      EXPECT_FALSE(spec->preset);
      const auto again = place_muscle(body.context(), *spec);
      ASSERT_TRUE(again) << file << ": " << again.error().message;
      const Muscle &a = placed->muscle, &b = again->muscle;
      EXPECT_EQ(std::tie(a.name, a.bone, a.child, a.driver, a.before, a.tip, a.except),
                std::tie(b.name, b.bone, b.child, b.driver, b.before, b.tip, b.except))
          << file;
      EXPECT_EQ(std::tie(a.from, a.to, a.spread, a.peak, a.rest_angle, a.reference_angle),
                std::tie(b.from, b.to, b.spread, b.peak, b.rest_angle, b.reference_angle));
      EXPECT_EQ(a.sigma, b.sigma);
      EXPECT_EQ(placed->region.vertices.size(), again->region.vertices.size());
    }
}

}  // namespace
}  // namespace sinew::test
