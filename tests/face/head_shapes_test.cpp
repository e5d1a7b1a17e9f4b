#include "engine/face/head_shapes.h"

#include <set>

#include "engine/face/half_head.h"
#include "tests/face/head_fixture.h"

namespace sinew::test {
namespace {

const std::vector<HeadShape>& shapes() {
  static const std::vector<HeadShape> all = head_shapes(head_of("adult"), false);
  return all;
}

TEST(HeadShapes, HaveEveryChannelAndPresetOnce) {
  std::set<std::string> names;
  for (const HeadShape& shape : shapes()) EXPECT_TRUE(names.insert(shape.name).second) << shape.name;
  for (const char* name : {"browLeft.up+", "jaw+", "upperLidRight-", "happy", "aa", "lookLeft", "anger", "eyeBlinkLeft",
                           "jawOpen", "mouthClose", "mouthSmileRight", "noseSneerLeft"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(HeadShapes, LinearLidsNeverTouchTheEyeball) {
  // A lid that moves straight dips to 0.97 of the ball's radius half way: the ball draws back with it.
  const Head& head = head_of("adult");
  for (const HeadShape& shape : shapes()) {
    if (shape.name == "mouthClose") continue;  // on top of another
    for (const double t : {0.25, 0.5, 0.75, 1.0}) {
      std::array<double, 2> ball{}, lid{INFINITY, INFINITY};
      for (std::size_t v = 0; v < head.positions.size(); ++v) {
        const FaceVertex& vertex = head.face.vertices[v];
        if (vertex.eye < 0) continue;
        const auto eye = static_cast<std::size_t>(vertex.eye);
        const double d = glm::distance(glm::mix(head.positions[v], shape.positions[v], t), head.face.eye_centres[eye]);
        if (vertex.ball) ball[eye] = std::max(ball[eye], d);
        if (vertex.least_distance > 0.0) lid[eye] = std::min(lid[eye], d);
      }
      for (std::size_t eye = 0; eye < 2; ++eye) {
        EXPECT_GT(lid[eye], ball[eye]) << shape.name << " at " << t;
        EXPECT_GT(ball[eye], 0.85 * head.face.eye_radius) << shape.name << ": a gap would show";
      }
    }
  }
}

TEST(HeadShapes, VerticesHaveFewDeltas) {
  // What engine/definitions.md promises the compute pass.
  const FaceRig& face = head_of("adult", "", 2).face;
  std::size_t most = 0;
  for (std::size_t v = 0; v < face.vertices.size(); ++v)
    most = std::max<std::size_t>(most, face.first[v + 1] - face.first[v]);
  EXPECT_LE(most, 16u);
  EXPECT_LT(double(face.deltas.size()) / double(face.vertices.size()), 4.0);
}

TEST(HeadShapes, HalvesMakeTheWhole) {
  const Head& head = head_of("adult");
  const auto find = [&](const std::string& name) { return *std::ranges::find(shapes(), name, &HeadShape::name); };
  const HeadShape left = find("noseSneerLeft"), right = find("noseSneerRight"), both = find("nose+");
  for (std::size_t v = 0; v < head.positions.size(); ++v) {
    const Vec3 sum = left.positions[v] + right.positions[v] - head.positions[v];
    ASSERT_LT(glm::distance(sum, both.positions[v]), 1e-9);
  }
}

TEST(HeadModel, PrimitivesHoldEveryVertexAndTarget) {
  const Head& head = head_of("adult");
  const Model model = head_model(head, nullptr, shapes());
  const auto& primitives = model.meshes[0].primitives;
  ASSERT_EQ(primitives.size(), head_materials);
  ASSERT_EQ(model.materials.size(), head_materials);
  std::vector<Vec3> all;
  std::size_t triangles = 0;
  for (const Primitive& p : primitives) {
    EXPECT_EQ(p.morph_targets.size(), shapes().size());
    triangles += p.indices.size() / 3;
    all.insert(all.end(), p.positions.begin(), p.positions.end());
  }
  EXPECT_EQ(triangles, head.triangles.size());
  const std::vector<std::uint32_t> numbers = model_vertices(head);
  for (std::size_t v = 0; v < numbers.size(); ++v) ASSERT_EQ(all[numbers[v]], head.metres() * head.positions[v]);
}

}  // namespace
}  // namespace sinew::test
