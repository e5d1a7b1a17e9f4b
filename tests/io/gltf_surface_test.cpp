#include "engine/io/gltf_surface.h"

#include <gtest/gtest.h>

#include "tests/support/painted_gltf.h"

namespace sinew::test {
namespace {

using nlohmann::json;

const std::vector<double> up_normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
const std::vector<double> some_tangents = {1, 0, 0, 1, 0, 1, 0, -1, -1, 0, 0, 1};
const char* const at = "meshes/0/primitives/0";

/// A triangle of a material; attributes are added to `primitive` before it is read.
struct Painted {
  explicit Painted(const json& material = {{"normalTexture", {{"index", 0}}}}) : builder(painted({material})) {
    primitive = builder.triangle();
    primitive["material"] = 0;
    primitive["attributes"]["NORMAL"] = builder.floats("VEC3", up_normals);
    primitive["attributes"]["TEXCOORD_0"] = builder.floats("VEC2", {0, 0, 1, 0, 0, 1});
  }
  json& attribute(const std::string& name) { return primitive["attributes"][name]; }
  Result<Model> read() const {
    GltfBuilder whole = builder;
    whole.draw(primitive);
    return whole.read();
  }
  /// What is read without a word.
  Primitive quiet() const {
    const auto model = read();
    EXPECT_TRUE(model) << model.error().message;
    if (!model) return {};
    EXPECT_TRUE(model->problems.empty()) << model->problems.front();
    return model->meshes[0].primitives[0];
  }
  /// What is read with exactly one word.
  Primitive told(std::string_view word) const {
    const auto model = read();
    EXPECT_TRUE(model) << model.error().message;
    if (!model) return {};
    EXPECT_EQ(model->problems, std::vector<std::string>{std::string(word)});
    return model->meshes[0].primitives[0];
  }
  void refused(const std::string& reason) const {
    GltfBuilder whole = builder;
    whole.draw(primitive);
    expect_refused(whole, reason);
  }

  GltfBuilder builder;
  json primitive;
};

TEST(GltfSurface, TangentsAreReadAndOfUnitLength) {
  Painted p;
  p.attribute("TANGENT") = p.builder.floats("VEC4", some_tangents);
  EXPECT_EQ(p.quiet().tangents, (std::vector<Vec4>{{1, 0, 0, 1}, {0, 1, 0, -1}, {-1, 0, 0, 1}}));
  p.attribute("TANGENT") = p.builder.floats("VEC4", {2, 0, 0, 0.5, 0, 1, 0, -0.25, -1, 0, 0, 1});
  const auto model = p.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->meshes[0].primitives[0].tangents, (std::vector<Vec4>{{1, 0, 0, 1}, {0, 1, 0, -1}, {-1, 0, 0, 1}}));
  EXPECT_TRUE(mentions(*model, "1 of TANGENT are not of length 1; normalised"));
  EXPECT_TRUE(mentions(*model, "2 of TANGENT have a w that is neither 1 nor -1"));
}

TEST(GltfSurface, TangentsMayBeSmallIntegers) {
  Painted p;
  const std::vector<double> bytes = {127, 0, 0, 127, 0, 127, 0, -127, -127, 0, 0, 127};
  p.attribute("TANGENT") = p.builder.integers<signed char>("VEC4", bytes, true);
  EXPECT_EQ(p.quiet().tangents[1], Vec4(0, 1, 0, -1));
  const std::vector<double> shorts = {32767, 0, 0, 32767, 0, 32767, 0, -32767, -32767, 0, 0, 32767};
  p.attribute("TANGENT") = p.builder.integers<short>("VEC4", shorts, true);
  EXPECT_EQ(p.quiet().tangents[2], Vec4(-1, 0, 0, 1));
}

TEST(GltfSurface, TangentsAreLeftOutWhereNothingNeedsThemOrNormalsAreMissing) {
  Painted plain(json::object());
  plain.attribute("TANGENT") = plain.builder.floats("VEC4", some_tangents);
  EXPECT_TRUE(plain.quiet().tangents.empty()) << "no normal texture";
  Painted without;
  without.attribute("TANGENT") = without.builder.floats("VEC4", some_tangents);
  without.primitive["attributes"].erase("NORMAL");
  EXPECT_TRUE(without.quiet().tangents.empty()) << "glTF: where normals are computed, tangents are ignored";
}

TEST(GltfSurface, TangentsWithoutADirectionAreComputedInstead) {
  for (const double hole : {0.0, double(NAN), double(INFINITY)}) {
    Painted p;
    p.attribute("TANGENT") = p.builder.floats("VEC4", {1, 0, 0, 1, hole, 0, 0, 1, 1, 0, 0, 1});
    EXPECT_TRUE(
        p.told(fmt::format("{}: tangent 1 has no direction; tangents are computed instead", at)).tangents.empty());
  }
}

TEST(GltfSurface, TextureCoordinatesOfEveryType) {
  const std::vector<Vec2> expected = {{1, 0}, {0, 1}, {0, 0}};
  Painted p;
  p.attribute("TEXCOORD_0") = p.builder.integers<unsigned char>("VEC2", {255, 0, 0, 255, 0, 0}, true);
  EXPECT_EQ(p.quiet().texture_coordinates, expected);
  p.attribute("TEXCOORD_0") = p.builder.integers<unsigned short>("VEC2", {65535, 0, 0, 65535, 0, 0}, true);
  EXPECT_EQ(p.quiet().texture_coordinates, expected);
  p.attribute("TEXCOORD_0") = p.builder.floats("VEC2", {1, 0, 0, 1, 0, 0});
  EXPECT_EQ(p.quiet().texture_coordinates, expected);
  p.attribute("TEXCOORD_0") = p.builder.integers<unsigned short>("VEC2", {3, 0, 0, 2, 0, 0});
  EXPECT_EQ(p.quiet().texture_coordinates[0], Vec2(3, 0)) << "KHR_mesh_quantization";
}

TEST(GltfSurface, TheSetsThatTheMaterialNamesAreRead) {
  const std::vector<double> first = {0, 0, 1, 0, 0, 1}, second = {0.5, 0.5, 0, 0.5, 0.5, 0};
  const auto with = [&](const json& material) {
    Painted p(material);
    p.attribute("TEXCOORD_1") = p.builder.floats("VEC2", second);
    return p.quiet();
  };
  const Primitive both =
      with({{"normalTexture", {{"index", 0}}}, {"occlusionTexture", {{"index", 1}, {"texCoord", 1}}}});
  EXPECT_EQ(both.texture_coordinates[1], Vec2(1, 0));
  EXPECT_EQ(both.second_texture_coordinates[1], Vec2(0, 0.5));
  const Primitive swapped =
      with({{"normalTexture", {{"index", 0}, {"texCoord", 1}}}, {"occlusionTexture", {{"index", 1}}}});
  EXPECT_EQ(swapped.texture_coordinates[1], Vec2(0, 0.5)) << "the set of the material's first texture comes first";
  EXPECT_EQ(swapped.second_texture_coordinates[1], Vec2(1, 0));
  const Primitive one = with({{"emissiveTexture", {{"index", 0}, {"texCoord", 1}}}});
  EXPECT_EQ(one.texture_coordinates[1], Vec2(0, 0.5));
  EXPECT_TRUE(one.second_texture_coordinates.empty());
  const Primitive none = with(json::object());
  EXPECT_EQ(none.texture_coordinates[1], Vec2(1, 0)) << "no texture, so TEXCOORD_0";
  EXPECT_TRUE(none.second_texture_coordinates.empty());
}

TEST(GltfSurface, AMissingSetIsToldWhereATextureNeedsIt) {
  Painted p(json{{"normalTexture", {{"index", 0}, {"texCoord", 7}}}});
  EXPECT_TRUE(
      p.told(fmt::format("{}: its material's texture needs TEXCOORD_7, which is not there; drawn without it", at))
          .texture_coordinates.empty());
  Painted untextured(json::object());
  untextured.primitive["attributes"].erase("TEXCOORD_0");
  EXPECT_TRUE(untextured.quiet().texture_coordinates.empty());
}

TEST(GltfSurface, ColoursOfEveryType) {
  Painted p(json::object());
  const std::vector<Vec4> opaque = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
  const std::vector<Vec4> clear = {{1, 0, 0, 0}, {0, 1, 0, 1}, {0, 0, 1, 0}};
  const auto list = [](double full, bool alpha) {
    std::vector<double> values;
    for (int v = 0; v < 3; ++v) {
      for (int c = 0; c < 3; ++c) values.push_back(v == c ? full : 0);
      if (alpha) values.push_back(v == 1 ? full : 0);
    }
    return values;
  };
  for (const bool alpha : {false, true}) {
    const std::string type = alpha ? "VEC4" : "VEC3";
    for (const int accessor :
         {p.builder.floats(type, list(1, alpha)), p.builder.integers<unsigned char>(type, list(255, alpha), true),
          p.builder.integers<unsigned short>(type, list(65535, alpha), true)}) {
      p.attribute("COLOR_0") = accessor;
      EXPECT_EQ(p.quiet().colours, alpha ? clear : opaque) << type << " accessor " << accessor;
    }
  }
  EXPECT_TRUE(Painted().quiet().colours.empty());
}

TEST(GltfSurface, ColoursThatAreNoneAreMendedWithAWord) {
  Painted p(json::object());
  p.attribute("COLOR_0") = p.builder.floats("VEC3", {1, 2, 0, 0.5, NAN, 0, -1, 0, 0.5});
  const auto model = p.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->meshes[0].primitives[0].colours, (std::vector<Vec4>{{1, 1, 0, 1}, {1, 1, 1, 1}, {0, 0, 0.5, 1}}));
  EXPECT_TRUE(mentions(*model, "1 of COLOR_0 are not finite; taken as white"));
  EXPECT_TRUE(mentions(*model, "2 of COLOR_0 lie outside 0 to 1; clamped"));
  p.attribute("COLOR_0") = p.builder.integers<unsigned char>("VEC4", {255, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(
      p.told(fmt::format("{}/attributes/COLOR_0: whole numbers that are not normalized; all but 0 are taken as 1", at))
          .colours[1],
      Vec4(1, 0, 0, 0));
}

TEST(GltfSurface, CoordinatesThatAreNotFiniteAreZeroWithAWord) {
  Painted p;
  p.attribute("TEXCOORD_0") = p.builder.floats("VEC2", {1, 0, NAN, 0, 0, INFINITY});
  EXPECT_EQ(p.told(fmt::format("{}: 2 of TEXCOORD_0 are not finite; taken as 0", at)).texture_coordinates,
            (std::vector<Vec2>{{1, 0}, {0, 0}, {0, 0}}));
}

TEST(GltfSurface, SparseAttributesReplaceElements) {
  Painted p;
  const int indices = p.builder.view<unsigned char>(std::vector<int>{1});
  const auto sparse = [&](const std::string& type, const std::vector<double>& value) {
    const int values = p.builder.view<float>(value);
    return p.builder.add("accessors", {{"componentType", 5126},
                                       {"type", type},
                                       {"count", 3},
                                       {"sparse",
                                        {{"count", 1},
                                         {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                         {"values", {{"bufferView", values}}}}}});
  };
  p.attribute("TEXCOORD_0") = sparse("VEC2", {0.25, 0.75});
  p.attribute("COLOR_0") = sparse("VEC4", {1, 0.5, 0.25, 1});
  const Primitive read = p.quiet();
  EXPECT_EQ(read.texture_coordinates, (std::vector<Vec2>{{0, 0}, {0.25, 0.75}, {0, 0}}));
  EXPECT_EQ(read.colours, (std::vector<Vec4>{Vec4(0), {1, 0.5, 0.25, 1}, Vec4(0)}));
  const int tangents = p.builder.floats("VEC4", some_tangents);
  const int value = p.builder.view<float>(std::vector<double>{0, -1, 0, 1});
  p.builder.json["accessors"][tangents]["sparse"] = {{"count", 1},
                                                     {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                                     {"values", {{"bufferView", value}}}};
  p.attribute("TANGENT") = tangents;
  EXPECT_EQ(p.quiet().tangents, (std::vector<Vec4>{{1, 0, 0, 1}, {0, -1, 0, 1}, {-1, 0, 0, 1}}));
}

TEST(GltfSurface, WrongFormatsAndCountsAreRefusedAtTheirPlace) {
  struct Case {
    const char* attribute;
    const char* type;
    const char* words;
  };
  const Case cases[] = {{"TANGENT", "VEC3", "VEC4 of floats, or of normalized integers"},
                        {"TEXCOORD_0", "VEC3", "VEC2 of floats, bytes or shorts"},
                        {"COLOR_0", "VEC2", "VEC3 or VEC4 of floats, or of normalized bytes or shorts"}};
  for (const auto& [attribute, type, words] : cases) {
    Painted p;
    const auto width = static_cast<std::size_t>(type[3] - '0');
    const int accessor = p.builder.floats(type, std::vector<double>(3 * width, 1.0));
    p.attribute(attribute) = accessor;
    p.refused(fmt::format("{}/attributes/{} (accessors/{}): must be {}", at, attribute, accessor, words));
    const int integers = p.builder.integers<unsigned>("VEC4", std::vector<double>(12, 1.0));
    p.attribute(attribute) = integers;
    p.refused(fmt::format("{}/attributes/{} (accessors/{}): must be {}", at, attribute, integers, words));
  }
  for (const char* attribute : {"TANGENT", "TEXCOORD_0", "TEXCOORD_1", "COLOR_0"}) {
    Painted p;
    p.attribute(attribute) = p.builder.floats("VEC4", {1, 0, 0, 1, 1, 0, 0, 1});
    p.refused(fmt::format("{}/attributes/{}: has 2 elements, but POSITION has 3", at, attribute));
    p.attribute(attribute) = 99;
    p.refused(fmt::format("{}/attributes/{}: refers to accessors 99, but there are", at, attribute));
  }
}

}  // namespace
}  // namespace sinew::test
