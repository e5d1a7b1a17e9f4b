#include "engine/deform/ssd.h"

#include "engine/core/parallel.h"

namespace sinew {

void SsdJob::run() const {
  const Influences& influences = input.influences;
  parallel_for(input.positions.size(), [&](std::size_t v) {
    Mat34 blend{{Vec4(0.0), Vec4(0.0), Vec4(0.0)}};
    for (std::uint32_t i = influences.first[v]; i < influences.first[v + 1]; ++i) {
      const Influence& influence = influences.entries[i];
      for (int row = 0; row < 3; ++row) blend.row[row] += influence.weight * input.palette[influence.joint].row[row];
    }
    output.positions[v] = blend.transform_point(input.positions[v]);
    output.normals[v] = carry_normal(blend.linear(), input.normals[v]);
    if (!output.blend.empty()) output.blend[v] = blend.linear();
  });
}

}  // namespace sinew
