/// The compute pass against the double-precision reference: every number of influences, deformer, bulge mode and pose.

#include <tuple>

#include <gtest/gtest.h>

#include "tests/gpu/parity.h"

namespace sinew::test {
namespace {

using Case = std::tuple<std::size_t, Deformer, BulgeMode, ChainPose>;

class Parity : public DeviceTest, public ::testing::WithParamInterface<Case> {};

TEST_P(Parity, ComputeEqualsReference) {
  const auto [influences, deformer, bulge, pose] = GetParam();
  const Chain chain = make_chain(influences);
  const ChainState state = chain_state(chain, pose);
  const std::vector<Vec4f> words = deform_on_device(chain, state, {.deformer = deformer, .bulge = bulge});
  ASSERT_EQ(words.size(), 3 * chain.mesh.vertices());
  const Errors e = errors(reference(chain, state, deformer, bulge), words);
  EXPECT_LE(e.position, position_tolerance);
  EXPECT_LE(e.normal, normal_tolerance_degrees);
  EXPECT_LE(e.singular_normal, singular_tolerance_degrees);
  EXPECT_LE(e.tangent, tangent_tolerance_degrees);
  EXPECT_LE(e.singular_tangent, singular_tolerance_degrees);
  EXPECT_EQ(e.wrong_sides, 0u);
  EXPECT_LE(e.height, 1e-6);  // of a peak of 0.06: float, and the device's exp() with a relative error of 1.2e-6
  // The case shows what it is for: the bent muscle lifts skin exactly where the bulge is on.
  if (pose == ChainPose::bent) {
    EXPECT_EQ(e.lifted > 0, bulge != BulgeMode::off);
  }
}

std::string case_name(const ::testing::TestParamInfo<Case>& info) {
  constexpr const char* deformers[] = {"Rigid", "Ssd"};
  constexpr const char* bulges[] = {"Off", "On", "Paper"};
  constexpr const char* poses[] = {"Rest", "Bent", "Twisted", "Stretched"};
  const auto [influences, deformer, bulge, pose] = info.param;
  return std::to_string(influences) + deformers[int(deformer)] + bulges[int(bulge)] + poses[int(pose)];
}

INSTANTIATE_TEST_SUITE_P(
    All, Parity,
    ::testing::Combine(::testing::Values(1, 2, 4, 8), ::testing::Values(Deformer::rigid, Deformer::ssd),
                       ::testing::Values(BulgeMode::off, BulgeMode::on, BulgeMode::paper),
                       ::testing::Values(ChainPose::rest, ChainPose::bent, ChainPose::twisted, ChainPose::stretched)),
    case_name);

class Layouts : public DeviceTest {};

/// Both builds of the shader do the same operations in the same order.
TEST_F(Layouts, TexelAndStorageBuffersGiveTheSameBits) {
  for (const std::size_t influences : {2, 8}) {
    const Chain chain = make_chain(influences);
    const ChainState state = chain_state(chain, ChainPose::bent);
    const auto texel = deform_on_device(chain, state, {.layout = BufferLayout::texel});
    const auto storage = deform_on_device(chain, state, {.layout = BufferLayout::storage});
    EXPECT_EQ(texel, storage);
  }
}

TEST_F(Layouts, ChunksGiveTheSameBitsAsOneDispatch) {
  const Chain chain = make_chain(8);
  const ChainState state = chain_state(chain, ChainPose::bent);
  for (const BufferLayout layout : {BufferLayout::texel, BufferLayout::storage}) {
    const auto whole = deform_on_device(chain, state, {.layout = layout});
    const GpuDeformerOptions small{.layout = layout, .largest_range = 16384};
    auto deformer = GpuDeformer::create(device(), chain.mesh, chain.rest, chain.muscles, small);
    ASSERT_TRUE(deformer) << deformer.error().message;
    EXPECT_GE(deformer->dispatches(), 2u);
    EXPECT_EQ(deform_on_device(chain, state, small), whole);
  }
}

/// Morphs and influences 5 to 8 are compiled out where a character has none: with and without must agree.
TEST_F(Layouts, AnIdleMorphChangesNothing) {
  const Chain with = make_chain(4, true), without = make_chain(4, false);
  ChainState state = chain_state(with, ChainPose::bent);
  std::fill(state.morph_weights.begin(), state.morph_weights.end(), 0.0);
  const auto a = deform_on_device(with, state, {});
  state.morph_weights.clear();
  EXPECT_EQ(a, deform_on_device(without, state, {}));
}

TEST_F(Layouts, RestAngleSwellsNothing) {
  const Chain chain = make_chain(4);
  const ChainState state = chain_state(chain, ChainPose::rest);
  ASSERT_EQ(state.activations.front(), 0.0);
  EXPECT_EQ(deform_on_device(chain, state, {.bulge = BulgeMode::on}),
            deform_on_device(chain, state, {.bulge = BulgeMode::off}));
}

/// What the comparison is worth: each of these faults in what the device is given must show.
class Mutants : public DeviceTest {
 protected:
  Errors against_reference(const Chain& chain, const ChainState& given, const ChainState& right) {
    return errors(reference(chain, right, Deformer::ssd, BulgeMode::on), deform_on_device(chain, given, {}));
  }
  const Chain chain_ = make_chain(4);
  const ChainState state_ = chain_state(chain_, ChainPose::bent);
};

TEST_F(Mutants, APaletteOffByATenThousandthIsSeen) {
  ChainState wrong = state_;
  wrong.palette[5].row[0].w += 1e-4;
  EXPECT_GT(against_reference(chain_, wrong, state_).position, position_tolerance);
}

TEST_F(Mutants, AWeakerMuscleIsSeen) {
  ChainState wrong = state_;
  wrong.activations[0] *= 0.99;
  const Errors e = against_reference(chain_, wrong, state_);
  EXPECT_GT(e.position, position_tolerance);
  EXPECT_GT(e.normal, normal_tolerance_degrees);
}

TEST_F(Mutants, AMorphLeftOutIsSeen) {
  ChainState wrong = state_;
  wrong.morph_weights[1] = 0.0;
  EXPECT_GT(against_reference(chain_, wrong, state_).position, position_tolerance);
}

TEST_F(Mutants, WeightsOfEightBitsAreSeen) {
  Chain coarse = chain_;
  for (Influence& influence : coarse.mesh.influences.entries)
    influence.weight = std::round(influence.weight * 255.0) / 255.0;
  const Errors e =
      errors(reference(chain_, state_, Deformer::ssd, BulgeMode::on), deform_on_device(coarse, state_, {}));
  EXPECT_GT(e.position, position_tolerance);
}

}  // namespace
}  // namespace sinew::test
