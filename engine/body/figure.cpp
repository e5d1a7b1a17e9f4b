#include "engine/body/figure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "engine/body/figure_build.h"
#include "engine/body/figure_charts.h"
#include "engine/body/figure_relax.h"
#include "engine/body/figure_skeleton.h"
#include "engine/body/figure_weights.h"
#include "engine/body/quad_cage.h"
#include "engine/core/parallel.h"

namespace sinew {
namespace {

/// Of the surface's normal and the mesh's the former shades a coarse mesh better; where the two differ more than these
/// cosines say, the mesh is too coarse for what the surface does there, and its own normal counts.
constexpr double agreeing = 0.95, differing = 0.75;
/// A single quad may differ by this much more: on a coarse mesh it is a chord.
constexpr double slack = 0.35;

constexpr Vec4 skin_colour{0.60, 0.36, 0.26, 1.0};  // linear

/// Vertices and triangles of the whole figure when the strips of its half are cut into parts.
class Counter {
 public:
  Counter(const HalfCage& cage, const CutCage& cut, const Strips& strips) {
    for (const auto& quad : cage.quads) quads_.emplace_back(strips.of(quad[0], quad[1]), strips.of(quad[1], quad[2]));
    std::map<CageEdge, int> uses;
    for (const auto& quad : cut.quads)
      for (std::size_t c = 0; c < 4; ++c) ++uses[cage_edge(quad[c], quad[(c + 1) % 4])];
    for (const auto& [edge, count] : uses) {
      const Index a = cut.welded[edge.first], b = cut.welded[edge.second];
      const bool on_plane = count == 1 && cage.vertices[a].on_plane && cage.vertices[b].on_plane;
      edges_.emplace_back(strips.of(a, b), on_plane ? 1 : 2);
    }
    for (const Index v : cut.welded) corners_ += cage.vertices[v].on_plane ? 1 : 2;
  }

  std::size_t triangles(std::span<const int> parts) const {
    std::size_t count = 0;
    for (const auto& [one, other] : quads_) count += 4 * size(parts[one]) * size(parts[other]);
    return count;
  }
  std::size_t vertices(std::span<const int> parts) const {
    std::size_t count = corners_;
    for (const auto& [strip, sides] : edges_) count += sides * (size(parts[strip]) - 1);
    for (const auto& [one, other] : quads_) count += 2 * (size(parts[one]) - 1) * (size(parts[other]) - 1);
    return count;
  }

 private:
  static std::size_t size(int parts) { return static_cast<std::size_t>(parts); }

  std::vector<std::pair<std::size_t, std::size_t>> quads_;  ///< the two strips of each quad
  std::vector<std::pair<std::size_t, std::size_t>> edges_;  ///< strip, halves of the figure that have it for themselves
  std::size_t corners_ = 0;
};

/// The parts that come closest to the counts that are asked for.
std::vector<int> chosen_parts(const BodyOptions& options, const HalfCage& cage, const Counter& counter,
                              const Strips& strips) {
  const std::vector<double> lengths = strips.weighted_lengths(cage);
  std::vector<int> best;
  double least_error = INFINITY;
  // A half has about half as many quads as the figure has vertices, fewer by those that stand twice.
  constexpr int trials = 24;
  for (int trial = 0; trial < trials; ++trial) {
    const double share = glm::mix(0.84, 1.02, trial / (trials - 1.0));
    const auto wanted = static_cast<std::size_t>(0.5 * share * options.vertices);
    const std::vector<int> parts = parts_for(cage.quads, strips, lengths, wanted);
    const auto off = [](std::size_t found, int asked) { return std::abs(static_cast<double>(found) / asked - 1.0); };
    double error = off(counter.vertices(parts), options.vertices);
    if (options.triangles > 0) error = std::max(error, off(counter.triangles(parts), options.triangles));
    if (error < least_error) {
      least_error = error;
      best = parts;
    }
  }
  return best;
}

/// The left half, refined and laid on the surface, vertices on texture seams standing once.
struct Half {
  HalfSurface surface;
  std::vector<Vec3> normals;
  std::vector<std::vector<Influence>> influences;
};

std::vector<Vec3> shading_normals(const HalfSurface& surface, const BodyField& field) {
  std::vector<Vec3> normals = vertex_normals({surface.positions, surface.quads}), of_field = normals;
  parallel_for(
      normals.size(),
      [&](std::size_t i) { of_field[i] = unit_or(field.at(surface.positions[i]).gradient, normals[i]); }, 256);
  // Where a vertex' normal and some quad at it differ most, as a cosine.
  std::vector<double> agreement(normals.size(), 1.0);
  for (const auto& quad : surface.quads) {
    const auto& p = surface.positions;
    const Vec3 face = unit_or(glm::cross(p[quad[2]] - p[quad[0]], p[quad[3]] - p[quad[1]]), Vec3(0.0));
    for (const Index v : quad) agreement[v] = std::min(agreement[v], glm::dot(face, of_field[v]));
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const double trust = smoothstep01((std::min(glm::dot(normals[i], of_field[i]), agreement[i] + slack) - differing) /
                                      (agreeing - differing));
    normals[i] = unit_or(glm::mix(normals[i], of_field[i], trust), normals[i]);
    if (surface.on_plane[i]) normals[i] = unit_or({0.0, normals[i].y, normals[i].z}, normals[i]);
  }
  return normals;
}

Half built_half(const HalfCage& cage, const RefinedQuads& refined, const BodyField& field,
                const FigureWeights& weights) {
  Half half;
  std::vector<Vec3> positions;
  for (const CageVertex& v : cage.vertices) positions.push_back(v.position);
  std::map<CageEdge, int> uses;
  for (const auto& quad : cage.quads)
    for (std::size_t c = 0; c < 4; ++c) ++uses[cage_edge(quad[c], quad[(c + 1) % 4])];

  half.surface.quads = refined.quads;
  for (const Stencil& stencil : refined.vertices) {
    const bool corner = stencil.weight[0] == 1.0;
    const bool on_edge = stencil.weight[2] == 0.0;
    const CageVertex &a = cage.vertices[stencil.corner[0]], &b = cage.vertices[stencil.corner[1]];
    const bool on_plane =
        corner ? a.on_plane
               : on_edge && a.on_plane && b.on_plane && uses.at(cage_edge(stencil.corner[0], stencil.corner[1])) == 1;
    half.surface.positions.push_back(stencil.of(std::span<const Vec3>(positions)));
    half.surface.on_plane.push_back(on_plane);
    half.surface.looseness.push_back(corner ? a.looseness : 0.5);
  }
  settle_surface(half.surface, field);
  half.normals = shading_normals(half.surface, field);

  const std::vector<ChainShares> shares = chain_shares(cage, refined);
  half.influences.resize(refined.vertices.size());
  parallel_for(
      refined.vertices.size(),
      [&](std::size_t i) {
        half.influences[i] = weights.at(half.surface.positions[i], shares[i], half.surface.on_plane[i]);
      },
      256);
  return half;
}

std::vector<Influence> mirrored(const std::vector<Influence>& run, const FigureSkeleton& skeleton) {
  std::vector<Influence> out;
  for (const Influence& influence : run)
    out.push_back({static_cast<std::uint32_t>(skeleton.joints[influence.joint].mirror), influence.weight});
  std::ranges::sort(out, [](const Influence& a, const Influence& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
  });
  return out;
}

/// Exactly as tall as asked for.
FigureScale scale_to(const std::vector<Vec3>& positions, double height) {
  const auto [lowest, highest] =
      std::ranges::minmax_element(positions, [](const Vec3& a, const Vec3& b) { return a.y < b.y; });
  return {height / (highest->y - lowest->y), lowest->y};
}

/// Both halves as one list of triangles, in metres.
Primitive whole_skin(const Half& half, const RefinedQuads& cut, const CutCage& cut_cage, const FigureSkeleton& skeleton,
                     const FigureScale& scale) {
  std::vector<Index> welded(cut.vertices.size());  // of the half's vertices
  for (std::size_t q = 0; q < cut.quads.size(); ++q)
    for (std::size_t c = 0; c < 4; ++c) welded[cut.quads[q][c]] = half.surface.quads[q][c];

  Primitive skin;
  std::vector<Index> right(welded.size());
  const auto add = [&](std::size_t vertex, bool is_right) {
    const Index w = welded[vertex];
    const Vec3 side(is_right ? -1.0 : 1.0, 1.0, 1.0);
    const Vec2 uv = cut.vertices[vertex].of(std::span<const Vec2>(cut_cage.uv));
    skin.positions.push_back(side * scale.to_metres(half.surface.positions[w]));
    skin.normals.push_back(side * half.normals[w]);
    skin.texture_coordinates.emplace_back(is_right ? 1.0 - uv.x : uv.x, 1.0 - uv.y);
    skin.influences.add_vertex(is_right ? mirrored(half.influences[w], skeleton) : half.influences[w]);
  };
  for (std::size_t v = 0; v < welded.size(); ++v) add(v, false);
  for (std::size_t v = 0; v < welded.size(); ++v) {
    right[v] = static_cast<Index>(v);
    if (half.surface.on_plane[welded[v]]) continue;
    right[v] = static_cast<Index>(skin.positions.size());
    add(v, true);
  }
  for (std::size_t q = 0; q < cut.quads.size(); ++q) {
    const auto& [a, b, c, d] = half.surface.quads[q];
    const auto& p = half.surface.positions;
    const bool cut_ac = glm::distance(p[a], p[c]) <= glm::distance(p[b], p[d]);
    const auto& k = cut.quads[q];
    const std::array<Index, 6> corners =
        cut_ac ? std::array{k[0], k[1], k[2], k[0], k[2], k[3]} : std::array{k[1], k[2], k[3], k[1], k[3], k[0]};
    skin.indices.insert(skin.indices.end(), corners.begin(), corners.end());
    for (const std::size_t i : {0, 2, 1, 3, 5, 4}) skin.indices.push_back(right[corners[i]]);
  }
  skin.material = 0;
  return skin;
}

void add_skeleton(Model& model, const FigureSkeleton& skeleton, const FigureScale& scale) {
  Skin skin{.name = "figure", .joints = {}, .inverse_bind = {}};
  for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
    const FigureJoint& joint = skeleton.joints[j];
    const Vec3 place = scale.to_metres(joint.position);
    Node node;
    node.name = joint.name;
    node.parent = joint.parent;
    node.rest.translation = joint.parent < 0 ? place : place - scale.to_metres(skeleton.joints[joint.parent].position);
    model.nodes.push_back(node);
    if (joint.parent >= 0)
      model.nodes[joint.parent].children.push_back(static_cast<int>(j));
    else
      model.roots.push_back(static_cast<int>(j));
    skin.joints.push_back(static_cast<int>(j));
    skin.inverse_bind.push_back(Transform{.translation = -place}.matrix());
  }
  model.skins = {skin};
}

}  // namespace

Result<void> check_figure_options(const BodyOptions& o) {
  const auto wrong = [](const char* option, const auto& found, const char* expected) -> Result<void> {
    return failure(ErrorKind::usage, "{} {}: expected {}", option, found, expected);
  };
  if (!(o.sex >= 0.0 && o.sex <= 1.0)) return wrong("--sex", o.sex, "a number from 0 (male) to 1 (female)");
  if (!(o.height == 0.0 || (o.height >= 0.3 && o.height <= 3.0)))
    return wrong("--height", o.height, "metres, from 0.3 to 3");
  if (!(o.build >= -1.0 && o.build <= 1.0)) return wrong("--build", o.build, "a number from -1 (slim) to 1 (heavy)");
  if (!(o.muscle >= 0.0 && o.muscle <= 1.0)) return wrong("--muscle", o.muscle, "a number from 0 to 1");
  if (std::ranges::find(figure_joint_counts, o.joints) == std::end(figure_joint_counts))
    return wrong("--joints", o.joints, "23, 37 or 68");
  if (o.vertices < fewest_figure_vertices || o.vertices > most_figure_vertices)
    return failure(ErrorKind::usage, "--vertices {}: expected a number from {} to {}", o.vertices,
                   fewest_figure_vertices, most_figure_vertices);
  return {};
}

Result<BodyOptions> figure_preset(std::string_view name) {
  BodyOptions options;
  if (name == "skeleton") {
    options.joints = 23, options.vertices = 1844, options.triangles = 3342;
  } else if (name == "woman") {
    options.sex = 1.0, options.joints = 37, options.vertices = 2365, options.triangles = 4412;
  } else if (name == "poser") {
    options.joints = 68, options.vertices = 86529, options.triangles = 166368;
  } else {
    return failure(ErrorKind::usage, "--like {}: expected skeleton, woman or poser", name);
  }
  return options;
}

BuiltFigure built_figure(const BodyOptions& options) {
  BuiltFigure out{measured_body(options.sex, options.build, options.muscle), {}, {}};
  const MeasuredBody& body = out.body;
  const BodyField field(body);
  HalfCage cage = figure_cage(body);
  relax_cage(cage, field);

  const CutCage cut = cut_cage(cage);
  const Strips strips(cage.quads);
  const std::vector<int> parts = chosen_parts(options, cage, Counter(cage, cut, strips), strips);
  std::vector<Index> same(cage.vertices.size());
  std::iota(same.begin(), same.end(), Index{0});
  const FigureSkeleton skeleton = figure_skeleton(body, options.joints);
  const Half half =
      built_half(cage, refine_strips(cage.quads, same, strips, parts), field, FigureWeights(body, skeleton));

  Model& model = out.model;
  model.file = "figure";
  out.scale = scale_to(half.surface.positions, options.height > 0.0 ? options.height : body.height);
  add_skeleton(model, skeleton, out.scale);
  Node node;
  node.name = "figure";
  node.mesh = 0;
  node.skin = 0;
  model.roots.push_back(static_cast<int>(model.nodes.size()));
  model.nodes.push_back(node);
  Mesh mesh{.name = "figure", .primitives = {}, .morph_weights = {}};
  mesh.primitives.push_back(
      whole_skin(half, refine_strips(cut.quads, cut.welded, strips, parts), cut, skeleton, out.scale));
  model.meshes.push_back(std::move(mesh));
  Material& material = model.materials.emplace_back();
  material.name = "skin";
  material.base_colour = skin_colour;
  material.roughness = 0.6;
  return out;
}

Result<Model> build_figure(const BodyOptions& options) {
  if (auto ok = check_figure_options(options); !ok) return pass_on(std::move(ok));
  return std::move(built_figure(options).model);
}

}  // namespace sinew
