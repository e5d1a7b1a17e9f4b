#pragma once
/// Characters bent by an angle about a joint, deformed and measured.

#include "engine/body/girth_meter.h"
#include "engine/deform/reference.h"
#include "engine/rig/pose.h"
#include "tests/body/fleshed_skeleton.h"

namespace sinew::test {

/// A character whose joints have been turned one after the other.
class PosedCharacter {
 public:
  explicit PosedCharacter(const Fleshed& body)
      : body_(body),
        order_(hierarchy_order(body.model)),
        turns_(rest_rotations(body.model, order_)),
        pose_(rest_pose(body.model)) {}

  /// Turns a joint from its rest pose by `degrees` about an axis of the model: W^-1 R W q.
  PosedCharacter& turn(int node, const Vec3& axis, double degrees) {
    const int parent = body_.model.nodes[node].parent;
    const Quat w = parent < 0 ? Quat(1, 0, 0, 0) : turns_[parent];
    const Quat r = glm::angleAxis(degrees * degrees_to_radians, glm::normalize(axis));
    pose_.local[node].rotation = glm::inverse(w) * r * w * body_.model.nodes[node].rest.rotation;
    return *this;
  }

  std::vector<Mat4> global() const { return global_transforms(body_.model, order_, pose_); }
  double angle(const PlacedMuscle& placed) const { return placed.driver.degrees(global()); }
  double activation(const PlacedMuscle& placed) const {
    return muscle_activation(angle(placed), placed.muscle.rest_angle, placed.muscle.reference_angle);
  }

  DeformedVertices deformed(const std::vector<PlacedMuscle>& muscles, BulgeMode mode = BulgeMode::on,
                            Deformer deformer = Deformer::ssd) const {
    std::vector<ActiveMuscle> active;
    for (const PlacedMuscle& placed : muscles) active.push_back({placed.muscle, placed.region, activation(placed)});
    const std::vector<Mat34> palette = palette_transforms(body_.mesh, global());
    const std::vector<double> weights = morph_slot_weights(body_.mesh, pose_);
    return deform_reference(body_.mesh, body_.rest, {palette, weights, active, deformer, mode});
  }

  /// Tape girth of the muscle's segment where its region's centre lies.
  double tape_at_centre(const PlacedMuscle& placed, BulgeMode mode, Deformer deformer = Deformer::ssd) const {
    const ProjectionPlane& plane = placed.region.plane;
    const double at = glm::dot(placed.region.centre - plane.bone, plane.axis) / plane.length;
    const std::vector<Vec3> positions = deformed({placed}, mode, deformer).positions;
    const std::vector<Mat4> joints = global();
    const std::vector<std::uint32_t> triangles = welded_triangles(body_.mesh, body_.rest);
    const auto girth = limb_girth({body_.model, body_.mesh, triangles, positions, joints}, placed.muscle.bone,
                                  placed.muscle.child, at);
    EXPECT_TRUE(girth) << girth.error().message;
    return girth ? girth->tape : 0.0;
  }

 private:
  const Fleshed& body_;
  std::vector<int> order_;
  std::vector<Quat> turns_;
  Pose pose_;
};

/// The character with its muscle's driver turned about the hinge of its bend so far that the driver's angle is
/// `degrees`. The joint beyond is in the plane of facing and axis then.
inline PosedCharacter flexed_to(const Fleshed& body, const PlacedMuscle& placed, double degrees) {
  const Vec3 at(body.rest.global[placed.driver.at][3]), beyond(body.rest.global[placed.driver.after][3]),
      before(body.rest.global[placed.driver.before][3]);
  // About the bend's own hinge where there is a bend, so that the angle changes degree by degree.
  const Vec3 out = glm::normalize(beyond - at), back = glm::normalize(before - at);
  const Vec3 hinge =
      glm::length(glm::cross(back, out)) > 0.02 ? glm::cross(back, out) : glm::cross(placed.region.plane.normal, back);
  PosedCharacter character(body);
  character.turn(placed.driver.at, hinge, degrees - placed.driver.degrees(body.rest.global));
  return character;
}

}  // namespace sinew::test
