#include "engine/face/half_head.h"

#include <array>
#include <map>

#include "engine/core/text.h"
#include "engine/face/quad_mesh_check.h"
#include "engine/io/gltf_read.h"
#include "engine/io/gltf_triangles.h"
#include "engine/io/obj_read.h"

namespace sinew {
namespace {

struct Soup {
  std::vector<Vec3> positions;
  Polygons polygons;
};

Result<Soup> read_soup(const std::filesystem::path& file) {
  if (lower(file.extension().string()) == ".obj") {
    auto read = read_obj(file);
    if (!read) return pass_on(std::move(read));
    return Soup{std::move(read->positions), std::move(read->polygons)};
  }
  const auto model = read_gltf(file);
  if (!model) return tl::unexpected<Error>(model.error());
  Soup out;
  for (std::size_t i = 0; i < model->nodes.size(); ++i) {
    if (model->nodes[i].mesh < 0) continue;
    Mat4 world = model->nodes[i].rest_local();
    for (int p = model->nodes[i].parent; p >= 0; p = model->nodes[static_cast<std::size_t>(p)].parent)
      world = model->nodes[static_cast<std::size_t>(p)].rest_local() * world;
    for (const Primitive& primitive : model->meshes[static_cast<std::size_t>(model->nodes[i].mesh)].primitives) {
      const auto first = static_cast<std::uint32_t>(out.positions.size());
      for (const Vec3& p : primitive.positions) out.positions.emplace_back(world * Vec4(p, 1.0));
      for (std::size_t k = 0; k + 2 < primitive.indices.size(); k += 3)
        out.polygons.push_back(
            {first + primitive.indices[k], first + primitive.indices[k + 1], first + primitive.indices[k + 2]});
    }
  }
  return out;
}

/// One vertex a place; polygons that lose corners by it are dropped.
Soup welded(const Soup& soup) {
  Soup out;
  std::map<std::array<double, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> number;
  for (const Vec3& p : soup.positions) {
    const auto [at, is_new] = places.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(out.positions.size()));
    if (is_new) out.positions.push_back(p);
    number.push_back(at->second);
  }
  for (const auto& polygon : soup.polygons) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t v : polygon)
      if (corners.empty() || corners.back() != number[v]) corners.push_back(number[v]);
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() > 2) out.polygons.push_back(std::move(corners));
  }
  return out;
}

}  // namespace

Result<Model> mirrored_half_model(const std::filesystem::path& file) {
  constexpr double middle_share = 1e-4;
  auto read = read_soup(file);
  if (!read) return pass_on(std::move(read));
  Soup half = std::move(*read);
  if (half.polygons.empty()) return bad_input("{}: no faces; expected half a head", file.string());
  Bounds bounds;
  for (const Vec3& p : half.positions) bounds.add(p);
  const double middle = middle_share * bounds.diagonal();
  if (bounds.low.x < -middle && bounds.high.x > middle)
    return bad_input("{}: reaches from x = {:.4g} to {:.4g}; expected a half, on one side of x = 0", file.string(),
                     bounds.low.x, bounds.high.x);
  if (std::min(std::abs(bounds.low.x), std::abs(bounds.high.x)) > middle)
    return bad_input("{}: no vertex lies at x = 0, where the halves would join", file.string());
  for (Vec3& p : half.positions)
    if (std::abs(p.x) <= middle) p.x = 0.0;
  half = welded(half);

  Soup whole = half;
  std::vector<std::uint32_t> mirror;
  for (std::uint32_t v = 0; v < half.positions.size(); ++v) {
    const Vec3& p = half.positions[v];
    mirror.push_back(p.x == 0.0 ? v : static_cast<std::uint32_t>(whole.positions.size()));
    if (p.x != 0.0) whole.positions.emplace_back(-p.x, p.y, p.z);
  }
  for (const auto& polygon : half.polygons) {
    std::vector<std::uint32_t> other;
    for (auto v = polygon.rbegin(); v != polygon.rend(); ++v) other.push_back(mirror[*v]);
    whole.polygons.push_back(std::move(other));
  }
  MeshCheck check = check_polygons(whole.positions.size(), whole.polygons);
  check.lonely_vertices = 0;  // vertices that no face uses do no harm
  if (!check.sound()) return bad_input("{}: no surface when mirrored: {}", file.string(), check.words());

  Primitive primitive;
  primitive.positions = whole.positions;
  for (const auto& polygon : whole.polygons)
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      primitive.indices.insert(primitive.indices.end(), {polygon[0], polygon[i], polygon[i + 1]});
  primitive.normals = gltf::smooth_normals(primitive.positions, primitive.indices);
  for (std::uint32_t v = 0; v < mirror.size(); ++v) {
    Vec3& n = primitive.normals[v];
    if (mirror[v] == v) n = unit_or({0.0, n.y, n.z}, n);
    if (mirror[v] != v) primitive.normals[mirror[v]] = {-n.x, n.y, n.z};
  }
  Mesh mesh;
  mesh.name = "head";
  mesh.primitives.push_back(std::move(primitive));
  return single_mesh_model(std::move(mesh));
}

}  // namespace sinew
