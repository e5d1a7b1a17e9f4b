#pragma once
/// A human left arm that needs no file: the character that is shown when none was asked for.

#include "engine/model/model.h"

namespace sinew {

/// Measures of the arm, metres; the defaults are an athletic adult's. Each is positive.
struct ArmShape {
  double upper_arm_length = 0.30;  ///< shoulder to elbow
  double lower_arm_length = 0.26;  ///< elbow to wrist
  double hand_length = 0.19;       ///< wrist to the tip of the middle finger; the hand grows with it in all directions
  double thickness = 1.0;          ///< of the arm from shoulder to wrist, as a multiple of the default
  Vec4 base_colour{0.60, 0.36, 0.26, 1.0};  ///< linear RGBA
};

/// The arm stretched along +X, thumb side up (+Y), palm and the elbow's flexor side to the front (+Z), the shoulder
/// joint at the origin; the hand is relaxed, the shoulder cut off by a plane as in a sculpture's fragment. One closed
/// mesh without seams, counter-clockwise seen from outside, with smooth normals and no texture coordinates. Joints,
/// each the parent of the next: leftShoulder, leftUpperArm, leftLowerArm, leftHand, leftHandTip (the last has no
/// weights; it gives the hand a direction). The rest pose is the bind pose and no joint is turned in it. Flexing the
/// elbow turns leftLowerArm about Y by a negative angle.
Model make_arm(const ArmShape& shape = {});

}  // namespace sinew
