#pragma once
/// Any mesh made ready to be given a face: in the drawing space of the head from drawing rules, its seams closed, its
/// pieces told apart.

#include <array>
#include <memory>
#include <vector>

#include "engine/face/landmarks.h"
#include "engine/face/similarity.h"
#include "engine/face/triangle_tree.h"
#include "engine/fit/surface_graph.h"
#include "engine/model/character_mesh.h"

namespace sinew {

/// What a connected piece of the mesh is to the face.
enum class ShellKind : std::uint8_t {
  other,     ///< not of the face: hair, hat, body
  skin,      ///< the piece that the landmarks lie on
  eyeball,   ///< turns with the gaze
  attached,  ///< rides on the skin: brows, lashes
  upper,     ///< inside the mouth, stays
  lower      ///< inside the mouth, goes with the jaw
};

struct FaceMesh {
  std::vector<Vec3> positions;                ///< [places] drawing units, template's axes
  std::vector<Vec3> normals;                  ///< [places] unit length
  std::vector<std::uint32_t> triangles;       ///< of places, three each
  std::vector<std::uint32_t> place_of;        ///< [vertices of the character's mesh]
  SurfaceGraph graph;                         ///< lips that touch are not joined
  std::vector<ShellKind> kinds;               ///< [shells]
  std::vector<int> eye_of_shell;              ///< [shells] of eyeballs: 0 left, 1 right; else -1
  std::vector<std::uint32_t> skin_triangles;  ///< of places
  Landmarks marks;                            ///< drawing units
  Similarity to_mesh;                         ///< from drawing units to the character's mesh
  std::array<Vec3, 2> eye_centres{};
  double eye_radius = 0.0;
  std::array<bool, 2> has_eyeball{};

  ShellKind kind(std::size_t place) const { return kinds[graph.shell[place]]; }
};

/// `landmarks`: in the space of `mesh.positions`. `head_marks`: the template's own, for alignment. Fails as bad_input,
/// `name` first, where the landmarks make no face: two at one place, all in a line, left and right exchanged, far off.
Result<FaceMesh> face_mesh(const CharacterMesh& mesh, const Landmarks& landmarks, const Landmarks& head_marks,
                           const std::string& name);

/// Landmarks of a mesh's file as places of `mesh.positions`. Fails as bad_input where a vertex number is beyond the
/// mesh, a place is far from it, or the mesh has no triangles.
Result<Landmarks> placed_landmarks(const CharacterMesh& mesh, const LandmarkPlaces& places, const std::string& name);

}  // namespace sinew
