/// The face in the compute pass against the double-precision reference: every expression, mixes, on a skin and askew.

#include <random>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "engine/face/drawn_head.h"
#include "engine/face/expression.h"
#include "tests/gpu/parity.h"

namespace sinew::test {
namespace {

/// A head's mesh and what both deformers take beside its state.
struct FaceCharacter {
  CharacterMesh mesh;
  RestShape rest;
  std::vector<Mat34> palette;
  std::vector<double> morph_weights;
};

/// A head of level 1, in its own place.
const FaceCharacter& plain_head() {
  static const FaceCharacter made = [] {
    const auto head = DrawnHead::make({.level = 1}, 0.0);
    EXPECT_TRUE(head);
    FaceCharacter out;
    out.mesh = character_mesh(head->model());
    out.mesh.face = head->face();
    out.rest = rest_shape(head->model(), out.mesh, hierarchy_order(head->model()));
    out.palette = {Mat34::from(Mat4(1.0))};
    return out;
  }();
  return made;
}

/// The same turned, grown and moved in its bind pose, under a palette that turns it further; with tangents, a morph
/// target on some vertices, and more than four influences on some.
FaceCharacter askew_head() {
  FaceCharacter out = plain_head();
  const Mat4 turn = glm::rotate(Mat4(1.0), 0.7, glm::normalize(Vec3(1, 2, -1)));
  const Mat3 axes(turn);
  const Vec3 shift(0.3, 1.5, -0.2);
  constexpr double grown = 1.7;
  CharacterMesh& mesh = out.mesh;
  mesh.influences = {};
  mesh.morph_slots = {{0, 0}};
  mesh.morph_first = {0};
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    mesh.positions[v] = shift + grown * (axes * mesh.positions[v]);
    mesh.normals[v] = axes * mesh.normals[v];
    mesh.tangents.push_back(tangent_in_plane(Vec4(0.3, 0.5, -0.8, v % 2 == 0 ? 1 : -1), mesh.normals[v]));
    std::vector<Influence> run{{0, 0.7}, {1, 0.3}};
    if (v % 7 == 0) run = {{0, 0.3}, {1, 0.2}, {2, 0.2}, {3, 0.15}, {4, 0.15}};
    mesh.influences.add_vertex(run);
    if (v % 3 == 0) mesh.morph_deltas.push_back({0, Vec3(0.01, -0.005, 0.008), Vec3(0.1, 0.0, -0.1)});
    mesh.morph_first.push_back(static_cast<std::uint32_t>(mesh.morph_deltas.size()));
  }
  FacePlace& place = mesh.face->place;
  place = {axes * place.axes, shift + grown * (axes * place.origin), grown * place.unit};
  out.palette.clear();
  mesh.palette.assign(5, mesh.palette.front());
  for (int j = 0; j < 5; ++j)
    out.palette.push_back(Mat34::from(glm::translate(Mat4(1.0), Vec3(0.02 * j, 0.0, 0.1)) *
                                      glm::rotate(Mat4(1.0), 0.15 * j, Vec3(0, 1, 0))));
  out.rest.blend.assign(mesh.vertices(), Mat3(1.0));
  out.morph_weights = {0.8};
  return out;
}

FaceState state_of(const FaceCharacter& character, const FaceChannels& channels) {
  const FaceRig& rig = character.mesh.face->rig;
  return face_state(rig, hold_at_limits(rig, channels).channels);
}

FaceChannels random_channels(const FaceRig& rig, std::mt19937& random) {
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  FaceChannels out{};
  for (std::size_t i = 0; i < face_channels; ++i) {
    FaceChannels far{};
    const double way = share(random);
    far[i] = way < 0.0 ? -1e3 : 1e3;
    out[i] = std::abs(way) * hold_at_limits(rig, far).channels[i];
  }
  return out;
}

DeformedVertices on_cpu(const FaceCharacter& c, const FaceState& state) {
  return deform_reference(c.mesh, c.rest, {c.palette, c.morph_weights, {}, Deformer::ssd, BulgeMode::off, &state});
}

std::vector<Vec4f> on_device(const FaceCharacter& c, const FaceState* state, const GpuDeformerOptions& options = {}) {
  return deform_on_device(GpuDeformer::create(device(), c.mesh, c.rest, {}, options),
                          {c.palette, c.morph_weights, {}, state});
}

class FaceParity : public DeviceTest {
 protected:
  void expect_equal(const FaceCharacter& character, const FaceState& state, const std::string& what) {
    const Errors e = errors(on_cpu(character, state), on_device(character, &state));
    EXPECT_LE(e.position, position_tolerance) << what;
    EXPECT_LE(e.normal, normal_tolerance_degrees) << what;
    EXPECT_LE(e.tangent, normal_tolerance_degrees) << what;
    EXPECT_EQ(e.wrong_sides, 0u) << what;
    worst_ = std::max(worst_, e.position);
  }
  double worst_ = 0.0;
};

TEST_F(FaceParity, EveryExpressionEqualsTheReference) {
  for (const FacePreset& preset : expressions())
    expect_equal(plain_head(), state_of(plain_head(), preset.channels(false)), preset.name);
  RecordProperty("worst_relative_error", std::to_string(worst_));
}

TEST_F(FaceParity, RandomMixesOnASkinAndAskewEqualTheReference) {
  std::mt19937 random(11);
  const FaceCharacter askew = askew_head();
  for (int i = 0; i < 24; ++i) {
    const FaceChannels channels = random_channels(askew.mesh.face->rig, random);
    expect_equal(askew, state_of(askew, channels), "mix " + std::to_string(i));
  }
}

TEST_F(FaceParity, BothLayoutsAndChunksGiveTheSameBits) {
  const FaceCharacter askew = askew_head();
  std::mt19937 random(12);
  const FaceState state = state_of(askew, random_channels(askew.mesh.face->rig, random));
  const auto texel = on_device(askew, &state, {.layout = BufferLayout::texel});
  EXPECT_EQ(texel, on_device(askew, &state, {.layout = BufferLayout::storage}));
  EXPECT_EQ(texel, on_device(askew, &state, {.layout = BufferLayout::storage, .largest_range = 65536}));
}

/// At rest, and where there is no face at all, the same bits come out: zeros move nothing.
TEST_F(FaceParity, AFaceAtRestChangesNoBit) {
  for (const FaceCharacter& with : {plain_head(), askew_head()}) {
    FaceCharacter without = with;
    without.mesh.face.reset();
    const auto still = on_device(with, nullptr), faceless = on_device(without, nullptr);
    ASSERT_EQ(still.size(), faceless.size());
    std::size_t moved = 0;
    for (std::size_t v = 0; v < with.mesh.vertices(); ++v) moved += still[2 * v] != faceless[2 * v] ? 1 : 0;
    // Lids rest a little outside the least distance from the ball; only what rests on it may be pushed by a rounding.
    EXPECT_LE(moved, with.mesh.vertices() / 100);
  }
}

TEST_F(FaceParity, AnotherShapeTakesThePlaceOfTheFirst) {
  const HeadSpec film{.age = {{{0, 0.0}, {10, 1.0}}, Ease::linear}, .level = 1};
  const auto head = DrawnHead::make(film, 0.0);
  ASSERT_TRUE(head) << head.error().message;
  FaceCharacter character = plain_head();
  character.mesh = character_mesh(head->model());
  character.mesh.face = head->face();
  FaceCharacter older = character;
  head->age(3.7, older.mesh);
  head->age(0.0, character.mesh);
  const FaceState state = state_of(older, expressions()[2].channels(false));
  auto deformer = GpuDeformer::create(device(), character.mesh, character.rest, {}, {});
  ASSERT_TRUE(deformer) << deformer.error().message;
  ASSERT_TRUE(deformer->set_mesh(older.mesh, older.rest));
  deformer->set_state({older.palette, {}, {}, &state});
  ASSERT_TRUE(deformer->run());
  const auto words = deformer->read_back();
  ASSERT_TRUE(words);
  const Errors e = errors(on_cpu(older, state), *words);
  EXPECT_LE(e.position, position_tolerance);
  EXPECT_LE(e.normal, normal_tolerance_degrees);
}

/// What the comparison is worth: each of these faults must show.
TEST_F(FaceParity, WrongStatesAreSeen) {
  FaceChannels channels{};
  channel(channels, FaceChannel::jaw_drop) = 0.3;
  channel(channels, FaceChannel::upper_lid_left) = 0.5;
  channel(channels, FaceChannel::eye_right_yaw) = 10.0;
  channel(channels, FaceChannel::lip_seal) = 0.5;
  channel(channels, FaceChannel::corner_left_up) = 0.1;
  const FaceState right = state_of(plain_head(), channels);
  const DeformedVertices reference = on_cpu(plain_head(), right);
  for (const FaceChannel c : {FaceChannel::jaw_drop, FaceChannel::upper_lid_left, FaceChannel::eye_right_yaw,
                              FaceChannel::lip_seal, FaceChannel::corner_left_up}) {
    FaceChannels changed = channels;
    channel(changed, c) *= 0.99;
    const FaceState wrong = state_of(plain_head(), changed);
    EXPECT_GT(errors(reference, on_device(plain_head(), &wrong)).position, position_tolerance) << channel_word(c);
  }
}

}  // namespace
}  // namespace sinew::test
