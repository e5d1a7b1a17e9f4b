#pragma once
/// The head from drawing rules bent onto another face, and which of its places each place of that face answers to.

#include <optional>
#include <vector>

#include "engine/face/face_mesh.h"
#include "engine/face/head.h"
#include "engine/face/radial_warp.h"

namespace sinew {

/// A place of the template's skin.
struct TemplatePlace {
  std::array<std::uint32_t, 3> vertices;
  Vec3 shares;      ///< sum 1
  double distance;  ///< from the place that it answers to, drawing units
  Mat3 slope;       ///< what becomes there of a small step on the template
};

struct TemplateFit {
  RadialWarp warp;
  std::vector<std::optional<TemplatePlace>> places;  ///< [mesh places]; nothing where no place faces alike
  std::vector<bool> near;  ///< [mesh places] the template's skin is near, whichever way it faces
};

/// The warp goes through the landmarks and, loosely, through places between them that were found nearest to the mesh.
/// Upper lips answer to upper lips and lower to lower, however near they lie.
TemplateFit fit_template(const Head& head, const FaceMesh& mesh);

}  // namespace sinew
