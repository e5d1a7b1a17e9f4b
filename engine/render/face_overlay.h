#pragma once
/// What explains a face: the lines that its head is drawn by, and its regions with their pivots and limits.
/// engine/definitions.md 15; Yen 1990, 4.1 and 5.3.

#include <span>
#include <string>
#include <vector>

#include "engine/model/character_mesh.h"
#include "engine/model/scene.h"

namespace sinew {

/// A short piece of a line on a surface, world space.
struct SurfaceCut {
  Vec3 from{0.0}, to{0.0};
  Vec3 normal{0.0};  ///< of the surface there, unit length
};

struct FaceGuideLine {
  std::string name;  ///< empty: no label
  std::vector<SurfaceCut> cuts;
};

struct FaceRegionOverlay {
  std::string name;
  Colour colour;
  std::vector<std::array<Vec3, 3>> area;    ///< triangles that the region moves by half of its way or more
  std::vector<SurfaceCut> outline;          ///< of the area
  std::vector<std::vector<Vec3>> limits;    ///< closed lines: how far its points may go
  std::vector<Vec3> pivots;                 ///< that it turns about
  std::vector<std::array<Vec3, 2>> hinges;  ///< lines that it turns about
  Vec3 anchor{0.0};                         ///< where its label points
};

/// A face in one pose, world space.
struct FaceOverlay {
  std::vector<FaceGuideLine> guides;
  std::vector<FaceRegionOverlay> regions;
};

/// `mesh`: at rest, with a face; `positions` and `blend` ([vertices] the 3x3 of the blended matrix) as deformed, world
/// space. What floats before the face, limits and pivots, moves with the skin between the eyes.
FaceOverlay posed_face(const CharacterMesh& mesh, std::span<const Vec3> positions, std::span<const Mat3> blend,
                       bool guides, bool regions);

}  // namespace sinew
