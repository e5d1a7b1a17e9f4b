#pragma once
/// What a written rig is measured by: the model that is read back from it, and the vertices that both give.

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "engine/core/files.h"
#include "engine/io/gltf_read.h"
#include "engine/io/gltf_write.h"
#include "engine/model/character_mesh.h"
#include "engine/rig/clip_sampling.h"
#include "engine/rig/pose.h"

namespace sinew::test {

inline constexpr Texture Material::*texture_members[] = {
    &Material::base_colour_texture, &Material::metallic_roughness_texture, &Material::normal_texture,
    &Material::occlusion_texture, &Material::emissive_texture};

inline void expect_same_material(const Material& a, const Material& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.base_colour, b.base_colour);
  EXPECT_EQ(a.metallic, b.metallic);
  EXPECT_EQ(a.roughness, b.roughness);
  EXPECT_EQ(a.normal_scale, b.normal_scale);
  EXPECT_EQ(a.occlusion_strength, b.occlusion_strength);
  EXPECT_EQ(a.emissive, b.emissive);
  EXPECT_EQ(a.specular, b.specular);
  EXPECT_EQ(a.specular_colour, b.specular_colour);
  for (const auto member : texture_members) EXPECT_EQ(a.*member, b.*member);
  EXPECT_EQ(a.unlit, b.unlit);
  EXPECT_EQ(a.double_sided, b.double_sided);
  EXPECT_EQ(a.alpha_mode, b.alpha_mode);
  EXPECT_EQ(a.alpha_cutoff, b.alpha_cutoff);
}

/// The file's bytes, read as from a disk.
inline Result<Model> read_back(const Bytes& file) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / fmt::format("sinew_round_trip_{}.glb", ::getpid());
  if (auto written = write_file(path, file); !written) return pass_on(std::move(written));
  Result<Model> model = read_gltf(path);
  std::filesystem::remove(path);
  return model;
}

/// Positions of all vertices in a pose by linear blend skinning, world space.
inline std::vector<Vec3> skinned_positions(const Model& model, const Pose& pose) {
  const CharacterMesh mesh = character_mesh(model);
  const std::vector<Mat34> palette = palette_transforms(mesh, global_transforms(model, hierarchy_order(model), pose));
  const std::vector<double> weights = morph_slot_weights(mesh, pose);
  std::vector<Vec3> posed(mesh.vertices());
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    Vec3 rest = mesh.positions[v];
    for (std::uint32_t i = mesh.morph_first[v]; i < mesh.morph_first[v + 1]; ++i)
      rest += weights[mesh.morph_deltas[i].slot] * mesh.morph_deltas[i].position;
    for (std::uint32_t i = mesh.influences.first[v]; i < mesh.influences.first[v + 1]; ++i) {
      const Influence& influence = mesh.influences.entries[i];
      posed[v] += influence.weight * palette[influence.joint].transform_point(rest);
    }
  }
  return posed;
}

/// The same at a time of one clip; the rest pose where `clip` is negative.
inline std::vector<Vec3> skinned_positions(const Model& model, int clip, double seconds) {
  Pose pose = rest_pose(model);
  if (clip >= 0) sample_clip(model.clips[clip], seconds, pose);
  return skinned_positions(model, pose);
}

/// Largest distance between vertices of the same index, over the diagonal of the first list's box.
inline double relative_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  EXPECT_EQ(a.size(), b.size());
  if (a.size() != b.size()) return INFINITY;
  Bounds bounds;
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    bounds.add(a[i]);
    largest = std::max(largest, glm::length(a[i] - b[i]));
  }
  return largest == 0.0 ? 0.0 : largest / bounds.diagonal();
}

/// What is read back from the model's rig; a test that calls it fails where the reader finds anything to repair.
inline Model written_and_read(const Model& model) {
  const auto file = rig_glb(model);
  EXPECT_TRUE(file) << file.error().message;
  Result<Model> back = file ? read_back(*file) : Model{};
  EXPECT_TRUE(back) << back.error().message;
  if (!back) return {};
  EXPECT_TRUE(back->problems.empty()) << back->problems.front();
  return *back;
}

/// In the rest pose and at several times of every clip.
inline void expect_same_deformation(const Model& a, const Model& b) {
  ASSERT_EQ(a.clips.size(), b.clips.size());
  EXPECT_LT(relative_distance(skinned_positions(a, -1, 0), skinned_positions(b, -1, 0)), 1e-6);
  for (int clip = 0; clip < static_cast<int>(a.clips.size()); ++clip)
    for (const double share : {0.0, 0.3, 0.8, 1.0}) {
      const double seconds = share * a.clips[clip].duration;
      EXPECT_LT(relative_distance(skinned_positions(a, clip, seconds), skinned_positions(b, clip, seconds)), 1e-6)
          << "clip " << clip << " at " << seconds;
    }
}

}  // namespace sinew::test
