#include "engine/io/gltf_read.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/support/gltf_builder.h"

namespace sinew::test {
namespace {

using nlohmann::json;

TEST(GltfRead, BinaryAndTextGiveTheSameModel) {
  GltfBuilder b;
  b.draw(b.triangle());
  const auto text = b.read();
  const ScratchFile file(b.binary(), ".vrm");
  const auto binary = read_gltf(file.path());
  ASSERT_TRUE(text) << text.error().message;
  ASSERT_TRUE(binary) << binary.error().message;
  EXPECT_EQ(text->meshes[0].primitives[0].positions, binary->meshes[0].primitives[0].positions);
  EXPECT_EQ(binary->file, file.path().string());
  EXPECT_TRUE(binary->problems.empty());
}

TEST(GltfRead, NormalsAreComputedWhereThereAreNone) {
  GltfBuilder b;
  b.draw(b.triangle());
  const auto model = b.read();
  ASSERT_TRUE(model);
  for (const Vec3& normal : model->meshes[0].primitives[0].normals) EXPECT_EQ(normal, Vec3(0, 0, 1));
}

TEST(GltfRead, NormalsAreNormalisedAndReplacedWithAWord) {
  GltfBuilder b;
  auto primitive = b.triangle();
  primitive["attributes"]["NORMAL"] = b.floats("VEC3", {0, 2, 0, 0, 0, 0, NAN, 0, 1});
  b.draw(primitive);
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->meshes[0].primitives[0].normals, (std::vector<Vec3>{{0, 1, 0}, {0, 0, 1}, {0, 0, 1}}));
  EXPECT_TRUE(mentions(*model, "1 normals are not of length 1"));
  EXPECT_TRUE(mentions(*model, "2 normals have no direction"));
}

TEST(GltfRead, PositionsThatAreNotFiniteAreRefused) {
  GltfBuilder b;
  b.draw({{"attributes", {{"POSITION", b.floats("VEC3", {0, 0, 0, 1, INFINITY, 0, 0, 1, 0})}}}});
  expect_refused(b, "vertex 1 is not finite");
}

TEST(GltfRead, QuantizedPositionsAreConverted) {
  GltfBuilder b;
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  b.draw(
      {{"attributes",
        {{"POSITION", b.accessor(b.view<signed char>(std::vector<int>{-128, 127, 0, 0, 64, -64, 0, 0, 0, 0, 0, 0}, 4),
                                 5120, "VEC3", 3, true)}}}});
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  const auto& positions = model->meshes[0].primitives[0].positions;
  EXPECT_EQ(positions[0], Vec3(-1, 1, 0));
  EXPECT_EQ(positions[1], Vec3(64 / 127.0, -64 / 127.0, 0));
  EXPECT_TRUE(model->problems.empty());
}

TEST(GltfRead, InterleavedAttributesAreTakenApart) {
  GltfBuilder b;
  std::vector<double> values;
  for (int v = 0; v < 3; ++v) values.insert(values.end(), {v * 1.0, v * 2.0, v == 1 ? 1.0 : 0.0, 0, 0, 1, v * 0.5, 1});
  const int view = b.view<float>(values, 32);
  b.draw({{"attributes",
           {{"POSITION", b.accessor(view, 5126, "VEC3", 3)},
            {"NORMAL", b.accessor(view, 5126, "VEC3", 3, false, 12)},
            {"TEXCOORD_0", b.accessor(view, 5126, "VEC2", 3, false, 24)}}}});
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  const Primitive& p = model->meshes[0].primitives[0];
  EXPECT_EQ(p.positions[2], Vec3(2, 4, 0));
  EXPECT_EQ(p.normals[1], Vec3(0, 0, 1));
  EXPECT_EQ(p.texture_coordinates[2], Vec2(1.0, 1.0));
}

TEST(GltfRead, SparseAccessorsReplaceElements) {
  GltfBuilder b;
  const int base = b.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int indices = b.view<unsigned short>(std::vector<int>{1});
  const int values = b.view<float>(std::vector<double>{5, 6, 7});
  b.json["accessors"][base]["sparse"] = {{"count", 1},
                                         {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                         {"values", {{"bufferView", values}}}};
  b.draw({{"attributes", {{"POSITION", base}}}});
  auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->meshes[0].primitives[0].positions, (std::vector<Vec3>{{0, 0, 0}, {5, 6, 7}, {0, 1, 0}}));

  b.json["accessors"][base].erase("bufferView");
  model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->meshes[0].primitives[0].positions, (std::vector<Vec3>{{0, 0, 0}, {5, 6, 7}, {0, 0, 0}}));

  b.json["accessors"][base]["count"] = 1;
  expect_refused(b, "sparse/indices: number 0 is 1");
}

TEST(GltfRead, StripsAndFansBecomeTriangles) {
  const std::vector<double> square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  for (const auto& [mode, expected] : {std::pair(5, std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}),
                                       std::pair(6, std::vector<std::uint32_t>{1, 2, 0, 2, 3, 0})}) {
    GltfBuilder b;
    b.draw({{"attributes", {{"POSITION", b.floats("VEC3", square)}}}, {"mode", mode}});
    const auto model = b.read();
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_EQ(model->meshes[0].primitives[0].indices, expected);
  }
}

TEST(GltfRead, PointsAndPrimitivesWithoutPositionsAreLeftOutWithAWord) {
  GltfBuilder b;
  auto points = b.triangle();
  points["mode"] = 0;
  b.add("meshes", {{"primitives", {points, {{"attributes", json::object()}}}}});
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(model->meshes[0].primitives.empty());
  EXPECT_TRUE(mentions(*model, "meshes/0/primitives/0: points or lines"));
  EXPECT_TRUE(mentions(*model, "meshes/0/primitives/1: has no POSITION"));
}

TEST(GltfRead, IndicesOfEveryTypeAndOutOfRange) {
  GltfBuilder b;
  auto primitive = b.triangle();
  const std::vector<double> order = {2, 1, 0};
  for (const int accessor : {b.integers<unsigned char>("SCALAR", order), b.integers<unsigned short>("SCALAR", order),
                             b.integers<unsigned>("SCALAR", order)}) {
    primitive["indices"] = accessor;
    b.draw(primitive);
  }
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  for (const Mesh& mesh : model->meshes) EXPECT_EQ(mesh.primitives[0].indices, (std::vector<std::uint32_t>{2, 1, 0}));
  primitive["indices"] = b.integers<unsigned char>("SCALAR", {0, 1, 3});
  b.draw(primitive);
  expect_refused(b, "meshes/3/primitives/0/indices: index 2 is 3, but there are only 3 vertices");
}

TEST(GltfRead, AttributeCountsMustAgree) {
  GltfBuilder b;
  auto primitive = b.triangle();
  primitive["attributes"]["NORMAL"] = b.floats("VEC3", {0, 0, 1, 0, 0, 1});
  b.draw(primitive);
  expect_refused(b, "meshes/0/primitives/0/attributes/NORMAL: has 2 elements, but POSITION has 3");
}

TEST(GltfRead, MorphTargetsNamesAndWeights) {
  GltfBuilder b;
  auto primitive = b.triangle();
  primitive["targets"] = {{{"POSITION", b.floats("VEC3", {0, 0, 1, 0, 0, 0, 0, 0, 0})}}, json::object()};
  const int mesh =
      b.add("meshes",
            {{"primitives", {primitive, b.triangle()}}, {"weights", {0.25}}, {"extras", {{"targetNames", {"smile"}}}}});
  b.add("nodes", {{"mesh", mesh}, {"weights", {0.5, 1.0}}});
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  const Mesh& read = model->meshes[0];
  EXPECT_EQ(read.morph_weights, (std::vector<double>{0.25, 0.0}));
  EXPECT_EQ(model->nodes[0].morph_weights, (std::vector<double>{0.5, 1.0}));
  EXPECT_EQ(read.primitives[0].morph_targets[0].name, "smile");
  EXPECT_EQ(read.primitives[0].morph_targets[1].name, "target_1");
  EXPECT_EQ(read.primitives[0].morph_targets[0].positions[0], Vec3(0, 0, 1));
  EXPECT_EQ(read.primitives[1].morph_targets.size(), 2u);
  EXPECT_TRUE(mentions(*model, "different numbers of morph targets"));
}

TEST(GltfRead, MissingImagesAreAProblemOnly) {
  GltfBuilder b;
  b.add("images", {{"uri", "no%20such.png"}});
  b.add("images", {{"uri", "data:image/png;base64,AAAA"}});
  b.add("images", json::object());
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(mentions(*model, "no such.png"));
  EXPECT_TRUE(mentions(*model, "images/1: is neither PNG nor JPEG"));
  EXPECT_TRUE(mentions(*model, "images/2: has neither a uri nor a bufferView"));
}

TEST(GltfRead, ExternalBuffersByPercentEncodedNames) {
  const ScratchFile data(std::string(36, '\0'), " with space.bin");
  std::string name = data.path().filename().string();
  name.replace(name.find(" with space"), 11, "%20with%20space");
  const json file = {{"asset", {{"version", "2.0"}}},
                     {"buffers", {{{"byteLength", 36}, {"uri", name}}}},
                     {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}}},
                     {"accessors", {{{"bufferView", 0}, {"componentType", 5126}, {"type", "VEC3"}, {"count", 3}}}},
                     {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}}}};
  const auto model = read_text(file.dump());
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->meshes[0].primitives[0].positions.size(), 3u);
}

TEST(GltfRead, BuffersThatAreNoFilesAreRefusedAtOnce) {
  const auto with = [](const std::string& uri) {
    return json{{"asset", {{"version", "2.0"}}}, {"buffers", {{{"byteLength", 4}, {"uri", uri}}}}}.dump();
  };
  const std::string fifo = ScratchFile("").path().string();
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  for (const std::string& uri :
       {std::string("/dev/zero"), std::string("."), fifo, std::string("http://example.com/a.bin"),
        std::string("data:application/octet-stream;base64,A"), std::string("%00"), std::string()})
    EXPECT_NE(refusal(with(uri)).find("buffers/0/uri"), std::string::npos) << uri;
  std::filesystem::remove(fifo);
}

TEST(GltfRead, HugeClaimsAreRefusedWithoutTakingMemory) {
  GltfBuilder b;
  b.draw({{"attributes",
           {{"POSITION", b.add("accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 2147483647}})}}}});
  expect_refused(b, "the model would take over");
  b.json["accessors"][0]["count"] = 4294967296.0;
  expect_refused(b, "accessors/0/count: must be a whole number");

  GltfBuilder many;
  json primitives = json::array();
  const int accessor = many.add("accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 1000000}});
  for (int i = 0; i < 1000; ++i) primitives.push_back({{"attributes", {{"POSITION", accessor}}}});
  many.add("meshes", {{"primitives", primitives}});
  expect_refused(many, "the model would take over");

  // A thousand primitives that lack five thousand morph targets each, the first of a very long name.
  GltfBuilder lacking;
  auto plain = lacking.triangle(), rich = plain;
  rich["targets"] = json::array();
  for (int i = 0; i < 5000; ++i) rich["targets"].push_back(json::object());
  primitives = {rich};
  for (int i = 0; i < 1000; ++i) primitives.push_back(plain);
  lacking.add("meshes",
              {{"primitives", primitives}, {"extras", {{"targetNames", {std::string(std::size_t{1} << 20, 'x')}}}}});
  expect_refused(lacking, "meshes/0: the model would take over");

  GltfBuilder offset;
  offset.draw(offset.triangle());
  offset.json["accessors"][0]["byteOffset"] = 2147483647;
  expect_refused(offset, "do not fit bufferViews/0");
  offset.json["accessors"][0]["byteOffset"] = 1.8446744073709552e19;
  expect_refused(offset, "accessors/0/byteOffset: must be a whole number");
}

TEST(GltfRead, DeepNestingIsRefused) {
  const std::string deep =
      R"({"asset":{"version":"2.0"},"extras":)" + std::string(100000, '[') + std::string(100000, ']') + "}";
  EXPECT_NE(refusal(deep).find("(read)"), 0u);
}

TEST(GltfRead, RequiredExtensionsAreNamed) {
  GltfBuilder b;
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  expect_refused(b, "KHR_draco_mesh_compression, which is not supported; supported are KHR_mesh_quantization");
  b.json.erase("extensionsRequired");
  b.json["extensionsUsed"] = {"KHR_materials_clearcoat", "VRMC_springBone", "EXT_other"};
  const auto model = b.read();
  ASSERT_TRUE(model);
  EXPECT_EQ(model->problems, std::vector<std::string>{"extensionsUsed: EXT_other is not read"});
}

TEST(GltfRead, Versions) {
  const auto asset = [](const json& value) { return json{{"asset", value}}.dump(); };
  EXPECT_TRUE(read_text(asset({{"version", "2.1"}, {"minVersion", "2.0"}})));
  EXPECT_NE(refusal(asset({{"version", "1.0"}})).find("asset/version"), std::string::npos);
  EXPECT_NE(refusal(asset({{"version", "2.1"}, {"minVersion", "2.1"}})).find("asset/minVersion"), std::string::npos);
  EXPECT_NE(refusal(asset({{"version", 2}})).find("asset/version: must be a text, found 2"), std::string::npos);
  EXPECT_NE(refusal("{}").find("asset: missing"), std::string::npos);
  EXPECT_NE(refusal("").find("empty"), std::string::npos);
  EXPECT_NE(refusal("hello").find("neither binary glTF"), std::string::npos);
}

TEST(GltfRead, VrmBones) {
  GltfBuilder b;
  for (int i = 0; i < 3; ++i) b.add("nodes", json::object());
  b.json["extensions"]["VRM"]["humanoid"]["humanBones"] = {{{"bone", "hips"}, {"node", 0}},
                                                           {{"bone", "leftThumbProximal"}, {"node", 1}},
                                                           {{"bone", "leftThumbIntermediate"}, {"node", 2}},
                                                           {{"bone", "jaw"}, {"node", 99}},
                                                           {{"bone", "neck"}, {"node", -1}}};
  auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->vrm_bones,
            (std::map<std::string, int>{{"hips", 0}, {"leftThumbMetacarpal", 1}, {"leftThumbProximal", 2}}));
  EXPECT_TRUE(mentions(*model, "jaw names no node"));
  EXPECT_EQ(model->problems.size(), 1u);
  b.json["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"] = {{"leftThumbProximal", {{"node", 1}}}};
  model = b.read();
  EXPECT_EQ(model->vrm_bones, (std::map<std::string, int>{{"leftThumbProximal", 1}}));
}

}  // namespace
}  // namespace sinew::test
