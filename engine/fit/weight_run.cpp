#include "engine/fit/weight_run.h"

#include <algorithm>

#include "engine/fit/vertex_fit.h"

namespace sinew {

std::vector<Influence> weight_run(std::vector<Influence> weights, std::size_t influences, double least) {
  std::sort(weights.begin(), weights.end(), [](const Influence& a, const Influence& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
  });
  std::size_t kept = 0;
  double sum = 0.0;
  while (kept < std::min(weights.size(), influences) && (kept == 0 || weights[kept].weight >= least))
    sum += weights[kept++].weight;
  weights.resize(kept);
  for (Influence& influence : weights) influence.weight /= sum;
  return weights;
}

std::vector<Influence> weight_run(const Support& support) {
  std::vector<Influence> weights;
  for (std::size_t i = 0; i < support.size; ++i) weights.push_back({support.bone[i], support.weight[i]});
  return weight_run(std::move(weights));
}

void Mixture::add(std::span<const Influence> influences, double share) {
  for (const Influence& influence : influences) weights_[influence.joint] += share * influence.weight;
}

std::vector<Influence> Mixture::list() const {
  std::vector<Influence> out;
  for (const auto& [joint, weight] : weights_)
    if (weight > 0.0) out.push_back({joint, weight});
  return out;
}

Influences gathered(std::span<const std::vector<Influence>> runs) {
  Influences out;
  for (const std::vector<Influence>& run : runs) out.add_vertex(run);
  return out;
}

std::span<const Influence> influences_of(const Influences& influences, std::size_t v) {
  return std::span(influences.entries).subspan(influences.first[v], influences.first[v + 1] - influences.first[v]);
}

std::size_t most_influences(const Influences& influences) {
  std::size_t most = 0;
  for (std::size_t v = 0; v < influences.vertices(); ++v) most = std::max(most, influences_of(influences, v).size());
  return most;
}

}  // namespace sinew
