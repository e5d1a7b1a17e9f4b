/// Tangents through the compute pass, beyond the table of parity_test.cpp.

#include <gtest/gtest.h>

#include "engine/deform/rigid_split.h"
#include "tests/gpu/parity.h"

namespace sinew::test {
namespace {

class GpuTangents : public DeviceTest {
 protected:
  Errors against_reference(const Chain& given) {
    return errors(reference(chain_, state_, Deformer::ssd, BulgeMode::on), deform_on_device(given, state_, {}));
  }
  const Chain chain_ = make_chain(4);
  const ChainState state_ = chain_state(chain_, ChainPose::bent);
};

/// A specialisation constant leaves them out: the rest is the same to the bit.
TEST_F(GpuTangents, AreNoneWhereTheMeshHasNoneAndChangeNothingElse) {
  const Chain without = make_chain(4, true, false);
  ASSERT_TRUE(without.mesh.tangents.empty()) << "no material has a normal texture";
  for (const BufferLayout layout : {BufferLayout::texel, BufferLayout::storage}) {
    const auto bare = deform_on_device(without, state_, {.layout = layout});
    auto words = deform_on_device(chain_, state_, {.layout = layout});
    EXPECT_EQ(bare.size(), 2 * without.mesh.vertices());
    words.resize(bare.size());
    EXPECT_EQ(words, bare);
  }
}

TEST_F(GpuTangents, AreOfUnitLengthAtRightAnglesToTheNormal) {
  const std::size_t vertices = chain_.mesh.vertices();
  for (const ChainPose pose : {ChainPose::rest, ChainPose::bent, ChainPose::stretched}) {
    const auto words = deform_on_device(chain_, chain_state(chain_, pose), {});
    ASSERT_EQ(words.size(), 3 * vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
      const Vec3 tangent(words[2 * vertices + v]), normal(words[2 * v + 1]);
      EXPECT_NEAR(glm::length(tangent), 1.0, 1e-6);  // floats: some 1e-7 each
      EXPECT_NEAR(glm::dot(tangent, normal), 0.0, 1e-6);
    }
  }
}

TEST_F(GpuTangents, OfCopiesFollowTheirOwnJoint) {
  const RigidSplit split = split_by_bone(chain_.mesh);
  ASSERT_GT(split.duplicates.size(), 10u);
  auto deformer = GpuDeformer::create(device(), chain_.mesh, chain_.rest, chain_.muscles,
                                      {.deformer = Deformer::rigid, .bulge = BulgeMode::off}, split.duplicates);
  ASSERT_TRUE(deformer) << deformer.error().message;
  deformer->set_state({state_.palette, state_.morph_weights, state_.activations});
  ASSERT_TRUE(deformer->run());
  const auto words = deformer->read_back(), tangents = deformer->read_back_tangents();
  ASSERT_TRUE(words && tangents);
  const std::size_t vertices = chain_.mesh.vertices();
  ASSERT_EQ(tangents->size(), vertices + split.duplicates.size());
  for (std::size_t i = 0; i < split.duplicates.size(); ++i) {
    const auto& [vertex, joint] = split.duplicates[i];
    const Vec4 carried = carry_tangent(state_.palette[joint].linear(), chain_.mesh.tangents[vertex]);
    const Vec4 expected = tangent_in_plane(carried, glm::normalize(Vec3((*words)[2 * (vertices + i) + 1])));
    EXPECT_LT(glm::length(Vec4((*tangents)[vertices + i]) - expected), 1e-5) << i;  // floats: of sums of three
  }
}

TEST_F(GpuTangents, ATangentThatIsTurnedByAHundredthOfADegreeIsSeen) {
  Chain wrong = chain_;
  const Vec3 n = wrong.mesh.normals[100], t(wrong.mesh.tangents[100]);
  const double turn = 0.01 * degrees_to_radians;
  wrong.mesh.tangents[100] = Vec4(std::cos(turn) * t + std::sin(turn) * glm::cross(n, t), wrong.mesh.tangents[100].w);
  EXPECT_GT(against_reference(wrong).tangent, tangent_tolerance_degrees);
  EXPECT_LE(against_reference(chain_).tangent, tangent_tolerance_degrees);
}

TEST_F(GpuTangents, AWrongSideIsSeen) {
  Chain wrong = chain_;
  wrong.mesh.tangents[100].w *= -1;
  EXPECT_EQ(against_reference(wrong).wrong_sides, 1u);
}

/// A blend that mirrors changes the side of the bitangent, on the device as in the reference.
TEST_F(GpuTangents, AMirroringPoseChangesSides) {
  ChainState mirrored_state = state_;
  for (Mat34& joint : mirrored_state.palette) joint.row[0] = -joint.row[0];
  const DeformedVertices expected = reference(chain_, mirrored_state, Deformer::ssd, BulgeMode::on);
  const auto words = deform_on_device(chain_, mirrored_state, {});
  const Errors e = errors(expected, words);
  EXPECT_EQ(e.wrong_sides, 0u);
  EXPECT_LE(e.tangent, tangent_tolerance_degrees);
  EXPECT_EQ(expected.tangents[100].w, -chain_.mesh.tangents[100].w);
}

}  // namespace
}  // namespace sinew::test
