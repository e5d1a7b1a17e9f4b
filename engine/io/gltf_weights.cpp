#include "engine/io/gltf_weights.h"

#include <algorithm>
#include <cmath>

#include "engine/io/gltf_access.h"

namespace sinew::gltf {
namespace {

/// Below this a sum is taken as 1 without a word: floats round, and so do exporters that write a few digits.
constexpr double sum_tolerance = 1e-3;

struct WeightSet {
  Numbers joints, weights;
};

/// What had to be done to a primitive's weights.
struct Repairs {
  std::size_t unnormalised = 0, cut = 0, merged = 0, negative = 0, unweighted = 0;
  double worst_sum = 1.0;  ///< the sum furthest from 1
  double worst_cut = 0.0;  ///< the greatest share of a vertex's weights that was left out
};

void report(Document& document, const std::string& place, const Repairs& repairs) {
  if (repairs.unnormalised > 0)
    document.problem("{}: {} vertices' weights did not sum to 1 (worst {:.3g}); normalised", place,
                     repairs.unnormalised, repairs.worst_sum);
  if (repairs.cut > 0)
    document.problem("{}: {} vertices had more than {} joints; the strongest are kept (worst weight dropped {:.3g})",
                     place, repairs.cut, max_influences, repairs.worst_cut);
  if (repairs.merged > 0)
    document.problem("{}: {} vertices name a joint twice; its weights are added up", place, repairs.merged);
  if (repairs.negative > 0)
    document.problem("{}: {} vertices have negative weights; taken as 0", place, repairs.negative);
  if (repairs.unweighted > 0)
    document.problem("{}: {} vertices have no weights; they follow the mesh's node", place, repairs.unweighted);
}

bool is_set_of(const std::string& name, std::string_view prefix) {
  return name.size() > prefix.size() && name.starts_with(prefix) &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(prefix.size()), name.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

Result<WeightSet> read_set(Document& document, int joints, int weights, const std::string& number,
                           const std::string& place) {
  constexpr int joint_types[] = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};
  constexpr int weight_types[] = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                  TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};
  auto joint = read_accessor(document, joints, fmt::format("{}/attributes/JOINTS_{}", place, number),
                             {TINYGLTF_TYPE_VEC4, joint_types, "VEC4 of unsigned bytes or shorts"});
  if (!joint) return pass_on(std::move(joint));
  auto weight =
      read_accessor(document, weights, fmt::format("{}/attributes/WEIGHTS_{}", place, number),
                    {TINYGLTF_TYPE_VEC4, weight_types, "VEC4 of floats, or of normalized unsigned bytes or shorts"});
  if (!weight) return pass_on(std::move(weight));
  if (document.gltf.accessors[static_cast<std::size_t>(joints)].normalized)
    return bad_input("{}/attributes/JOINTS_{}: joint numbers must not be normalized", place, number);
  return WeightSet{std::move(*joint), std::move(*weight)};
}

Result<std::vector<WeightSet>> read_sets(Document& document, const std::map<std::string, int>& attributes,
                                         const std::string& place) {
  std::vector<WeightSet> sets;
  for (const auto& [name, accessor] : attributes) {
    if (is_set_of(name, "WEIGHTS_") && !attributes.contains("JOINTS_" + name.substr(8)))
      document.problem("{}: has {} but no JOINTS_{}; ignored", place, name, name.substr(8));
    if (!is_set_of(name, "JOINTS_")) continue;
    const std::string number = name.substr(7);
    const auto weights = attributes.find("WEIGHTS_" + number);
    if (weights == attributes.end()) {
      document.problem("{}: has {} but no WEIGHTS_{}; ignored", place, name, number);
      continue;
    }
    auto set = read_set(document, accessor, weights->second, number, place);
    if (!set) return pass_on(std::move(set));
    sets.push_back(std::move(*set));
  }
  return sets;
}

/// The file's non-zero weights of one vertex. False where one is no number.
bool collect(const std::vector<WeightSet>& sets, std::size_t vertex, std::vector<Influence>& run, Repairs& repairs) {
  run.clear();
  bool negative = false;
  for (const WeightSet& set : sets) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double weight = set.weights.at(vertex)[i];
      if (!std::isfinite(weight)) return false;
      negative = negative || weight < 0.0;
      if (weight > 0.0) run.push_back({static_cast<std::uint32_t>(set.joints.at(vertex)[i]), weight});
    }
  }
  repairs.negative += negative ? 1 : 0;
  return true;
}

void merge_joints(std::vector<Influence>& run, Repairs& repairs) {
  std::ranges::stable_sort(run, {}, &Influence::joint);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    if (kept > 0 && run[kept - 1].joint == run[i].joint)
      run[kept - 1].weight += run[i].weight;
    else
      run[kept++] = run[i];
  }
  repairs.merged += kept < run.size() ? 1 : 0;
  run.resize(kept);
}

double sum_of(const std::vector<Influence>& run) {
  double sum = 0.0;
  for (const Influence& influence : run) sum += influence.weight;
  return sum;
}

/// Strongest first, at most max_influences, sum 1.
void order_and_normalise(std::vector<Influence>& run, Repairs& repairs) {
  const double whole = sum_of(run);
  if (std::abs(whole - 1.0) > sum_tolerance) {
    ++repairs.unnormalised;
    if (std::abs(whole - 1.0) > std::abs(repairs.worst_sum - 1.0)) repairs.worst_sum = whole;
  }
  // Sorted by joint before, so that equal weights stay in the order of the joint list.
  std::ranges::stable_sort(run, std::ranges::greater{}, &Influence::weight);
  if (run.size() > max_influences) {
    run.resize(max_influences);
    ++repairs.cut;
    repairs.worst_cut = std::max(repairs.worst_cut, 1.0 - sum_of(run) / whole);
  }
  const double sum = sum_of(run);
  for (Influence& influence : run) influence.weight /= sum;
  // Float weights can be so unequal that the least of them vanishes against the sum.
  while (!run.empty() && run.back().weight <= 0.0) run.pop_back();
}

}  // namespace

Result<Influences> read_influences(Document& document, const std::map<std::string, int>& attributes,
                                   const std::string& place, std::size_t vertices) {
  auto sets = read_sets(document, attributes, place);
  if (!sets) return pass_on(std::move(sets));
  Influences influences;
  if (sets->empty()) return influences;
  Repairs repairs;
  std::vector<Influence> run;
  for (std::size_t v = 0; v < vertices; ++v) {
    if (!collect(*sets, v, run, repairs)) return bad_input("{}: a weight of vertex {} is not finite", place, v);
    merge_joints(run, repairs);
    repairs.unweighted += run.empty() ? 1 : 0;
    if (!run.empty()) order_and_normalise(run, repairs);
    influences.add_vertex(run);
  }
  report(document, place, repairs);
  return influences;
}

}  // namespace sinew::gltf
