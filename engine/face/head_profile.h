#pragma once
/// A head's outline from the side, and what of a face can be read from it.

#include <optional>
#include <vector>

#include "engine/face/triangle_tree.h"

namespace sinew {

/// Places in the head's own axes: x left, y up, z front.
struct HeadProfile {
  double middle = 0.0;  ///< x of the plane of symmetry
  Vec3 crown{0.0}, chin{0.0}, nose_tip{0.0}, nose_base{0.0}, lip_contact{0.0};
  bool has_nose = false, has_lips = false;
};

/// `skin`: triangles of the head's skin. Nothing where no line over the front of a head is found.
std::optional<HeadProfile> find_profile(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& skin,
                                        const TriangleTree& tree);

/// Where the groove between the lips ends; side 1 left, -1 right. `reach`: where it is expected from the middle.
/// `unit`: a drawing unit.
std::optional<Vec3> find_lip_corner(const TriangleTree& tree, const HeadProfile& profile, int side, double reach,
                                    double unit);

}  // namespace sinew
