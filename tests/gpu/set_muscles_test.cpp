/// Muscles that change on a deformer that is there already, against one made anew.

#include <gtest/gtest.h>

#include "tests/gpu/parity.h"

namespace sinew::test {
namespace {

class SetMuscles : public DeviceTest, public ::testing::WithParamInterface<BufferLayout> {
 protected:
  static std::vector<Vec4f> words(GpuDeformer& deformer, const Chain& chain) {
    const ChainState state = chain_state(chain, ChainPose::bent);
    deformer.set_state({state.palette, state.morph_weights, state.activations});
    EXPECT_TRUE(deformer.run());
    auto out = deformer.read_back();
    EXPECT_TRUE(out);
    return out ? *out : std::vector<Vec4f>{};
  }
};

TEST_P(SetMuscles, GivesTheBitsOfADeformerMadeAnew) {
  // Several dispatches, so that every one of them finds details that have moved.
  const GpuDeformerOptions options{.layout = GetParam(), .largest_range = 512 * 32};
  Chain chain = make_chain(4);
  auto deformer = GpuDeformer::create(device(), chain.mesh, chain.rest, chain.muscles, options);
  ASSERT_TRUE(deformer);
  EXPECT_GT(deformer->dispatches(), 1u);
  std::vector<Vec4f> before = words(*deformer, chain);
  const auto change = [&](const char* what, auto set) {
    SCOPED_TRACE(what);
    MuscleSpec spec = chain_muscle_spec();
    set(spec);
    chain.muscles = {chain_muscle(chain, spec)};
    const auto done = deformer->set_muscles(chain.mesh, chain.rest, chain.muscles);
    ASSERT_TRUE(done) << done.error().message;
    const std::vector<Vec4f> after = words(*deformer, chain);
    EXPECT_NE(after, before) << "the change is seen";
    auto anew = GpuDeformer::create(device(), chain.mesh, chain.rest, chain.muscles, options);
    ASSERT_TRUE(anew);
    EXPECT_EQ(after, words(*anew, chain));
    before = after;
  };
  change("peak", [](MuscleSpec& spec) { spec.peak = 0.02; });
  change("sigma", [](MuscleSpec& spec) { spec.sigma = Vec2(0.3, 0.05); });
  change("angles", [](MuscleSpec& spec) { spec.rest_angle = 150.0, spec.reference_angle = 30.0; });
  change("a smaller region", [](MuscleSpec& spec) { spec.from = 0.4, spec.spread = 30.0; });
  change("one that has outgrown its buffer",
         [](MuscleSpec& spec) { spec.from = -1.0, spec.to = 2.0, spec.spread = 180.0; });
  change("another side", [](MuscleSpec& spec) { spec.facing = Vec3(1, 0, 0); });
}

TEST_P(SetMuscles, AnotherNumberOfMusclesIsRefused) {
  const Chain chain = make_chain(4);
  auto deformer = GpuDeformer::create(device(), chain.mesh, chain.rest, chain.muscles, {.layout = GetParam()});
  ASSERT_TRUE(deformer);
  const std::vector<Vec4f> before = words(*deformer, chain);
  EXPECT_FALSE(deformer->set_muscles(chain.mesh, chain.rest, {}));
  EXPECT_EQ(words(*deformer, chain), before);
}

INSTANTIATE_TEST_SUITE_P(Layouts, SetMuscles, ::testing::Values(BufferLayout::texel, BufferLayout::storage),
                         [](const auto& info) { return info.param == BufferLayout::texel ? "Texel" : "Storage"; });

}  // namespace
}  // namespace sinew::test
