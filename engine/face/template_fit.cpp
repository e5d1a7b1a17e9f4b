#include "engine/face/template_fit.h"

#include "engine/core/parallel.h"
#include "engine/face/lip_sides.h"

namespace sinew {
namespace {

struct TemplateSkin {
  std::vector<Vec3> positions, normals;
  std::vector<std::uint32_t> triangles;
  std::vector<std::int8_t> sides;  ///< lip_sides
  std::vector<bool> outside;       ///< in no cavity: may pull the warp
  Landmarks marks;
};

TemplateSkin template_skin(const Head& head) {
  TemplateSkin out;
  const auto end = static_cast<std::ptrdiff_t>(head.skin_vertices);
  out.positions.assign(head.positions.begin(), head.positions.begin() + end);
  out.normals.assign(head.normals.begin(), head.normals.begin() + end);
  out.outside.assign(head.skin_vertices, true);
  for (const HeadTriangle& t : head.triangles) {
    if (t.corners[0] >= head.skin_vertices) continue;
    out.triangles.insert(out.triangles.end(), t.corners.begin(), t.corners.end());
    if (t.material != HeadMaterial::skin)
      for (const std::uint32_t v : t.corners) out.outside[v] = false;
  }
  for (const auto& [name, vertex] : head.marks) out.marks[name] = head.positions[vertex];
  const SurfaceGraph graph = surface_graph(out.positions, out.triangles, false);
  out.sides = lip_sides(out.positions, out.normals, graph, std::vector<bool>(head.skin_vertices, true), out.marks);
  return out;
}

struct Pairs {
  std::vector<Vec3> from, to;
  std::vector<double> looseness;

  void add(const Vec3& a, const Vec3& b, double loose) {
    from.push_back(a);
    to.push_back(b);
    looseness.push_back(loose);
  }
  bool near(const Vec3& p, double distance) const {
    for (const Vec3& q : from)
      if (glm::distance(p, q) < distance) return true;
    return false;
  }
};

/// The landmarks; where lips meet, their middle stands for both: places that touch on the template may gape on the
/// mesh.
Pairs landmark_pairs(const TemplateSkin& skin, const Landmarks& marks) {
  constexpr double same_place = 0.03;
  Pairs out;
  const auto middle = [&](const std::string& upper, const std::string& lower) {
    if (marks.contains(upper) && marks.contains(lower))
      out.add(0.5 * (skin.marks.at(upper) + skin.marks.at(lower)), 0.5 * (marks.at(upper) + marks.at(lower)), 0.0);
  };
  middle("upperLip", "lowerLip");
  middle("upperLipSideLeft", "lowerLipSideLeft");
  middle("upperLipSideRight", "lowerLipSideRight");
  for (const auto& [name, place] : marks) {
    if (name.starts_with("upperLip") || name.starts_with("lowerLip")) continue;
    const Vec3& ours = skin.marks.at(name);
    if (!out.near(ours, same_place)) out.add(ours, place, 0.0);
  }
  return out;
}

std::vector<Vec3> warped(const TemplateSkin& skin, const RadialWarp& warp) {
  std::vector<Vec3> out(skin.positions.size());
  parallel_for(
      out.size(), [&](std::size_t v) { out[v] = warp.point(skin.positions[v]); }, 64);
  return out;
}

Vec3 face_normal(const std::vector<Vec3>& p, const std::vector<std::uint32_t>& triangles, std::size_t t) {
  const Vec3& a = p[triangles[3 * t]];
  return unit_or(glm::cross(p[triangles[3 * t + 1]] - a, p[triangles[3 * t + 2]] - a), Vec3(0.0));
}

/// Places of the face, evenly spread, that are pulled onto the mesh's skin.
Pairs with_skin_pairs(const TemplateSkin& skin, const Pairs& landmarks, const RadialWarp& warp, const FaceMesh& mesh,
                      const TriangleTree& target, double looseness) {
  constexpr double spacing = 0.20, from_landmarks = 0.14, reach = 0.35, alike = 0.6, lowest = -0.1, behind = 0.1;
  Pairs out = landmarks;
  const std::vector<Vec3> at = warped(skin, warp);
  const std::vector<Vec3> normals = [&] {
    std::vector<Vec3> sums(at.size(), Vec3(0.0));
    for (std::size_t t = 0; t < skin.triangles.size() / 3; ++t)
      for (std::size_t c = 0; c < 3; ++c) sums[skin.triangles[3 * t + c]] += face_normal(at, skin.triangles, t);
    for (Vec3& n : sums) n = unit_or(n, Vec3(0, 0, 1));
    return sums;
  }();
  Pairs tried = landmarks;
  for (std::size_t v = 0; v < at.size(); ++v) {
    const Vec3& p = skin.positions[v];
    if (!skin.outside[v] || p.y < lowest || p.z < behind) continue;
    if (landmarks.near(p, from_landmarks) || tried.near(p, spacing)) continue;
    tried.add(p, p, 0.0);
    const auto near = target.nearest(at[v], reach, [&](std::size_t t) {
      return glm::dot(face_normal(mesh.positions, mesh.skin_triangles, t), normals[v]) > alike;
    });
    if (near) out.add(p, near->position, looseness);
  }
  return out;
}

}  // namespace

TemplateFit fit_template(const Head& head, const FaceMesh& mesh) {
  constexpr double reach = 0.45, alike = 0.15, farther = 0.04, gentle_looseness = 0.4, gentle_width = 0.35;
  const TemplateSkin skin = template_skin(head);
  const TriangleTree target(mesh.positions, mesh.skin_triangles);
  const Pairs landmarks = landmark_pairs(skin, mesh.marks);
  RadialWarp warp(landmarks.from, landmarks.to, landmarks.looseness);
  Pairs pairs = landmarks;
  for (const double looseness : {0.3, 0.1, 0.1}) {
    pairs = with_skin_pairs(skin, landmarks, warp, mesh, target, looseness);
    warp = RadialWarp(pairs.from, pairs.to, pairs.looseness);
  }
  // Moves are carried by a gentler map: between landmarks that are near to each other the exact one is all shear.
  for (double& loose : pairs.looseness) loose += gentle_looseness;
  const RadialWarp gentle(pairs.from, pairs.to, pairs.looseness, gentle_width);

  std::vector<bool> is_skin(mesh.positions.size());
  for (std::size_t v = 0; v < is_skin.size(); ++v) is_skin[v] = mesh.kind(v) == ShellKind::skin;
  const std::vector<std::int8_t> sides = lip_sides(mesh.positions, mesh.normals, mesh.graph, is_skin, mesh.marks);
  const std::vector<Vec3> at = warped(skin, warp);
  const TriangleTree ours(at, skin.triangles);
  TemplateFit out{warp, std::vector<std::optional<TemplatePlace>>(mesh.positions.size()),
                  std::vector<bool>(mesh.positions.size(), false)};
  std::vector<char> near(mesh.positions.size(), 0);
  parallel_for(
      mesh.positions.size(),
      [&](std::size_t v) {
        if (!is_skin[v]) return;
        const Vec3& p = mesh.positions[v];
        const auto any = ours.nearest(p, reach, [](std::size_t) { return true; });
        if (!any) return;
        near[v] = 1;
        const auto found = ours.nearest(p, reach, [&](std::size_t t) {
          if (sides[v] != 0)
            for (std::size_t c = 0; c < 3; ++c)
              if (skin.sides[skin.triangles[3 * t + c]] == -sides[v]) return false;
          return glm::dot(face_normal(at, skin.triangles, t), mesh.normals[v]) > alike;
        });
        // What lies nearer but faces elsewhere says that this is a fold or an edge which the template does not have
        // there.
        if (!found || found->distance > any->distance + farther) return;
        TemplatePlace place;
        Vec3 from(0.0);
        for (std::size_t c = 0; c < 3; ++c) {
          place.vertices[c] = skin.triangles[3 * found->triangle + c];
          from += found->shares[static_cast<int>(c)] * skin.positions[place.vertices[c]];
        }
        place.shares = found->shares;
        place.distance = found->distance;
        place.slope = gentle.slope(from);
        out.places[v] = place;
      },
      16);
  out.near.assign(near.begin(), near.end());
  return out;
}

}  // namespace sinew
