#include "engine/deform/morph.h"

#include "engine/core/parallel.h"

namespace sinew {

MorphedVertices morph(const CharacterMesh& mesh, std::span<const double> weights) {
  MorphedVertices result{mesh.positions, mesh.normals};
  if (mesh.morph_deltas.empty()) return result;
  parallel_for(mesh.vertices(), [&](std::size_t v) {
    for (std::uint32_t i = mesh.morph_first[v]; i < mesh.morph_first[v + 1]; ++i) {
      const MorphDelta& delta = mesh.morph_deltas[i];
      result.positions[v] += weights[delta.slot] * delta.position;
      result.normals[v] += weights[delta.slot] * delta.normal;
    }
  });
  return result;
}

}  // namespace sinew
