#include "engine/fit/skin_fit.h"

#include <algorithm>
#include <atomic>

#include <tbb/enumerable_thread_specific.h>

#include "engine/core/interrupt.h"
#include "engine/core/parallel.h"
#include "engine/fit/weight_run.h"
#include "engine/fit/weight_smoothing.h"

namespace sinew {
namespace {

constexpr std::size_t block = 2048;  ///< vertices between two looks for a signal
constexpr int smoothing_rounds = 4;

/// A bone leaves whose absence costs less than this many variances of noise: Akaike's criterion, 2 for a free weight.
constexpr double worth_a_bone = 2.0;

bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Goes over all vertices in parallel, a block at a time, each thread with a VertexFit of its own.
class Sweep {
 public:
  explicit Sweep(const SkinFitJob& job) : job_(job), fits_([&job] { return VertexFit(job.bones); }) {}

  template <class Body>
  Result<void> over_vertices(const Body& body) {
    for (std::size_t begin = 0; begin < job_.rest.size(); begin += block) {
      if (auto ok = check_interrupt(); !ok) return ok;
      parallel_for(
          std::min(block, job_.rest.size() - begin),
          [&](std::size_t i) {
            VertexFit& fit = fits_.local();
            const std::size_t v = begin + i;
            fit.begin(job_.rest[v], job_.posed.subspan(v * job_.bones.poses, job_.bones.poses));
            body(v, fit);
          },
          32);
      job_.advance();
    }
    return {};
  }

 private:
  const SkinFitJob& job_;
  tbb::enumerable_thread_specific<VertexFit> fits_;
};

Result<std::vector<Support>> fitted_convex(const SkinFitJob& job, const SurfaceGraph& graph, Sweep& sweep,
                                           double& variance) {
  std::vector<Support> own(job.rest.size());
  auto ok = sweep.over_vertices([&](std::size_t v, VertexFit& fit) { own[v] = fit.convex(job.influences); });
  if (!ok) return pass_on(std::move(ok));
  variance = noise_variance(own, job.bones.poses);
  ok = sweep.over_vertices([&](std::size_t v, VertexFit& fit) { fit.prune(own[v], worth_a_bone * variance); });
  if (!ok) return pass_on(std::move(ok));
  std::vector<Support> current = own, next = own;
  for (int round = 0; round < smoothing_rounds; ++round) {
    ok = sweep.over_vertices([&](std::size_t v, VertexFit& fit) {
      next[v] = smoothed(fit, own[v], graph.of(v), current, variance, job.influences);
    });
    if (!ok) return pass_on(std::move(ok));
    std::swap(current, next);
  }
  return current;
}

Result<std::vector<Support>> fitted_paper(const SkinFitJob& job, Sweep& sweep, std::size_t& negative) {
  std::vector<Support> fitted(job.rest.size());
  auto ok = sweep.over_vertices([&](std::size_t v, VertexFit& fit) { fitted[v] = fit.paper(job.influences); });
  if (!ok) return pass_on(std::move(ok));
  for (const Support& support : fitted)
    negative += std::any_of(support.weight.begin(), support.weight.begin() + support.size,
                            [](double weight) { return weight < -1e-9; });
  return fitted;
}

}  // namespace

Result<void> SkinFitJob::validate() const {
  if (bones.bones == 0) return bad_input("there is no bone to follow; expected a skeleton");
  if (bones.transforms.size() != bones.bones * bones.poses)
    return bad_input("{} transforms of bones; expected {} bones in {} poses", bones.transforms.size(), bones.bones,
                     bones.poses);
  if (influences < 1 || influences > max_influences)
    return bad_input("{} influences a vertex; expected 1 to {}", influences, max_influences);
  if (3 * bones.poses + 1 < std::min(influences, bones.bones))
    return bad_input("{} poses are too few for {} influences a vertex; expected {} or more", bones.poses, influences,
                     (std::min(influences, bones.bones) + 1) / 3);
  if (bones.poses == 0) return bad_input("there is no example pose; expected one or more");
  if (posed.size() != rest.size() * bones.poses)
    return bad_input("{} posed vertices; expected {} vertices in {} poses", posed.size(), rest.size(), bones.poses);
  for (const std::uint32_t index : triangles)
    if (index >= rest.size()) return bad_input("a triangle names vertex {} of {}", index, rest.size());
  for (std::size_t v = 0; v < rest.size(); ++v)
    if (!finite(rest[v])) return bad_input("vertex {}: its rest position is not a finite number", v);
  for (std::size_t i = 0; i < posed.size(); ++i)
    if (!finite(posed[i]))
      return bad_input("pose {}, vertex {}: its position is not a finite number", i % bones.poses, i / bones.poses);
  return {};
}

std::size_t SkinFitJob::steps() const {
  return (rest.size() + block - 1) / block * (method == FitMethod::paper ? 2 : 3 + smoothing_rounds);
}

Result<Influences> SkinFitJob::run(SkinFitReport& report) const {
  const SurfaceGraph graph = surface_graph(rest, triangles);
  report.shell = graph.shell;
  report.shells = graph.shells;
  Sweep sweep(*this);
  double variance = 0.0;
  auto fitted = method == FitMethod::paper ? fitted_paper(*this, sweep, report.negative)
                                           : fitted_convex(*this, graph, sweep, variance);
  if (!fitted) return pass_on(std::move(fitted));
  report.noise = std::sqrt(variance);
  std::atomic<std::size_t> open = 0;
  auto ok = sweep.over_vertices([&](std::size_t v, VertexFit& fit) { open += fit.undetermined((*fitted)[v]); });
  if (!ok) return pass_on(std::move(ok));
  report.undetermined = open;
  Influences influences;
  for (const Support& support : *fitted) influences.add_vertex(weight_run(support));
  return influences;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> bones_moved_alike(const BonePoses& bones, const Bounds& rest) {
  const double allowed = 1e-9 * rest.diagonal();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t b = 1; b < bones.bones; ++b)
    for (std::uint32_t a = 0; a < b; ++a) {
      bool alike = true;
      for (std::size_t k = 0; k < bones.poses && alike; ++k)
        for (int corner = 0; corner < 8 && alike; ++corner) {
          const Vec3 p = rest.corner(corner);
          alike = glm::length(bones.at(a, k).transform_point(p) - bones.at(b, k).transform_point(p)) <= allowed;
        }
      if (!alike) continue;
      pairs.emplace_back(b, a);
      break;
    }
  return pairs;
}

}  // namespace sinew
