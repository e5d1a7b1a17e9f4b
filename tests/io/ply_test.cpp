#include "engine/io/ply.h"

#include <cstring>
#include <string>

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(Ply, HeaderThenVerticesThenTriangles) {
  BakedMesh mesh;
  mesh.frames = {{{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}}}};
  mesh.times = {0.0};
  mesh.triangles = {0, 1, 2, 2, 1, 3};
  const Bytes file = ply_bytes(mesh, 0);

  const std::string text(file.begin(), file.end());
  const std::string last_line = "end_header\n";
  const std::size_t body = text.find(last_line) + last_line.size();
  EXPECT_EQ(text.substr(0, body),
            "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
            "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 2\n"
            "property list uchar int vertex_indices\nend_header\n");
  ASSERT_EQ(file.size() - body, 4 * 24 + 2 * 13u);

  float vertices[4][6];
  std::memcpy(vertices, file.data() + body, sizeof vertices);
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(vertices[i][k], mesh.frames[0].positions[i][k]);
      EXPECT_EQ(vertices[i][3 + k], mesh.frames[0].normals[i][k]);
    }
  for (int i = 0; i < 2; ++i) {
    const unsigned char* face = file.data() + body + sizeof vertices + 13 * i;
    std::int32_t corners[3];
    std::memcpy(corners, face + 1, sizeof corners);
    EXPECT_EQ(face[0], 3);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(corners[k], static_cast<std::int32_t>(mesh.triangles[3 * i + k]));
  }
}

TEST(Ply, NothingIsStillAFile) {
  BakedMesh mesh;
  mesh.frames.resize(1);
  const Bytes file = ply_bytes(mesh, 0);
  const std::string text(file.begin(), file.end());
  EXPECT_NE(text.find("element vertex 0\n"), std::string::npos);
  EXPECT_TRUE(text.ends_with("end_header\n"));
}

}  // namespace
}  // namespace sinew
