#pragma once
/// A muscle with every number resolved: engine/definitions.md 6.

#include <string>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

struct Muscle {
  std::string name;
  int bone = -1;                  ///< node whose segment carries the belly
  int child = -1;                 ///< node at the segment's far end
  int driver = -1;                ///< node whose bending swells it
  int before = -1;                ///< node that the driver's angle is measured from
  int tip = -1;                   ///< node beyond the driver that its angle is measured to
  std::vector<int> except;        ///< nodes below `bone` that are not the segment's, with all below them
  Vec3 facing{0.0};               ///< rest-space direction that the belly faces
  double from = 0.0, to = 1.0;    ///< the region along the bone: 0 at `bone`, 1 at `child`
  double spread = 90.0;           ///< degrees round the limb to either side of `facing`
  double peak = 0.0;              ///< height at the centre when the driver stands at the reference angle, world units
  Vec2 sigma{1.0};                ///< along and across the limb, world units
  double rest_angle = 180.0;      ///< degrees at the driver where nothing swells
  double reference_angle = 90.0;  ///< degrees at the driver where the peak is reached
  bool on = true;                 ///< false: it is there, but never swells
};

/// How the bulge is applied: not at all; fading to zero at the region's edge; or as the paper has it, with its step.
enum class BulgeMode { off, on, paper };

/// How vertices follow the joints.
enum class Deformer { rigid, ssd };

}  // namespace sinew
