#pragma once
/// One vertex's weights as files and deformers take them.

#include <map>
#include <span>
#include <vector>

#include "engine/model/model.h"

namespace sinew {

struct Support;

/// Less than this is lost when weights are stored as floats that sum to 1.
constexpr double least_weight = 1e-7;

/// The at most `influences` largest weights, none under `least`, made to sum to 1, in the order that Influences asks
/// for; the largest alone where none reaches `least`. Weights may stand in any order and sum to anything above 0.
std::vector<Influence> weight_run(std::vector<Influence> weights, std::size_t influences = ~std::size_t{0},
                                  double least = least_weight);
std::vector<Influence> weight_run(const Support& support);

/// Weights of several vertices, summed up.
class Mixture {
 public:
  void add(std::span<const Influence> influences, double share);
  std::vector<Influence> list() const;  ///< those above 0

 private:
  std::map<std::uint32_t, double> weights_;
};

/// One run a vertex, as Influences.
Influences gathered(std::span<const std::vector<Influence>> runs);

/// The influences of vertex `v`.
std::span<const Influence> influences_of(const Influences& influences, std::size_t v);

/// The most influences that any vertex has.
std::size_t most_influences(const Influences& influences);

}  // namespace sinew
