#pragma once

namespace sinew {

/// How the mesh's edges are shown.
enum class WireMode {
  none,
  visible,  ///< those that the surface hides are left out
  all,      ///< hidden ones are there too, fainter
};

}  // namespace sinew
