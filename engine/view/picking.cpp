#include "engine/view/picking.h"

#include <algorithm>
#include <array>
#include <map>

#include "engine/view/document.h"
#include "engine/view/listed_joints.h"

namespace sinew {
namespace {

/// The rotation of a transform whose scale is even.
Quat rotation_of(const Mat4& m) {
  return glm::normalize(
      glm::quat_cast(Mat3(glm::normalize(Vec3(m[0])), glm::normalize(Vec3(m[1])), glm::normalize(Vec3(m[2])))));
}

/// How far along the ray a triangle lies, and where in it (shares of its second and third corner): Moeller and
/// Trumbore 1997.
std::optional<Vec3> meet_triangle(const PointerRay& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, p = glm::cross(ray.way, ac);
  const double size = glm::dot(ab, p);
  if (size == 0.0) return std::nullopt;
  const Vec3 from = ray.eye - a, q = glm::cross(from, ab);
  const double u = glm::dot(from, p) / size, v = glm::dot(ray.way, q) / size, t = glm::dot(ac, q) / size;
  if (u < 0.0 || v < 0.0 || u + v > 1.0 || t <= 0.0) return std::nullopt;
  return Vec3(t, u, v);
}

/// To what reads well in a file and nobody sees: a hundredth of a degree.
Vec3 rounded(const Vec3& degrees) { return glm::round(100.0 * degrees) / 100.0 + 0.0; }

int strongest_joint(const CharacterMesh& mesh, const std::array<std::uint32_t, 3>& corners, const Vec3& shares) {
  std::map<int, double> weights;
  for (int k = 0; k < 3; ++k)
    for (std::uint32_t i = mesh.influences.first[corners[k]]; i < mesh.influences.first[corners[k] + 1]; ++i) {
      const auto& entry = mesh.influences.entries[i];
      weights[mesh.palette[entry.joint].node] += shares[k] * entry.weight;
    }
  const auto most = std::ranges::max_element(weights, {}, [](const auto& entry) { return entry.second; });
  return most == weights.end() ? -1 : most->first;
}

}  // namespace

PointerRay pointer_ray(const Viewpoint& viewpoint, const Vec2& at, const Vec2& size) {
  // Halves of the picture's height, from its middle.
  double x = (2.0 * at.x - size.x) / size.y, y = 1.0 - 2.0 * at.y / size.y;
  if (viewpoint.is_parallel()) {
    const double half = 0.5 * viewpoint.parallel_height;
    return {viewpoint.eye + half * (x * viewpoint.right + y * viewpoint.up), -viewpoint.back};
  }
  const double half = std::tan(0.5 * vertical_field_of_view_degrees * degrees_to_radians);
  x *= half;
  y *= half;
  return {viewpoint.eye, glm::normalize(x * viewpoint.right + y * viewpoint.up - viewpoint.back)};
}

std::optional<Vec3> meet_plane(const PointerRay& ray, const Vec3& point, const Vec3& normal) {
  const double along = glm::dot(ray.way, normal);
  if (std::abs(along) < 1e-9) return std::nullopt;
  const double t = glm::dot(point - ray.eye, normal) / along;
  if (t <= 0.0) return std::nullopt;
  return ray.eye + t * ray.way;
}

JointStand joint_stand(const Stage& stage, std::size_t character, const CharacterState& state, int node,
                       const std::string& name, double frame) {
  const StagedCharacter& staged = stage.characters[character];
  const Node& joint = staged.model->nodes[static_cast<std::size_t>(node)];
  const Mat4 placement = character_placement(stage, character, frame);
  const Quat unturned(1, 0, 0, 0);
  const bool is_root = joint.parent < 0;
  const Quat posed = is_root ? unturned : rotation_of(state.global[static_cast<std::size_t>(joint.parent)]);
  const Quat rest = is_root ? unturned : staged.rest_rotations[static_cast<std::size_t>(joint.parent)];
  const Mat4& global = state.global[static_cast<std::size_t>(node)];
  JointStand out;
  out.joint.carried = rotation_of(placement) * posed * glm::conjugate(rest);
  out.joint.place = Vec3(placement * global[3]);
  const bool added = staged.scene.motion && staged.scene.motion->keys == KeyBlend::add;
  const auto keys = staged.scene.keys.find(name);
  if (keys != staged.scene.keys.end() || added) {
    if (keys != staged.scene.keys.end()) out.degrees = keys->second.value_at(frame);
    out.joint.turn = rotation_xyz_degrees(out.degrees);
  } else {
    const Quat local = glm::conjugate(posed) * rotation_of(global);
    out.joint.turn = glm::normalize(rest * local * glm::conjugate(joint.rest.rotation) * glm::conjugate(rest));
    out.degrees = key_degrees(out.joint.turn, Vec3(0.0));
  }
  return out;
}

bool reach_with(const Stage& stage, std::size_t number, const CharacterState& state, const Limb& limb,
                const Vec3& target, double frame, Character& character) {
  const StagedCharacter& staged = stage.characters[number];
  const std::string upper_name = joint_name(staged, limb.upper), lower_name = joint_name(staged, limb.lower);
  if (upper_name.empty() || lower_name.empty()) return false;
  const JointStand upper = joint_stand(stage, number, state, limb.upper, upper_name, frame),
                   lower = joint_stand(stage, number, state, limb.lower, lower_name, frame);
  const Vec3 end(character_placement(stage, number, frame) * state.global[static_cast<std::size_t>(limb.end)][3]);
  const LimbTurns turns = reach(limb, upper.joint, lower.joint, end, target);
  set_joint_degrees(character, upper_name, frame, rounded(key_degrees(turns.upper, upper.degrees)));
  set_joint_degrees(character, lower_name, frame, rounded(key_degrees(turns.lower, lower.degrees)));
  return true;
}

std::optional<PickedJoint> joint_near(const Stage& stage, const std::vector<CharacterState>& states, double frame,
                                      const Screen& screen, const Vec2& at, double reach) {
  constexpr double as_near = 1.0;  // pixel
  std::optional<PickedJoint> best;
  double least = reach, foremost = INFINITY;
  for (std::size_t c = 0; c < states.size(); ++c) {
    const Mat4 placement = character_placement(stage, c, frame);
    for (const PaletteSource& entry : stage.characters[c].mesh.palette) {
      if (entry.node < 0) continue;
      const auto seen = screen.point(Vec3(placement * states[c].global[static_cast<std::size_t>(entry.node)][3]));
      if (!seen) continue;
      const double away = glm::distance(seen->at, at);
      if (away > reach || away > least + as_near) continue;
      if (away >= least - as_near && seen->depth >= foremost) continue;
      least = away;
      foremost = seen->depth;
      best = PickedJoint{c, entry.node};
    }
  }
  return best;
}

std::optional<PickedJoint> joint_of_skin(const Stage& stage, const std::vector<CharacterState>& states,
                                         const SceneOptions& options, const PointerRay& ray) {
  std::optional<PickedJoint> best;
  double nearest = INFINITY;
  for (std::size_t c = 0; c < states.size(); ++c) {
    const StagedCharacter& character = stage.characters[c];
    const std::vector<Vec3> skin = deform_on_cpu(character, states[c], options.deformer, options.bulge).positions;
    const std::vector<std::uint32_t>& indices = character.mesh.triangles;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      const std::array triangle{indices[i], indices[i + 1], indices[i + 2]};
      const auto met = meet_triangle(ray, skin[triangle[0]], skin[triangle[1]], skin[triangle[2]]);
      if (!met || met->x >= nearest) continue;
      nearest = met->x;
      best = PickedJoint{c, strongest_joint(character.mesh, triangle, {1.0 - met->y - met->z, met->y, met->z})};
    }
  }
  if (best && best->node < 0) return std::nullopt;
  return best;
}

}  // namespace sinew
