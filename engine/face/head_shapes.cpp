#include "engine/face/head_shapes.h"

#include "engine/core/parallel.h"
#include "engine/face/expression.h"

namespace sinew {

HeadShape posed_head(const Head& head, const FaceChannels& channels) {
  const FaceState state = face_state(head.face, channels);
  HeadShape out{"", head.positions, head.normals};
  FaceJob{head.face, state, head.positions, head.normals, out.positions, out.normals}.run();
  const std::vector<Vec3> of_surface = head_normals(head, out.positions);
  for (std::size_t v = 0; v < out.normals.size(); ++v) {
    // What only turns has turned normals already, exactly.
    const bool bends = v < head.skin_vertices || head.face.first[v + 1] > head.face.first[v];
    // Where nothing moves, nothing turns: the rest normals are symmetric to the bit, these sums are not.
    if (bends) out.normals[v] = glm::distance(of_surface[v], head.normals[v]) < 1e-9 ? head.normals[v] : of_surface[v];
  }
  return out;
}

std::vector<HeadShape> head_shapes(const Head& head, bool strict) {
  const std::vector<ShapeRecipe> all = shape_recipes(head.face, strict);
  const HeadShape rest{"", head.positions, head.normals};
  std::vector<HeadShape> out(all.size());
  parallel_for(
      all.size(),
      [&](std::size_t i) {
        out[i] = shape_of(head.face, rest, all[i], [&](const FaceChannels& c) { return posed_head(head, c); });
      },
      1);
  return out;
}

}  // namespace sinew
