#include "engine/io/obj.h"

#include <cstdlib>
#include <locale>
#include <sstream>

#include <gtest/gtest.h>

namespace sinew {
namespace {

BakedMesh one_triangle() {
  BakedMesh mesh;
  mesh.frames = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}},
                 {{{0.1f, -0.0f, 1e-8f}, {1234567.0f, 2, 3}, {4, 5, 6}}, {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}}};
  mesh.times = {0.0, 1.0};
  mesh.triangles = {0, 1, 2};
  return mesh;
}

TEST(Obj, FacesNameVertexAndNormalFromOne) {
  EXPECT_EQ(obj_text(one_triangle(), 0, "made by a test\nsecond line"),
            "# made by a test\n# second line\n"
            "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
            "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\n"
            "f 1//1 2//2 3//3\n");
}

TEST(Obj, TextureCoordinatesCountFromTheLowerEdge) {
  BakedMesh mesh = one_triangle();
  mesh.texture_coordinates = {{0, 0}, {1, 0.25f}, {0.5f, 1}};
  const std::string text = obj_text(mesh, 0, "");
  EXPECT_NE(text.find("vt 0 1\nvt 1 0.75\nvt 0.5 0\n"), std::string::npos);
  EXPECT_NE(text.find("f 1/1/1 2/2/2 3/3/3\n"), std::string::npos);
  EXPECT_EQ(text.front(), 'v');
}

TEST(Obj, NumbersGiveTheSameFloatBack) {
  const BakedMesh mesh = one_triangle();
  std::istringstream lines(obj_text(mesh, 1, ""));
  lines.imbue(std::locale::classic());
  for (const Vec3f& p : mesh.frames[1].positions) {
    std::string keyword, x, y, z;
    lines >> keyword >> x >> y >> z;
    EXPECT_EQ(keyword, "v");
    EXPECT_EQ(std::strtof(x.c_str(), nullptr), p.x);
    EXPECT_EQ(std::strtof(y.c_str(), nullptr), p.y);
    EXPECT_EQ(std::strtof(z.c_str(), nullptr), p.z);
    EXPECT_NE(y, "-0");
  }
  EXPECT_NE(obj_text(mesh, 1, "").find("v 0.100000001 0 "), std::string::npos);
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(Obj, LocaleDoesNotMatter) {
  const std::string expected = obj_text(one_triangle(), 1, "");
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  const std::string text = obj_text(one_triangle(), 1, "");
  std::locale::global(before);
  EXPECT_EQ(text, expected);
}

}  // namespace
}  // namespace sinew
