#include "engine/io/ply_read.h"

#include <bit>

#include <gtest/gtest.h>

#include "engine/io/mesh_read.h"
#include "engine/io/ply.h"

namespace sinew::test {
namespace {

Result<PolygonMesh> read(const Bytes& bytes) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) /
      (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".ply");
  EXPECT_TRUE(write_file(file, bytes));
  auto mesh = read_ply(file);
  std::filesystem::remove(file);
  return mesh;
}

Result<PolygonMesh> read(const std::string& text) { return read(Bytes(text.begin(), text.end())); }

const std::string text_header =
    "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty double z\n"
    "property uchar red\nelement face 1\nproperty uchar tag\nproperty list uchar int vertex_indices\n"
    "element edge 1\nproperty int vertex1\nend_header\n";

TEST(PlyRead, WhatIsWrittenIsReadAgain) {
  BakedMesh mesh;
  mesh.frames = {{{{0, 1, 2}, {3, 4, 5}, {6, 7, 8.5f}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  mesh.times = {0.0};
  mesh.triangles = {0, 2, 1};
  const PolygonMesh back = read(ply_bytes(mesh, 0)).value();
  ASSERT_EQ(back.positions.size(), 3u);
  EXPECT_EQ(back.positions[2], Vec3(6, 7, 8.5));
  ASSERT_EQ(back.polygons.size(), 1u);
  EXPECT_EQ(back.polygons[0], (std::vector<std::uint32_t>{0, 2, 1}));
}

TEST(PlyRead, TextWithWhatNobodyAskedFor) {
  const PolygonMesh mesh = read(text_header + "0 0 0 9\n1 0 0 9\n1 1 0 9\n0 1 -2.5 9\n7 4 0 1 2 3\n5\n").value();
  EXPECT_EQ(mesh.positions[3], Vec3(0, 1, -2.5));
  EXPECT_EQ(mesh.polygons.at(0), (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(PlyRead, BigEndianNumbers) {
  const std::string head =
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float32 x\nproperty int16 y\nproperty float64 z\n"
      "end_header\n";
  Bytes file(head.begin(), head.end());
  const auto put = [&](std::uint64_t bits, int size) {
    for (int i = size - 1; i >= 0; --i) file.push_back(static_cast<unsigned char>(bits >> (8 * i)));
  };
  put(std::bit_cast<std::uint32_t>(1.5f), 4);
  put(static_cast<std::uint16_t>(-3), 2);
  put(std::bit_cast<std::uint64_t>(0.1), 8);
  EXPECT_EQ(read(file).value().positions.at(0), Vec3(1.5, -3, 0.1));
}

TEST(PlyRead, FaultsAreNamed) {
  const std::string rows = "0 0 0 9\n1 0 0 9\n1 1 0 9\n";
  const std::pair<std::string, const char*> cases[] = {
      {"solid x\n", "line 1"},
      {"ply\nformat ascii 1.0\n", "cut off"},
      {"ply\nformat ascii 1.0\nelement vertex many\nend_header\n", "line 3"},
      {"ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n", "no y"},
      {"ply\nelement vertex 0\nproperty float x\nend_header\n", "no format"},
      {text_header + rows, "vertex 3: x"},
      {text_header + rows + "0 nan 0 9\n7 3 0 1 2\n5\n", "vertex 3: y"},
      {text_header + rows + "0 0 0 9\n7 2 0 1\n5\n", "2 corners"},
      {text_header + rows + "0 0 0 9\n7 3 0 1 4\n5\n", "face 0: names vertex 4 of 4"},
      {text_header + rows + "0 0 0 9\n7 3 0 1 -1\n5\n", "names vertex -1"},
  };
  for (const auto& [text, says] : cases) {
    const auto result = read(text);
    ASSERT_FALSE(result) << text;
    EXPECT_EQ(result.error().kind, ErrorKind::bad_input);
    EXPECT_NE(result.error().message.find(says), std::string::npos) << result.error().message;
  }
}

TEST(MeshRead, PolygonsBecomeFans) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "fan_of_a_square.OBJ";
  ASSERT_TRUE(write_file(file, std::string("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")));
  const Model model = read_mesh(file).value();
  std::filesystem::remove(file);
  const Primitive& primitive = model.meshes.at(0).primitives.at(0);
  EXPECT_EQ(primitive.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(primitive.normals.at(0), Vec3(0, 0, 1));
  EXPECT_EQ(model.nodes.at(0).name, "fan_of_a_square");
}

}  // namespace
}  // namespace sinew::test
