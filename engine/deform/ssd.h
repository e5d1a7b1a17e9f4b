#pragma once
#include "engine/deform/skin_output.h"

namespace sinew {

/// Skeletal subspace deformation, also called linear blend skinning: v' = (sum w_i F_i) v.  engine/definitions.md 2;
/// Magnenat-Thalmann et al. 1988; Lewis et al. 2000.
struct SsdJob {
  SkinInput input;
  SkinOutput output;

  Result<void> validate() const { return validate_skinning(input, output); }
  void run() const;
};

}  // namespace sinew
