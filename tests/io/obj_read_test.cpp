#include "engine/io/obj_read.h"

#include <gtest/gtest.h>

#include "engine/core/files.h"

namespace sinew::test {
namespace {

Result<PolygonMesh> read(const std::string& text) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) /
      (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".obj");
  EXPECT_TRUE(write_file(file, text));
  auto mesh = read_obj(file);
  std::filesystem::remove(file);
  return mesh;
}

TEST(ObjRead, PlacesAndPolygons) {
  const PolygonMesh mesh = read("# a square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nv 0 1 -2.5\nf 1/1/1 2/1 3//1 -1\n").value();
  ASSERT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.positions[3], Vec3(0, 1, -2.5));
  ASSERT_EQ(mesh.polygons.size(), 1u);
  EXPECT_EQ(mesh.polygons[0], (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(ObjRead, FaultsHaveTheirLine) {
  for (const char* text : {"v 0 0 0\nv 1 x 0\n", "v 0 0 0\nf 1 2 3\n", "v 0 0 0\nf 0 0 0\n", "v 0 0 0\nf 1 1\n"}) {
    const auto result = read(text);
    ASSERT_FALSE(result) << text;
    EXPECT_EQ(result.error().kind, ErrorKind::bad_input);
    EXPECT_NE(result.error().message.find("line 2"), std::string::npos) << result.error().message;
  }
}

}  // namespace
}  // namespace sinew::test
