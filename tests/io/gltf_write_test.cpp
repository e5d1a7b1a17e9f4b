#include "engine/io/gltf_write.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/assets.h"
#include "tests/support/glb.h"
#include "tests/support/rig_round_trip.h"
#include "tests/support/small_rig.h"

namespace sinew {
namespace {

using namespace test;

void expect_same_influences(const Influences& a, const Influences& b) {
  ASSERT_EQ(a.first, b.first);
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    EXPECT_EQ(a.entries[i].joint, b.entries[i].joint);
    EXPECT_NEAR(a.entries[i].weight, b.entries[i].weight, 1e-7);
  }
}

void expect_same_targets(const Primitive& a, const Primitive& b) {
  ASSERT_EQ(a.morph_targets.size(), b.morph_targets.size());
  for (std::size_t t = 0; t < a.morph_targets.size(); ++t) {
    EXPECT_EQ(a.morph_targets[t].name, b.morph_targets[t].name);
    EXPECT_EQ(a.morph_targets[t].positions, b.morph_targets[t].positions);
    EXPECT_EQ(a.morph_targets[t].normals, b.morph_targets[t].normals);
  }
}

TEST(RigGlb, MeshesComeBack) {
  const Model model = two_meshes_on_one_skin(), back = written_and_read(model);
  ASSERT_EQ(back.meshes.size(), 3u);
  for (std::size_t m = 0; m < 3; ++m) {
    EXPECT_EQ(back.meshes[m].name, model.meshes[m].name);
    ASSERT_EQ(back.meshes[m].primitives.size(), model.meshes[m].primitives.size());
    for (std::size_t p = 0; p < model.meshes[m].primitives.size(); ++p) {
      const Primitive &a = model.meshes[m].primitives[p], &b = back.meshes[m].primitives[p];
      EXPECT_EQ(a.positions, b.positions);
      EXPECT_EQ(a.normals, b.normals);
      EXPECT_EQ(a.texture_coordinates, b.texture_coordinates);
      EXPECT_EQ(a.indices, b.indices);
      EXPECT_EQ(a.material, b.material);
      expect_same_influences(a.influences, b.influences);
      expect_same_targets(a, b);
    }
  }
  EXPECT_EQ(back.meshes[0].morph_weights, model.meshes[0].morph_weights);
}

TEST(RigGlb, ClipsComeBack) {
  const Model model = two_meshes_on_one_skin(), back = written_and_read(model);
  ASSERT_EQ(back.clips.size(), 3u);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(back.clips[c].name, model.clips[c].name);
    ASSERT_EQ(back.clips[c].channels.size(), model.clips[c].channels.size());
    for (std::size_t i = 0; i < model.clips[c].channels.size(); ++i) {
      const Channel &a = model.clips[c].channels[i], &b = back.clips[c].channels[i];
      EXPECT_EQ(a.node, b.node);
      EXPECT_EQ(a.path, b.path);
      EXPECT_EQ(a.interpolation, b.interpolation);
      EXPECT_EQ(a.width, b.width);
      EXPECT_EQ(a.times, b.times);
      ASSERT_EQ(a.values.size(), b.values.size());
      for (std::size_t k = 0; k < a.values.size(); ++k) EXPECT_NEAR(a.values[k], b.values[k], 1e-6);
    }
  }
}

TEST(RigGlb, MaterialsAndPicturesComeBack) {
  const Model model = two_meshes_on_one_skin(), back = written_and_read(model);
  ASSERT_EQ(back.materials.size(), 1u);
  expect_same_material(model.materials[0], back.materials[0]);
  ASSERT_EQ(back.images.size(), 1u);
  EXPECT_EQ(back.images[back.materials[0].base_colour_texture.image].bytes, model.images[0].bytes);
  EXPECT_EQ(back.images[0].name, "checks");
}

TEST(RigGlb, DeformsAsBefore) {
  const Model model = two_meshes_on_one_skin();
  expect_same_deformation(model, written_and_read(model));
}

TEST(RigGlb, EmptyModelIsAFileWithoutBinaryChunk) {
  const auto file = rig_glb({});
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(glb_json(*file), nlohmann::json::parse(R"({"asset": {"version": "2.0", "generator": "sinew"}})"));
  EXPECT_EQ(file->size(), 20 + glb_word(*file, 12));
}

TEST(RigGlb, EmptyArraysAreLeftOut) {
  Model model = two_meshes_on_one_skin();
  model.clips.push_back({"nothing", {}, 0.0});
  model.skins.push_back({"no joints", {}, {}});
  model.meshes[2].primitives[0].indices.clear();
  const Model back = written_and_read(model);
  EXPECT_EQ(back.clips.size(), 3u);
  EXPECT_EQ(back.skins.size(), 1u);
  EXPECT_EQ(back.meshes.size(), 2u);
}

TEST(RigGlb, PicturesThatGltfDoesNotKnowAreLeftOut) {
  Model model = two_meshes_on_one_skin();
  for (const Bytes& bytes : {Bytes{}, Bytes{'R', 'I', 'F', 'F', 0, 0, 0, 0, 'W', 'E', 'B', 'P'}}) {
    model.images[0].bytes = bytes;
    const Model back = written_and_read(model);
    EXPECT_TRUE(back.images.empty());
    EXPECT_EQ(back.materials.at(0).base_colour_texture.image, -1);
  }
}

TEST(RigGlb, SameModelGivesSameBytesInAWholeContainer) {
  const Bytes file = *rig_glb(two_meshes_on_one_skin());
  EXPECT_EQ(file, *rig_glb(two_meshes_on_one_skin()));
  EXPECT_EQ(glb_word(file, 8), file.size());
  EXPECT_EQ(glb_word(file, 12) % 4, 0u);
  const std::size_t binary = 20 + glb_word(file, 12);
  EXPECT_EQ(glb_word(file, binary + 4), 0x004E4942u);
  EXPECT_EQ(glb_word(file, binary) % 4, 0u);
  EXPECT_EQ(binary + 8 + glb_word(file, binary), file.size());
}

TEST(RigGlb, NamesThatAreNoUtf8DoNotStopIt) {
  Model model = two_meshes_on_one_skin();
  model.nodes[hip].name = "h\xFFip";
  const auto file = rig_glb(model);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(glb_json(*file)["nodes"][hip]["name"], "h\uFFFDip");
}

TEST(RigGlb, ReasonsNameThePlace) {
  const auto reason = [](auto&& spoil) {
    Model model = two_meshes_on_one_skin();
    spoil(model);
    const auto file = rig_glb(model);
    EXPECT_FALSE(file);
    EXPECT_TRUE(file || file.error().kind == ErrorKind::bad_input);
    return file ? std::string() : file.error().message;
  };
  EXPECT_NE(reason([](Model& m) { m.clips[0].channels[0].times[0] = -0.5; }).find("animations/0/samplers/0/input"),
            std::string::npos);
  EXPECT_NE(reason([](Model& m) { m.clips[2].channels[1].times[1] = 1.25 - 1e-12; }).find("key 2"), std::string::npos);
  EXPECT_NE(reason([](Model& m) {
              m.meshes[0].primitives[1].positions[3].z = 1e300;
            }).find("meshes/0/primitives/1/attributes/POSITION: number 2 of element 3"),
            std::string::npos);
}

BakedMesh two_triangles(std::size_t frames) {
  BakedMesh mesh;
  for (std::size_t i = 0; i < frames; ++i) {
    const float lift = 0.5f * static_cast<float>(i * i);
    mesh.frames.push_back({{{0, 0, 0}, {1, lift, 0}, {0, 1, 0}, {1, 1, lift}},
                           std::vector<Vec3f>(4, i % 2 == 0 ? Vec3f(0, 0, 1) : Vec3f(1, 0, 0))});
    mesh.times.push_back(static_cast<double>(i) / 8.0);
  }
  mesh.triangles = {0, 1, 2, 2, 1, 3};
  mesh.texture_coordinates = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  return mesh;
}

TEST(BakedGlb, EveryFrameComesBackAtItsTime) {
  const BakedMesh mesh = two_triangles(4);
  const auto file = baked_glb(mesh, "arm");
  ASSERT_TRUE(file) << file.error().message;
  const auto back = read_back(*file);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_TRUE(back->problems.empty());
  EXPECT_EQ(back->nodes.at(0).name, "arm");
  ASSERT_EQ(back->meshes.at(0).primitives.at(0).morph_targets.size(), 4u);
  ASSERT_EQ(back->clips.size(), 1u);
  EXPECT_EQ(back->clips[0].name, "baked");
  EXPECT_EQ(back->clips[0].channels.at(0).times, mesh.times);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::vector<Vec3> posed = skinned_positions(*back, 0, mesh.times[i]);
    for (std::size_t v = 0; v < 4; ++v) {
      EXPECT_EQ(posed[v], Vec3(mesh.frames[i].positions[v])) << "frame " << i << " vertex " << v;
      const Vec3 change = back->meshes[0].primitives[0].morph_targets[i].normals[v];
      EXPECT_EQ(Vec3(mesh.frames[0].normals[v]) + change, Vec3(mesh.frames[i].normals[v]));
    }
  }
  const std::vector<Vec3> between = skinned_positions(*back, 0, 0.5 * (mesh.times[1] + mesh.times[2]));
  EXPECT_NEAR(between[1].y, 0.5 * (0.5 + 2.0), 1e-6);
}

TEST(BakedGlb, OneFrameIsAPlainMesh) {
  const auto back = read_back(*baked_glb(two_triangles(1), "arm"));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_TRUE(back->clips.empty());
  EXPECT_TRUE(back->meshes.at(0).primitives.at(0).morph_targets.empty());
  EXPECT_EQ(back->meshes[0].primitives[0].indices, two_triangles(1).triangles);
}

TEST(BakedGlb, NothingIsStillAFile) {
  BakedMesh mesh;
  mesh.frames.resize(2);
  mesh.times = {0.0, 1.0};
  const auto back = read_back(*baked_glb(mesh, "nothing"));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_TRUE(back->meshes.empty());
}

TEST(BakedGlb, IndicesNeverRestartThePrimitive) {
  BakedMesh mesh;
  for (const std::size_t vertices : {65535u, 65536u}) {
    mesh.frames = {{std::vector<Vec3f>(vertices, Vec3f(0)), std::vector<Vec3f>(vertices, Vec3f(0, 0, 1))}};
    mesh.triangles = {0, 1, static_cast<std::uint32_t>(vertices - 1)};
    const nlohmann::json json = glb_json(*baked_glb(mesh, ""));
    const int indices = json["meshes"][0]["primitives"][0]["indices"];
    EXPECT_EQ(json["accessors"][indices]["componentType"], vertices == 65535u ? 5123 : 5125);
  }
}

TEST(BakedGlb, TimesThatDoNotRiseAreRefused) {
  BakedMesh mesh = two_triangles(3);
  mesh.times[2] = mesh.times[1];
  const auto file = baked_glb(mesh, "arm");
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("key 2"), std::string::npos);
}

TEST(RigGlb, PublicCharactersDeformAsBefore) {
  SINEW_ASSETS_OR_SKIP(assets);
  for (const char* name : {"khronos/CesiumMan.glb", "khronos/Fox.glb", "khronos/AnimatedMorphCube.glb",
                           "khronos/SimpleMorph.gltf", "godot_hand/LeftHandHumanoid.gltf"}) {
    SCOPED_TRACE(name);
    const auto model = read_gltf(assets / "characters" / name);
    ASSERT_TRUE(model) << model.error().message;
    expect_same_deformation(*model, written_and_read(*model));
  }
}

}  // namespace
}  // namespace sinew
