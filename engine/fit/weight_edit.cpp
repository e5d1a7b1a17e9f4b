#include "engine/fit/weight_edit.h"

#include <algorithm>
#include <set>

#include "engine/core/parallel.h"
#include "engine/fit/mirrored_weights.h"
#include "engine/fit/surface_graph.h"
#include "engine/fit/weight_run.h"

namespace sinew {
Influences smoothed_weights(const SkinnedShape& shape, const Influences& influences, int rounds) {
  const SurfaceGraph graph = surface_graph(shape.positions, shape.triangles);
  std::size_t places = 0;
  const std::vector<std::uint32_t> place = same_places(shape.positions, places);
  std::vector<std::vector<std::uint32_t>> at(places);
  for (std::uint32_t v = 0; v < place.size(); ++v) at[place[v]].push_back(v);
  Influences current = influences;
  for (int round = 0; round < rounds; ++round) {
    std::vector<std::vector<Influence>> next(place.size());
    parallel_for(
        places,
        [&](std::size_t p) {
          std::set<std::uint32_t> around;
          for (const std::uint32_t v : at[p])
            for (const std::uint32_t n : graph.of(v))
              if (place[n] != p) around.insert(place[n]);
          Mixture mixture;
          mixture.add(influences_of(current, at[p].front()), around.empty() ? 1.0 : 0.5);
          for (const std::uint32_t n : around)
            mixture.add(influences_of(current, at[n].front()), 0.5 / static_cast<double>(around.size()));
          const std::vector<Influence> run = mixture.list();
          for (const std::uint32_t v : at[p])
            if (!run.empty()) next[v] = weight_run(run);
        },
        256);
    current = gathered(next);
  }
  return current;
}

Influences limited_weights(const Influences& influences, std::size_t most, double least) {
  Influences out;
  for (std::size_t v = 0; v < influences.vertices(); ++v) {
    const auto run = influences_of(influences, v);
    out.add_vertex(run.empty() ? std::vector<Influence>{}
                               : weight_run({run.begin(), run.end()}, most, std::max(least, least_weight)));
  }
  return out;
}

Result<void> edit_weights(const WeightEdits& edits, Model& model) {
  const std::vector<SkinnedShape> shapes = skinned_shapes(model);
  if (shapes.empty()) return bad_input("{}: nothing in it is skinned; expected weights to change", model.file);
  for (SkinnedShape shape : shapes) {
    if (edits.smooth > 0) shape.influences = smoothed_weights(shape, shape.influences, edits.smooth);
    if (edits.mirror) {
      auto mirrored = mirrored_weights(model, shape, *edits.mirror);
      if (!mirrored) return pass_on(std::move(mirrored));
      shape.influences = std::move(*mirrored);
    }
    set_influences(shape, limited_weights(shape.influences, edits.influences, edits.prune), model);
  }
  return {};
}

}  // namespace sinew
