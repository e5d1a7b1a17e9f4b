#pragma once
/// The compute pass run on a chain, and how far it is from the reference.

#include "engine/gpu/gpu_deformer.h"
#include "tests/gpu/chain.h"
#include "tests/gpu/device_fixture.h"

namespace sinew::test {

constexpr double position_tolerance = 1e-5;         // of the box's diagonal: the promise of `sinew parity`
constexpr double normal_tolerance_degrees = 0.1;    // likewise
constexpr double tangent_tolerance_degrees = 1e-3;  // 300 roundings to single precision; llvmpipe needs 2e-5
/// Where the blend all but collapses, normals are ill-conditioned, and with them the planes that tangents lie in.
constexpr double singular_tolerance_degrees = 2.0;

/// What the device makes of a state: two words a vertex, then its tangents where the mesh has any: one a vertex.
inline std::vector<Vec4f> deform_on_device(Result<GpuDeformer> deformer, const GpuDeformState& state) {
  if (!deformer) {
    ADD_FAILURE() << deformer.error().message;
    return {};
  }
  deformer->set_state(state);
  EXPECT_TRUE(deformer->run());
  auto words = deformer->read_back();
  const auto tangents = deformer->read_back_tangents();
  EXPECT_TRUE(words && tangents);
  if (!words || !tangents) return {};
  words->insert(words->end(), tangents->begin(), tangents->end());
  return *words;
}

inline std::vector<Vec4f> deform_on_device(const Chain& chain, const ChainState& state,
                                           const GpuDeformerOptions& options) {
  return deform_on_device(GpuDeformer::create(device(), chain.mesh, chain.rest, chain.muscles, options),
                          {state.palette, state.morph_weights, state.activations});
}

struct Errors {
  double position = 0.0, normal = 0.0, singular_normal = 0.0, height = 0.0, tangent = 0.0, singular_tangent = 0.0;
  std::size_t singular = 0, lifted = 0, wrong_sides = 0;
};

inline Errors errors(const DeformedVertices& reference, const std::vector<Vec4f>& words) {
  Errors e;
  Bounds box;
  for (const Vec3& p : reference.positions) box.add(p);
  for (std::size_t v = 0; v < reference.positions.size(); ++v) {
    const Vec4 position(words[2 * v]);
    const double off = angle_degrees(Vec3(words[2 * v + 1]), reference.normals[v]);
    e.position = std::max(e.position, glm::length(Vec3(position) - reference.positions[v]) / box.diagonal());
    e.height = std::max(e.height, std::abs(position.w - reference.heights[v]));
    e.lifted += reference.heights[v] > 1e-3 ? 1 : 0;
    const bool singular = nearly_singular(reference.blend[v]);
    e.singular += singular ? 1 : 0;
    double& normal = singular ? e.singular_normal : e.normal;
    normal = std::max(normal, off);
    if (reference.tangents.empty()) continue;
    const Vec4 tangent(words[2 * reference.positions.size() + v]);
    double& turned = singular ? e.singular_tangent : e.tangent;
    turned = std::max(turned, angle_degrees(Vec3(tangent), Vec3(reference.tangents[v])));
    e.wrong_sides += tangent.w != reference.tangents[v].w ? 1 : 0;
  }
  return e;
}

}  // namespace sinew::test
