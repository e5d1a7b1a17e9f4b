#pragma once
/// The weights of one side of a body on the other.

#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/fit/skinned_shape.h"
#include "engine/model/model.h"

namespace sinew {

enum class BodySide { left, right };

/// The plane between the left and the right of a body at rest.
struct MirrorPlane {
  Vec3 left{1, 0, 0};   ///< unit
  double middle = 0.0;  ///< of the plane's points along `left`

  Vec3 mirrored(const Vec3& p) const { return p - 2.0 * (glm::dot(p, left) - middle) * left; }
};

/// The body's left, through the middle of its pairs of humanoid joints; without any such pair the plane x = 0.
MirrorPlane mirror_plane(const Model& model);

/// The partner of each joint of a skin, [joints]: by the humanoid map, else the joint that stands where the mirror has
/// it (within 2 % of the skeleton's size) and whose name is nearest with left and right exchanged; -1: none.
std::vector<int> mirror_joints(const Model& model, const Skin& skin, const MirrorPlane& plane);

/// The weights of the side `from` on the other one, by the closest point of the mirrored surface; in the middle, within
/// a thousandth of the size, the mean of both. Fails as bad_input where a joint whose weight is to cross has no
/// partner.
Result<Influences> mirrored_weights(const Model& model, const SkinnedShape& shape, BodySide from);

}  // namespace sinew
