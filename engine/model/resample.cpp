#include "engine/model/resample.h"

#include <algorithm>
#include <array>
#include <map>

#include <meshoptimizer.h>

namespace sinew {
namespace {

std::vector<Influence> run_of(const CharacterMesh& mesh, std::uint32_t v) {
  const auto begin = mesh.influences.entries.begin();
  return {begin + mesh.influences.first[v], begin + mesh.influences.first[v + 1]};
}

/// The mean of two runs, no longer than the longer of them.
std::vector<Influence> mean_run(const std::vector<Influence>& a, const std::vector<Influence>& b) {
  std::map<std::uint32_t, double> sum;
  for (const Influence& i : a) sum[i.joint] += 0.5 * i.weight;
  for (const Influence& i : b) sum[i.joint] += 0.5 * i.weight;
  std::vector<Influence> run;
  for (const auto& [joint, weight] : sum) run.push_back({joint, weight});
  std::stable_sort(run.begin(), run.end(), [](const Influence& x, const Influence& y) { return x.weight > y.weight; });
  run.resize(std::min(run.size(), std::max(a.size(), b.size())));
  double total = 0.0;
  for (const Influence& i : run) total += i.weight;
  for (Influence& i : run) i.weight /= total;
  return run;
}

/// Adds vertices to a mesh; influences and morphs are appended run by run.
class Builder {
 public:
  explicit Builder(const CharacterMesh& like) {
    mesh.palette = like.palette;
    mesh.morph_slots = like.morph_slots;
    mesh.parts = like.parts;
    mesh.morph_first.push_back(0);
    if (like.face) mesh.face = {face_sizes(like.face->rig), like.face->place, like.face->guides};
  }

  void copy(const CharacterMesh& from, std::uint32_t v) {
    add(from.positions[v], from.normals[v], run_of(from, v));
    each_attribute(from, [&](const auto& values, auto& to) { to.push_back(values[v]); });
    const auto begin = from.morph_deltas.begin();
    mesh.morph_deltas.insert(mesh.morph_deltas.end(), begin + from.morph_first[v], begin + from.morph_first[v + 1]);
    mesh.morph_first.push_back(static_cast<std::uint32_t>(mesh.morph_deltas.size()));
    if (!from.face) return;
    const FaceRig& rig = from.face->rig;
    const auto deltas = rig.deltas.begin();
    append_vertex(rig.vertices[v], {deltas + rig.first[v], deltas + rig.first[v + 1]}, mesh.face->rig);
  }

  void add_midpoint(const CharacterMesh& from, std::uint32_t a, std::uint32_t b) {
    add(0.5 * (from.positions[a] + from.positions[b]), unit_or(from.normals[a] + from.normals[b], from.normals[a]),
        mean_run(run_of(from, a), run_of(from, b)));
    each_attribute(from, [&](const auto& values, auto& to) { to.push_back(0.5 * (values[a] + values[b])); });
    if (!from.tangents.empty()) mesh.tangents.back() = mean_tangent(from.tangents[a], from.tangents[b]);
    std::map<std::uint32_t, MorphDelta> sum;
    for (const std::uint32_t v : {a, b})
      for (std::uint32_t i = from.morph_first[v]; i < from.morph_first[v + 1]; ++i) {
        const MorphDelta& delta = from.morph_deltas[i];
        MorphDelta& mean = sum[delta.slot];
        mean.slot = delta.slot;
        mean.position += 0.5 * delta.position;
        mean.normal += 0.5 * delta.normal;
      }
    for (const auto& [slot, delta] : sum) mesh.morph_deltas.push_back(delta);
    mesh.morph_first.push_back(static_cast<std::uint32_t>(mesh.morph_deltas.size()));
    if (from.face) add_face_midpoint(from.face->rig, a, b);
  }

  CharacterMesh mesh;

 private:
  void add(const Vec3& position, const Vec3& normal, const std::vector<Influence>& run) {
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.influences.add_vertex(run);
  }

  void add_face_midpoint(const FaceRig& rig, std::uint32_t a, std::uint32_t b) {
    FaceBlend mean = blend_vertices(rig, std::array{a, b}, std::array{0.5, 0.5});
    const FaceVertex &one = rig.vertices[a], &other = rig.vertices[b];
    mean.vertex.eye = std::max(one.eye, other.eye);
    mean.vertex.ball = one.ball && other.ball;
    mean.vertex.close_upper = 0.5 * (one.close_upper + other.close_upper);
    mean.vertex.close_lower = 0.5 * (one.close_lower + other.close_lower);
    mean.vertex.least_distance = std::min(one.least_distance, other.least_distance);
    append_vertex(mean.vertex, mean.deltas, mesh.face->rig);
  }

  /// Calls what is given with each attribute that this character has, and the list that it goes to.
  template <class Call>
  void each_attribute(const CharacterMesh& from, Call call) {
    const auto unless_empty = [&](const auto& values, auto& to) {
      if (!values.empty()) call(values, to);
    };
    unless_empty(from.tangents, mesh.tangents);
    unless_empty(from.texture_coordinates, mesh.texture_coordinates);
    unless_empty(from.second_texture_coordinates, mesh.second_texture_coordinates);
    unless_empty(from.colours, mesh.colours);
  }

  /// On the side of the first.
  static Vec4 mean_tangent(const Vec4& a, const Vec4& b) { return Vec4(unit_or(Vec3(a) + Vec3(b), Vec3(a)), a.w); }
};

std::uint32_t size32(std::size_t n) { return static_cast<std::uint32_t>(n); }

/// Each triangle becomes four. Vertices of a part stay together.
CharacterMesh subdivided(const CharacterMesh& coarse) {
  Builder fine(coarse);
  for (MeshPart& part : fine.mesh.parts) {
    const MeshPart old = part;
    part.first_vertex = size32(fine.mesh.vertices());
    part.first_index = size32(fine.mesh.triangles.size());
    for (std::uint32_t v = 0; v < old.vertex_count; ++v) fine.copy(coarse, old.first_vertex + v);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
    const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, added] = midpoints.try_emplace(std::minmax(a, b), size32(fine.mesh.vertices()));
      if (added) fine.add_midpoint(coarse, a, b);
      return found->second;
    };
    for (std::uint32_t i = old.first_index; i < old.first_index + old.index_count; i += 3) {
      const std::uint32_t a = coarse.triangles[i], b = coarse.triangles[i + 1], c = coarse.triangles[i + 2];
      const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
      const std::uint32_t shift = part.first_vertex - old.first_vertex;
      for (const std::uint32_t index : {a + shift, ab, ca, ab, b + shift, bc, ca, bc, c + shift, ab, bc, ca})
        fine.mesh.triangles.push_back(index);
    }
    part.vertex_count = size32(fine.mesh.vertices()) - part.first_vertex;
    part.index_count = size32(fine.mesh.triangles.size()) - part.first_index;
  }
  return std::move(fine.mesh);
}

/// Collapses edges part by part and drops the vertices that no triangle uses any more.
CharacterMesh decimated(const CharacterMesh& dense, double share) {
  Builder sparse(dense);
  const std::vector<Vec3f> positions(dense.positions.begin(), dense.positions.end());
  for (MeshPart& part : sparse.mesh.parts) {
    const MeshPart old = part;
    std::vector<std::uint32_t> indices(dense.triangles.begin() + old.first_index,
                                       dense.triangles.begin() + old.first_index + old.index_count);
    const auto target = static_cast<std::size_t>(share * static_cast<double>(indices.size() / 3)) * 3;
    indices.resize(meshopt_simplify(indices.data(), indices.data(), indices.size(), &positions[0].x, positions.size(),
                                    sizeof(Vec3f), target, 1.0f, 0, nullptr));
    part.first_vertex = size32(sparse.mesh.vertices());
    part.first_index = size32(sparse.mesh.triangles.size());
    std::map<std::uint32_t, std::uint32_t> kept;
    for (const std::uint32_t v : indices) {
      const auto [found, added] = kept.try_emplace(v, size32(sparse.mesh.vertices()));
      if (added) sparse.copy(dense, v);
      sparse.mesh.triangles.push_back(found->second);
    }
    part.vertex_count = size32(sparse.mesh.vertices()) - part.first_vertex;
    part.index_count = size32(indices.size());
  }
  return std::move(sparse.mesh);
}

}  // namespace

Result<CharacterMesh> resample(const CharacterMesh& mesh, std::size_t vertices) {
  if (mesh.triangles.empty()) return bad_input("a mesh without triangles cannot be resampled");
  CharacterMesh result = mesh;
  while (result.vertices() < vertices) result = subdivided(result);
  if (result.vertices() == vertices) return result;
  return decimated(result, static_cast<double>(vertices) / static_cast<double>(result.vertices()));
}

}  // namespace sinew
