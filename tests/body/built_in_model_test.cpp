#include "engine/body/built_in_model.h"

#include <gtest/gtest.h>

#include "engine/model/scene_words.h"

namespace sinew {
namespace {

Model built(const std::string& name) {
  auto model = built_in_model(name);
  if (!model) {
    ADD_FAILURE() << model.error().message;
    return {};
  }
  return std::move(*model);
}

/// A head alone has regions in place of joints.
TEST(BuiltInModel, EveryNameGivesASkinnedModelAndAlwaysTheSame) {
  for (const std::string& name : built_in_model_names()) {
    const Model one = built(name), two = built(name);
    ASSERT_FALSE(one.meshes.empty()) << name;
    EXPECT_EQ(one.skins.empty(), name == "builtin:head") << name;
    const Primitive &a = one.meshes[0].primitives.at(0), &b = two.meshes.at(0).primitives.at(0);
    EXPECT_EQ(a.positions, b.positions) << name;
    EXPECT_EQ(a.indices, b.indices) << name;
  }
}

TEST(BuiltInModel, FiguresHaveTheNumbersOfTheCharactersThatTheyAreLike) {
  struct Numbers {
    const char* name;
    double vertices, triangles;
    std::size_t joints;
  };
  for (const auto& [name, vertices, triangles, joints] :
       {Numbers{"builtin:skeleton", 1844, 3342, 23}, Numbers{"builtin:woman", 2365, 4412, 37},
        Numbers{"builtin:poser", 86529, 166368, 68}}) {
    const Model model = built(name);
    const Primitive& skin = model.meshes.at(0).primitives.at(0);
    // A mesh of quads has its own numbers near by; 2 % is what a figure promises.
    EXPECT_NEAR(double(skin.positions.size()), vertices, 0.02 * vertices) << name;
    EXPECT_NEAR(double(skin.indices.size()) / 3.0, triangles, 0.02 * triangles) << name;
    EXPECT_EQ(model.skins.at(0).joints.size(), joints) << name;
  }
}

TEST(BuiltInModel, AnUnknownNameIsAnsweredWithTheNearest) {
  const auto model = built_in_model("builtin:wooman");
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().kind, ErrorKind::bad_input);
  EXPECT_NE(model.error().message.find("did you mean \"builtin:woman\"?"), std::string::npos) << model.error().message;
}

}  // namespace
}  // namespace sinew
