#pragma once
/// A model's drawn meshes as one run of vertices, ready to be deformed.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/math.h"
#include "engine/core/result.h"
#include "engine/model/face.h"
#include "engine/model/model.h"

namespace sinew {

/// Where a palette matrix comes from: F = global transform of `node` times `inverse_bind`.
struct PaletteSource {
  int node = -1;
  Mat4 inverse_bind{1.0};
};

/// A morph target of one drawn mesh; its weight is part of the pose.
struct MorphSlot {
  int node = -1;           ///< the node that draws the mesh
  std::size_t target = 0;  ///< index into that mesh's morph targets
};

/// What one morph target adds to one vertex at weight 1, bind pose.
struct MorphDelta {
  std::uint32_t slot = 0;
  Vec3 position{0.0};
  Vec3 normal{0.0};
};

/// A run of triangles that share a material, from one primitive of one drawn mesh.
struct MeshPart {
  std::string mesh;  ///< the mesh's name
  int node = -1;     ///< the node that draws it
  int material = -1;
  std::uint32_t first_vertex = 0, vertex_count = 0;
  std::uint32_t first_index = 0, index_count = 0;
  bool mirrored = false;  ///< the rest pose turns its triangles inside out (a negative scale)
};

/// Every vertex of every triangle primitive once, in the order that `export` writes them: nodes depth first,
/// children in order, primitives in order, a primitive's vertices as the file has them. A mesh that two nodes draw
/// stands twice.
struct CharacterMesh {
  std::vector<Vec3> positions;  ///< [vertices] bind pose
  std::vector<Vec3> normals;    ///< [vertices] bind pose, unit length
  std::vector<Vec4> tangents;   ///< [vertices] bind pose, w: side of the bitangent; or empty: no normal texture
  std::vector<Vec2> texture_coordinates;         ///< [vertices], zeros where a primitive has none
  std::vector<Vec2> second_texture_coordinates;  ///< [vertices], or empty: no primitive has any
  std::vector<Vec4> colours;             ///< [vertices] white where a primitive has none; or empty: none has any
  Influences influences;                 ///< [vertices] joints are palette indices; no run is empty
  std::vector<std::uint32_t> triangles;  ///< three vertex indices a triangle
  std::vector<MeshPart> parts;
  std::vector<PaletteSource> palette;
  std::vector<MorphSlot> morph_slots;
  std::vector<std::uint32_t> morph_first;  ///< [vertices + 1] where each vertex's run starts in `morph_deltas`
  std::vector<MorphDelta> morph_deltas;
  std::optional<CharacterFace> face;  ///< moved by regions, after morph targets and before the skin; absent: none

  std::size_t vertices() const { return positions.size(); }
  /// The node that vertex `v` follows most: its bone in the sense of engine/definitions.md 6.
  int bone(std::size_t v) const { return palette[influences.entries[influences.first[v]].joint].node; }
};

/// Gathers what the model's scene draws.
CharacterMesh character_mesh(const Model& model);

/// A small file can draw one large mesh from many nodes; more vertices than this are not gathered.
constexpr std::size_t most_drawn_vertices = 8'000'000;

/// Fails as bad_input where the model's scene draws more than most_drawn_vertices.
Result<void> check_drawn_vertices(const Model& model);

/// Nodes so that a parent comes before its children, in scene order; nodes outside the scene follow.
std::vector<int> hierarchy_order(const Model& model);

}  // namespace sinew
