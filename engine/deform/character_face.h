#pragma once
/// A character's face carried out on its bind pose.

#include <span>

#include "engine/deform/face.h"

namespace sinew {

/// Moves the bind pose as the regions say, in place. Vertices that take part in nothing keep their place to the bit.
/// A tangent turns with jaw, lid or gaze; what the deltas bend it by is left to its plane (skin_output.h).
struct CharacterFaceJob {
  const CharacterFace& face;
  const FaceState& state;
  std::span<Vec3> positions;  ///< [vertices] bind pose, morphs added; in and out
  std::span<Vec3> normals;    ///< [vertices] likewise; unit length out
  std::span<Vec4> tangents;   ///< [vertices] w: side of the bitangent, which is kept; or empty

  /// Says which span is short.
  Result<void> validate() const;
  void run() const;
};

}  // namespace sinew
