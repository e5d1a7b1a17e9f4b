#include "engine/face/skin_values.h"

#include <algorithm>

#include "engine/core/parallel.h"

namespace sinew {

SkinValues::SkinValues(const FaceRig& from, const TemplateFit& fit, const FaceMesh& mesh,
                       const std::function<double(std::size_t signal)>& scale)
    : mesh_(mesh), fit_(fit), values_(mesh.positions.size() * width, 0.0), roots_(mesh.positions) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!fit.places[v]) continue;
    const TemplatePlace& place = *fit.places[v];
    double* out = &values_[v * width];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t t = place.vertices[c];
      const double share = place.shares[static_cast<int>(c)];
      out[0] += share * from.vertices[t].jaw;
      out[1] += share * from.vertices[t].jaw_sealed;
      for (std::uint32_t d = from.first[t]; d < from.first[t + 1]; ++d) {
        const std::size_t signal = from.deltas[d].signal;
        const Vec3 move = share / scale(signal) * (place.slope * from.deltas[d].position);
        for (int k = 0; k < 3; ++k) out[2 + 3 * signal + static_cast<std::size_t>(k)] += move[k];
      }
    }
  }
}

void SkinValues::relax(const std::vector<std::uint32_t>& places, const std::vector<double>& shares, int rounds) {
  std::vector<double> next(places.size() * width);
  for (int round = 0; round < rounds; ++round) {
    parallel_for(
        places.size(),
        [&](std::size_t i) {
          const auto neighbours = mesh_.graph.of(places[i]);
          const double* own = &values_[places[i] * width];
          double* out = &next[i * width];
          std::copy(own, own + width, out);
          if (neighbours.empty()) return;
          const double part = shares[i] / static_cast<double>(neighbours.size());
          for (std::size_t k = 0; k < width; ++k) out[k] *= 1.0 - shares[i];
          for (const std::uint32_t n : neighbours)
            for (std::size_t k = 0; k < width; ++k) out[k] += part * values_[n * width + k];
        },
        64);
    for (std::size_t i = 0; i < places.size(); ++i) std::copy_n(&next[i * width], width, &values_[places[i] * width]);
  }
}

void SkinValues::fill() {
  constexpr int fill_rounds = 120, smooth_rounds = 4;
  constexpr double whole_smoothing = 0.10;  // drawing units off
  std::vector<std::uint32_t> unknown, off;
  std::vector<double> off_shares;
  for (std::uint32_t v = 0; v < mesh_.positions.size(); ++v) {
    if (mesh_.kind(v) != ShellKind::skin || !fit_.near[v]) continue;
    if (!fit_.places[v]) {
      unknown.push_back(v);
    } else if (fit_.places[v]->distance > 1e-6) {
      off.push_back(v);
      off_shares.push_back(0.6 * std::min(1.0, fit_.places[v]->distance / whole_smoothing));
    }
  }
  relax(unknown, std::vector<double>(unknown.size(), 1.0), fill_rounds);
  relax(off, off_shares, smooth_rounds);
  // What has crept a long way down the neck is no move that anyone sees: a hundredth of a millimetre on a head.
  // The template's neck ends at the lowest height; below it nothing is of the face.
  constexpr double nothing = 1e-4, lowest = -1.0;
  for (const auto* places : {&unknown, &off})
    for (const std::uint32_t v : *places)
      for (std::size_t k = 0; k < width; ++k)
        if (double& x = values_[v * width + k]; std::abs(x) < nothing || mesh_.positions[v].y < lowest) x = 0.0;
}

void SkinValues::carry_small_parts() {
  constexpr double reach = 0.6, rooted = 0.01;
  const TriangleTree skin(mesh_.positions, mesh_.skin_triangles);
  struct Root {
    Vec3 place;
    SurfacePoint under;
  };
  std::vector<std::vector<Root>> all(mesh_.graph.shells);
  std::vector<double> nearest(mesh_.graph.shells, INFINITY);
  for (const bool collect : {false, true})
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      if (mesh_.kind(v) != ShellKind::attached) continue;
      const std::uint32_t shell = mesh_.graph.shell[v];
      const auto under = skin.nearest(mesh_.positions[v], reach, [](std::size_t) { return true; });
      if (!under) continue;
      if (collect && under->distance <= nearest[shell] + rooted) all[shell].push_back({mesh_.positions[v], *under});
      nearest[shell] = std::min(nearest[shell], under->distance);
    }
  for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
    double* out = &values_[v * width];
    if (mesh_.kind(v) == ShellKind::lower) out[0] = out[1] = 1.0;
    const std::vector<Root>& roots = all[mesh_.graph.shell[v]];
    if (roots.empty()) continue;
    const Root& root =
        *std::ranges::min_element(roots, {}, [&](const Root& r) { return glm::distance(r.place, mesh_.positions[v]); });
    roots_[v] = root.under.position;
    for (std::size_t c = 0; c < 3; ++c) {
      const double* own = &values_[mesh_.skin_triangles[3 * root.under.triangle + c] * width];
      for (std::size_t k = 0; k < width; ++k) out[k] += root.under.shares[static_cast<int>(c)] * own[k];
    }
  }
}

std::vector<FaceDelta> SkinValues::deltas(std::size_t place) const {
  constexpr double nothing = 1e-6;
  std::vector<FaceDelta> out;
  for (std::uint32_t signal = 0; signal < face_signals; ++signal) {
    const double* d = &values_[place * width + 2 + 3 * signal];
    const Vec3 move(d[0], d[1], d[2]);
    if (glm::length(move) > nothing) out.push_back({signal, move, Vec3(0.0)});
  }
  return out;
}

}  // namespace sinew
