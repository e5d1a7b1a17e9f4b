#include "engine/body/quad_cage.h"

#include <cassert>
#include <map>
#include <utility>

namespace sinew {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge edge_between(std::uint32_t a, std::uint32_t b) { return a < b ? Edge{a, b} : Edge{b, a}; }

/// Sums over the quads round each vertex; on a closed mesh every neighbour across an edge is met twice.
struct Neighbourhood {
  double valence = 0.0;
  Vec3 across_edges{0.0};      ///< each neighbour once
  Vec3 across_diagonals{0.0};  ///< the opposite corners of the quads
};

std::vector<Neighbourhood> neighbourhoods(const QuadCage& cage) {
  std::vector<Neighbourhood> around(cage.positions.size());
  for (const auto& quad : cage.quads) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      Neighbourhood& here = around[quad[corner]];
      here.valence += 1.0;
      here.across_edges += 0.5 * (cage.positions[quad[(corner + 1) % 4]] + cage.positions[quad[(corner + 3) % 4]]);
      here.across_diagonals += cage.positions[quad[(corner + 2) % 4]];
    }
  }
  return around;
}

Vec3 centre(const QuadCage& cage, const std::array<std::uint32_t, 4>& quad) {
  return 0.25 * (cage.positions[quad[0]] + cage.positions[quad[1]] + cage.positions[quad[2]] + cage.positions[quad[3]]);
}

/// Old vertices by the rule (Q + 2R + (n - 3)S) / n, written with sums over edge and diagonal neighbours.
std::vector<Vec3> refined_old_vertices(const QuadCage& cage) {
  const std::vector<Neighbourhood> around = neighbourhoods(cage);
  std::vector<Vec3> moved(cage.positions.size());
  for (std::size_t v = 0; v < moved.size(); ++v) {
    const double n = around[v].valence;
    const Vec3& here = cage.positions[v];
    const Vec3 face_points = (n * here + 2.0 * around[v].across_edges + around[v].across_diagonals) / (4.0 * n);
    const Vec3 edge_middles = 0.5 * (here + around[v].across_edges / n);
    moved[v] = (face_points + 2.0 * edge_middles + (n - 3.0) * here) / n;
  }
  return moved;
}

}  // namespace

std::uint32_t QuadCage::add(const Vec3& position) {
  positions.push_back(position);
  return static_cast<std::uint32_t>(positions.size() - 1);
}

void QuadCage::bridge(std::span<const std::uint32_t> near, std::span<const std::uint32_t> far) {
  assert(near.size() == far.size());
  for (std::size_t k = 0; k < near.size(); ++k) {
    const std::size_t next = (k + 1) % near.size();
    quads.push_back({near[k], near[next], far[next], far[k]});
  }
}

std::vector<Vec3> limit_positions(const QuadCage& cage) {
  const std::vector<Neighbourhood> around = neighbourhoods(cage);
  std::vector<Vec3> limit(cage.positions.size());
  for (std::size_t v = 0; v < limit.size(); ++v) {
    const double n = around[v].valence;
    limit[v] =
        (n * n * cage.positions[v] + 4.0 * around[v].across_edges + around[v].across_diagonals) / (n * (n + 5.0));
  }
  return limit;
}

void aim_limit_at_vertices(QuadCage& cage, int rounds) {
  const std::vector<Vec3> targets = cage.positions;
  const std::vector<Neighbourhood> around = neighbourhoods(cage);
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Vec3> reached = limit_positions(cage);
    for (std::size_t v = 0; v < targets.size(); ++v)
      if (around[v].valence <= 4.0) cage.positions[v] += targets[v] - reached[v];
  }
}

QuadCage refine(const QuadCage& cage) {
  QuadCage fine;
  fine.positions = refined_old_vertices(cage);
  std::map<Edge, std::uint32_t> edge_points;
  std::vector<std::uint32_t> face_points;
  for (const auto& quad : cage.quads) face_points.push_back(fine.add(centre(cage, quad)));

  for (std::size_t f = 0; f < cage.quads.size(); ++f) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const std::uint32_t a = cage.quads[f][corner], b = cage.quads[f][(corner + 1) % 4];
      auto [place, is_new] = edge_points.try_emplace(edge_between(a, b), 0);
      if (is_new) place->second = fine.add(0.25 * (cage.positions[a] + cage.positions[b]));
      fine.positions[place->second] += 0.25 * fine.positions[face_points[f]];
    }
  }
  for (std::size_t f = 0; f < cage.quads.size(); ++f) {
    const auto& quad = cage.quads[f];
    for (std::size_t corner = 0; corner < 4; ++corner) {
      fine.quads.push_back({quad[corner], edge_points.at(edge_between(quad[corner], quad[(corner + 1) % 4])),
                            face_points[f], edge_points.at(edge_between(quad[(corner + 3) % 4], quad[corner]))});
    }
  }
  return fine;
}

std::vector<Vec3> vertex_normals(const QuadCage& cage) {
  std::vector<Vec3> normals(cage.positions.size(), Vec3{0.0});
  for (const auto& quad : cage.quads) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const Vec3& here = cage.positions[quad[corner]];
      const Vec3 next = cage.positions[quad[(corner + 1) % 4]] - here;
      const Vec3 previous = cage.positions[quad[(corner + 3) % 4]] - here;
      const double angle = angle_degrees(next, previous) * degrees_to_radians;
      normals[quad[corner]] += angle * unit_or(glm::cross(next, previous), Vec3{0.0});
    }
  }
  for (Vec3& normal : normals) normal = unit_or(normal, Vec3{0.0, 1.0, 0.0});
  return normals;
}

std::vector<std::uint32_t> triangles(const QuadCage& cage) {
  std::vector<std::uint32_t> indices;
  indices.reserve(6 * cage.quads.size());
  for (const auto& [a, b, c, d] : cage.quads) {
    const bool cut_ac =
        glm::distance(cage.positions[a], cage.positions[c]) <= glm::distance(cage.positions[b], cage.positions[d]);
    if (cut_ac)
      indices.insert(indices.end(), {a, b, c, a, c, d});
    else
      indices.insert(indices.end(), {b, c, d, b, d, a});
  }
  return indices;
}

}  // namespace sinew
