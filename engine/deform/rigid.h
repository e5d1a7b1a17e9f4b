#pragma once
#include "engine/deform/skin_output.h"

namespace sinew {

/// Every vertex follows the one joint of its largest weight: v' = F_b v.  The paper's baseline, engine/definitions.md
/// 2: segments come apart at the joints.
struct RigidJob {
  SkinInput input;
  SkinOutput output;

  Result<void> validate() const { return validate_skinning(input, output); }
  void run() const;
};

}  // namespace sinew
