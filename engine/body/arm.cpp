#include "engine/body/arm.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "engine/body/hand_cage.h"
#include "engine/body/limb_sections.h"
#include "engine/body/quad_cage.h"

namespace sinew {
namespace {

/// The measures that limb_sections and hand_cage are drawn for.
constexpr double elbow_x = 0.30, wrist_x = 0.56;

/// The shoulder is cut off by a plane, as a sculpture's fragment is: further out at the deltoid than in the armpit.
constexpr double cut_x = -0.056, cut_slope = -0.30;
/// The cut's edge is rounded over this length.
constexpr double bevel = 0.010;
/// From here outwards the rings stand straight.
constexpr double straight_x = 0.084;

/// Where the cage has rings: closer where the elbow bends and where the biceps swells.
constexpr double ring_stations[] = {cut_x + bevel, -0.025, 0.004, 0.034, 0.064, 0.102, 0.118, 0.134, 0.149,
                                    0.165,         0.182,  0.202, 0.226, 0.252, 0.277, 0.297, 0.312, 0.327,
                                    0.345,         0.366,  0.394, 0.428, 0.468, 0.506, 0.538, 0.560};

/// Between these the surface leaves the sections and follows the hand's cage alone.
constexpr double sections_end = 0.530, cage_begins = 0.556;

constexpr int joint_count = 5;

/// How far behind the plane of the cut `p` lies.
double behind_cut(const Vec3& p) { return p.x - cut_x - cut_slope * p.y; }

LimbRing section_ring(QuadCage& cage, double station) {
  const double slope = cut_slope * (1.0 - smoothstep01((station - cut_x) / (straight_x - cut_x)));
  LimbRing ring;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const double angle = static_cast<double>(k) * 2.0 * std::numbers::pi / limb_ring_size;
    const double x = station + slope * limb_section(station, angle).x;
    const Vec2 yz = limb_section(x, angle);
    ring[k] = cage.add({x, yz.x, yz.y});
  }
  return ring;
}

/// The flat face of the cut: a ring just inside its edge, within it 3 x 3 quads whose outline is that ring.
void close_shoulder(QuadCage& cage, const LimbRing& edge) {
  const auto on_cut = [&](std::uint32_t vertex, double share, double rise) {
    const Vec3& p = cage.positions[vertex];
    return cage.add({cut_x + cut_slope * share * p.y - rise, share * p.y, share * p.z});
  };
  LimbRing ring;
  for (std::size_t k = 0; k < ring.size(); ++k) ring[k] = on_cut(edge[k], 0.82, 0.0);
  cage.bridge(ring, edge);
  std::array<std::uint32_t, 4> inner;
  for (std::size_t corner = 0; corner < inner.size(); ++corner) inner[corner] = on_cut(edge[3 * corner], 0.40, 0.001);
  for (std::size_t corner = 0; corner < inner.size(); ++corner) {
    const std::size_t k = 3 * corner, next = (corner + 1) % inner.size();
    const auto at = [&](std::size_t step) { return ring[(k + step + ring.size()) % ring.size()]; };
    cage.quads.push_back({at(1), at(0), at(ring.size() - 1), inner[corner]});
    cage.quads.push_back({at(2), at(1), inner[corner], inner[next]});
  }
  cage.quads.push_back({inner[3], inner[2], inner[1], inner[0]});
}

QuadCage arm_cage() {
  QuadCage cage;
  LimbRing ring = section_ring(cage, ring_stations[0]);
  close_shoulder(cage, ring);
  for (std::size_t s = 1; s < std::size(ring_stations); ++s) {
    const LimbRing next = section_ring(cage, ring_stations[s]);
    cage.bridge(ring, next);
    ring = next;
  }
  add_hand(cage, ring, wrist_x);
  return cage;
}

/// Lays refined vertices of the limb back on its sections: the cage's twelve sides alone would round muscles off.
void lay_on_sections(std::vector<Vec3>& positions) {
  for (Vec3& p : positions) {
    const double share = (1.0 - smoothstep01((p.x - sections_end) / (cage_begins - sections_end))) *
                         smoothstep01((behind_cut(p) - 0.5 * bevel) / (0.5 * bevel));
    if (share == 0.0) continue;
    const Vec2 on_section = limb_section(p.x, limb_section_angle(p.x, {p.y, p.z}));
    p = glm::mix(p, Vec3{p.x, on_section.x, on_section.y}, share);
  }
}

/// From the drawn measures to the wanted ones.
Vec3 fitted(const Vec3& p, const ArmShape& shape) {
  const double upper = shape.upper_arm_length / elbow_x, lower = shape.lower_arm_length / (wrist_x - elbow_x);
  const double hand_scale = shape.hand_length / drawn_hand_length;
  const double x = upper * std::min(p.x, elbow_x) + lower * std::clamp(p.x - elbow_x, 0.0, wrist_x - elbow_x) +
                   hand_scale * std::max(p.x - wrist_x, 0.0);
  const double across = glm::mix(shape.thickness, hand_scale, smoothstep01((p.x - 0.53) / 0.07));
  return {x, across * p.y, across * p.z};
}

/// 0 before a joint, 1 behind it, over `half_width` metres to either side.
double behind(double x, double joint_x, double half_width) {
  return smoothstep01(0.5 * (x - joint_x) / half_width + 0.5);
}

/// Weights by place along the straight limb, in the drawn measures. The olecranon is the ulna's: on the extensor side
/// the lower arm begins before the joint's axis, so that the bent elbow has its point. On the flexor side the two blend
/// over a longer stretch: there they meet in a fold, and a sharper change would push one through the other.
std::vector<Influence> influences_at(const Vec3& drawn) {
  const double extensor = smoothstep01((-0.006 - drawn.z) / 0.024);
  const double flexor = smoothstep01((drawn.z + 0.014) / 0.030);
  const double s = behind(drawn.x, -0.032, 0.026);
  const double e = behind(drawn.x, elbow_x - 0.027 * extensor + 0.009 * flexor, 0.050 + 0.036 * flexor);
  const double h = behind(drawn.x, wrist_x, 0.022);
  const double weights[] = {1 - s, s * (1 - e), s * e * (1 - h), s * e * h};
  std::vector<Influence> run;
  for (std::uint32_t joint = 0; joint < std::size(weights); ++joint)
    if (weights[joint] > 0.0) run.push_back({joint, weights[joint]});
  std::ranges::stable_sort(run, [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
  return run;
}

void add_skeleton(Model& model, const ArmShape& shape) {
  const char* const names[joint_count] = {"leftShoulder", "leftUpperArm", "leftLowerArm", "leftHand", "leftHandTip"};
  const double x[joint_count] = {cut_x * shape.upper_arm_length / elbow_x, 0.0, shape.upper_arm_length,
                                 shape.upper_arm_length + shape.lower_arm_length,
                                 shape.upper_arm_length + shape.lower_arm_length + shape.hand_length};
  Skin skin{.name = "arm", .joints = {}, .inverse_bind = {}};
  for (int joint = 0; joint < joint_count; ++joint) {
    Node node;
    node.name = names[joint];
    node.parent = joint - 1;
    if (joint + 1 < joint_count) node.children = {joint + 1};
    node.rest.translation.x = joint == 0 ? x[0] : x[joint] - x[joint - 1];
    model.nodes.push_back(node);
    skin.joints.push_back(joint);
    skin.inverse_bind.push_back(Transform{.translation = {-x[joint], 0, 0}}.matrix());
  }
  model.roots = {0};
  model.skins = {skin};
}

}  // namespace

Model make_arm(const ArmShape& shape) {
  assert(shape.upper_arm_length > 0 && shape.lower_arm_length > 0 && shape.hand_length > 0 && shape.thickness > 0);
  QuadCage cage = arm_cage();
  aim_limit_at_vertices(cage, 3);
  QuadCage surface = refine(cage);
  surface.positions = limit_positions(surface);
  lay_on_sections(surface.positions);
  for (Vec3& p : surface.positions) p = with_hand_relief(p, wrist_x);

  Primitive skin;
  for (Vec3& p : surface.positions) {
    skin.influences.add_vertex(influences_at(p));
    p = fitted(p, shape);
  }
  skin.positions = surface.positions;
  skin.normals = vertex_normals(surface);
  skin.indices = triangles(surface);
  skin.material = 0;

  Model model;
  model.file = "arm";
  add_skeleton(model, shape);
  Node body;
  body.name = "arm";
  body.mesh = 0;
  body.skin = 0;
  model.roots.push_back(static_cast<int>(model.nodes.size()));
  model.nodes.push_back(body);
  model.meshes.push_back({.name = "arm", .primitives = {skin}, .morph_weights = {}});
  Material& material = model.materials.emplace_back();
  material.name = "skin";
  material.base_colour = shape.base_colour;
  material.roughness = 0.55;
  return model;
}

}  // namespace sinew
