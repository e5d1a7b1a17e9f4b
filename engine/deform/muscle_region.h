#pragma once
/// Which vertices a muscle swells, and where they lie on its projection plane. engine/definitions.md 3 and 6.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/deform/rest_shape.h"
#include "engine/model/muscle.h"

namespace sinew {

/// The projection plane's axes: it contains the limb and its normal is the side that the belly faces.
struct ProjectionPlane {
  Vec3 bone{0.0};    ///< rest position of the bone's joint
  Vec3 child{0.0};   ///< rest position of the child's joint; the plane passes through it
  Vec3 axis{0.0};    ///< a: unit, from bone to child
  Vec3 normal{0.0};  ///< n_p: unit, `facing` with its part along the axis removed
  Vec3 side{0.0};    ///< s = n_p x a
  double length = 0.0;
};

/// One vertex of a muscle's region.
struct RegionVertex {
  std::uint32_t vertex = 0;
  double x = 0.0;      ///< from the centre along the limb, world units
  double y = 0.0;      ///< from the centre across the limb
  double t = 0.0;      ///< along the bone: 0 at the bone's joint, 1 at the child's
  double angle = 0.0;  ///< degrees between the normal (its part along the axis removed) and the plane's normal
  double share = 0.0;  ///< sum of the vertex's weights on the segment's joints
};

struct MuscleRegion {
  ProjectionPlane plane;
  Vec3 centre{0.0};                    ///< rest space, on the plane
  std::vector<RegionVertex> vertices;  ///< in the order of the mesh
  std::size_t segment_vertices = 0;    ///< vertices of the whole limb segment
};

/// [nodes] true for the bone and every node below it that is neither `child` nor one of `except` nor below these: split
/// and twist joints belong to a segment.
std::vector<bool> segment_nodes(const Model& model, int bone, int child, std::span<const int> except = {});

/// The plane of a muscle. Needs bone, child and facing; fails where the joints coincide or the facing runs along the
/// limb.
Result<ProjectionPlane> projection_plane(const Muscle& muscle, std::span<const Mat4> rest_global);

/// Finds the segment and the region. Needs bone, child, except, facing, from, to and spread of the muscle.
Result<MuscleRegion> muscle_region(const Model& model, const CharacterMesh& mesh, const RestShape& rest,
                                   const Muscle& muscle);

/// r of engine/definitions.md 7: the mean distance to the limb's axis of the segment's vertices within 0.05 of the
/// region's centre along the bone; where there are none, of the nearest ones.
double limb_radius(const Model& model, const CharacterMesh& mesh, const RestShape& rest, const Muscle& muscle,
                   const MuscleRegion& region);

/// f of engine/definitions.md 6: what takes the Gaussian to zero towards the region's edge.
struct RegionFade {
  double value = 1.0;
  double slope = 0.0;  ///< its change with t, by the two end fades; the others are held
};

RegionFade region_fade(const Muscle& muscle, const RegionVertex& v);

}  // namespace sinew
