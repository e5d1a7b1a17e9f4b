/// Our swellings against those that a sculptor gave the same body: where and how they lie, not how much.

#include <fstream>
#include <iostream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/io/gltf_read.h"
#include "tests/body/posed_character.h"
#include "tests/support/assets.h"

namespace sinew::test {
namespace {

/// What the sculptor added along the normal of every vertex, world units; the file's vertices are those of the mesh
/// that it names.
std::vector<double> sculpted_heights(const Fleshed& body, const std::filesystem::path& file) {
  const nlohmann::json swelling = nlohmann::json::parse(std::ifstream(file));
  std::vector<double> heights(body.mesh.vertices());
  for (const MeshPart& part : body.mesh.parts) {
    if (part.mesh != swelling["mesh"]) continue;
    for (const auto& delta : swelling["deltas"]) {
      const std::size_t v = part.first_vertex + delta[0].get<std::size_t>();
      heights[v] = glm::dot(Vec3(delta[1], delta[2], delta[3]), body.rest.normals[v]);
    }
  }
  return heights;
}

/// How two swellings of one segment lie to each other.
struct Likeness {
  double correlation = 0.0;
  double centre_distance = 0.0;  ///< on the projection plane, in lengths of the segment
  std::size_t vertices = 0;      ///< compared: those on the muscle's side of the segment
};

Likeness likeness(const Fleshed& body, const PlacedMuscle& placed, const std::vector<double>& ours,
                  const std::vector<double>& theirs) {
  const ProjectionPlane& plane = placed.region.plane;
  const std::vector<bool> in_segment = segment_nodes(body.model, placed.muscle.bone, placed.muscle.child);
  std::vector<std::array<double, 2>> pairs;
  std::array<Vec2, 2> centre{};
  std::array<double, 2> mass{};
  for (std::size_t v = 0; v < body.mesh.vertices(); ++v) {
    const Vec3 from_bone = body.rest.positions[v] - plane.bone;
    if (!in_segment[body.mesh.bone(v)] || glm::dot(body.rest.normals[v], plane.normal) <= 0.0) continue;
    const std::array<double, 2> heights{ours[v], theirs[v]};
    pairs.push_back(heights);
    for (std::size_t i = 0; i < 2; ++i) {
      const double weight = std::max(heights[i], 0.0);
      centre[i] += weight * Vec2(glm::dot(from_bone, plane.axis), glm::dot(from_bone, plane.side));
      mass[i] += weight;
    }
  }
  Likeness result;
  result.vertices = pairs.size();
  result.centre_distance = glm::distance(centre[0] / mass[0], centre[1] / mass[1]) / plane.length;
  std::array<double, 2> mean{};
  for (const auto& pair : pairs)
    for (std::size_t i = 0; i < 2; ++i) mean[i] += pair[i] / static_cast<double>(pairs.size());
  double both = 0.0, first = 0.0, second = 0.0;
  for (const auto& pair : pairs) {
    const double a = pair[0] - mean[0], b = pair[1] - mean[1];
    both += a * b;
    first += a * a;
    second += b * b;
  }
  result.correlation = both / std::sqrt(first * second);
  return result;
}

TEST(MuscleSculpt, SwellsWhereASculptorDid) {
  SINEW_ASSETS_OR_SKIP(assets);
  const std::filesystem::path folder = assets / "characters/makehuman";
  for (const char* model : {"mh_male_game", "mh_male_default"}) {
    auto read = read_gltf(folder / fmt::format("{}.glb", model));
    ASSERT_TRUE(read) << read.error().message;
    const Fleshed body(std::move(*read));
    for (const auto& [preset, word] : {std::pair(MusclePreset::biceps, "biceps"), {MusclePreset::calf, "calf"}}) {
      MuscleSpec spec;
      spec.preset = preset;
      spec.side = MuscleSide::left;
      const auto placed = place_muscle(body.context(), spec);
      ASSERT_TRUE(placed) << placed.error().message;
      const std::vector<double> ours =
          flexed_to(body, *placed, placed->muscle.reference_angle).deformed({*placed}).heights;
      const Likeness like =
          likeness(body, *placed, ours, sculpted_heights(body, folder / fmt::format("mh_male_{}_swell.json", word)));
      const std::string name = fmt::format("{}_{}", model, word);
      RecordProperty(name + "_correlation", fmt::format("{:.3f}", like.correlation));
      RecordProperty(name + "_centre_distance", fmt::format("{:.3f}", like.centre_distance));
      std::cout << fmt::format("{}: correlation {:.3f}, centres {:.1f} % of the segment's length apart, {} vertices\n",
                               name, like.correlation, 100.0 * like.centre_distance, like.vertices);
      EXPECT_LT(like.centre_distance, 0.15) << name;
      // Far above chance (0.2 at most for so many vertices), far below what a copy would have.
      EXPECT_GT(like.correlation, 0.4) << name;
    }
  }
}

}  // namespace
}  // namespace sinew::test
