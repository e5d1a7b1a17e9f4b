#pragma once
/// What explains a character, drawn over its picture: bones and joints, muscles, its box, the world's axes. Everything
/// is seen through the character. Line widths, dots and letters grow with the picture's height.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/deform/muscle_region.h"
#include "engine/render/face_overlay.h"
#include "engine/render/text.h"
#include "engine/render/viewpoint.h"

namespace sinew {

enum class BoneShape { diamond, line };

/// Bones run from each joint to the nearest joint above it; nodes between that are no joints are passed over.
struct SkeletonOverlay {
  std::vector<Mat4> global;        ///< [nodes] global transforms, world space
  std::vector<int> parents;        ///< [nodes] -1: a root
  std::vector<bool> joints;        ///< [nodes] which nodes are joints
  std::vector<std::string> names;  ///< [nodes], or empty: no names are shown
  BoneShape shape = BoneShape::diamond;

  /// Says which list is short or which parent does not exist.
  Result<void> validate() const;
};

/// A muscle in one pose, world space.
struct MuscleOverlay {
  std::string name;
  double activation = 0.0;       ///< 0 at rest, 1 at the reference angle
  std::array<Vec3, 4> plane{};   ///< corners of the projection plane's part that is shown
  Vec3 centre{0.0};              ///< of the region, on the plane
  Vec3 along{0.0}, across{0.0};  ///< from the centre to one sigma along the limb and across it
  Vec3 normal{0.0};              ///< the plane's, unit length
  std::vector<Vec3> points;      ///< the region's vertices
  std::vector<Vec3> normals;     ///< [points] unit length, or empty
  std::vector<Vec3> feet;        ///< [points] on the plane, or empty
  bool gaussian = true;          ///< shows the plane, the centre and the ellipses of one and two sigmas
  bool arrows = false;           ///< shows normals as arrows instead of the vertices as dots
  bool projection = false;       ///< shows the plane, the centre and the way from each point to its foot
};

/// Takes a muscle's plane and region from rest space into a pose. `rest_to_world` is what carries the muscle's bone:
/// its global transform, placed in the world, times the inverse of its rest global transform. `positions` and `normals`
/// are those of the deformed mesh, world space.
MuscleOverlay posed_muscle(const Muscle& muscle, const MuscleRegion& region, const Mat4& rest_to_world,
                           std::span<const Vec3> positions, std::span<const Vec3> normals, double activation);

/// All that is to be drawn over one picture.
struct OverlayContent {
  std::vector<SkeletonOverlay> skeletons;
  std::vector<MuscleOverlay> muscles;
  std::vector<FaceOverlay> faces;
  std::optional<Bounds> box;  ///< with the lengths of its sides
  bool axes = false;          ///< the world's axes in the lower left corner
};

/// Draws over a picture that was taken from this viewpoint. `font` may be null: then there are no labels. Labels keep
/// clear of each other; one for which there is no room is left out. Fails as bad_input where a skeleton is not valid.
Result<void> draw_overlay(Picture& picture, const Font* font, const Viewpoint& viewpoint,
                          const OverlayContent& content);

}  // namespace sinew
