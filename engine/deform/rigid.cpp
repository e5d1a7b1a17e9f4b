#include "engine/deform/rigid.h"

#include "engine/core/parallel.h"

namespace sinew {

void RigidJob::run() const {
  const Influences& influences = input.influences;
  parallel_for(input.positions.size(), [&](std::size_t v) {
    const Mat34& bone = input.palette[influences.entries[influences.first[v]].joint];
    output.positions[v] = bone.transform_point(input.positions[v]);
    output.normals[v] = carry_normal(bone.linear(), input.normals[v]);
    if (!output.blend.empty()) output.blend[v] = bone.linear();
  });
}

}  // namespace sinew
