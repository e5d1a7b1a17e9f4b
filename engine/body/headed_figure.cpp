#include "engine/body/headed_figure.h"

#include <algorithm>
#include <numbers>

#include "engine/body/neck_fit.h"
#include "engine/face/head_model.h"
#include "engine/face/head_shapes.h"
#include "engine/fit/weight_run.h"

namespace sinew {
namespace {

/// Crown to chin of a figure's own plain head, of its height; where the chin is the neck's joints tell.
constexpr double head_share = 0.127;
/// How steeply the cut falls forward, and how far above the neck's middle joint it lies, of the height: it runs from
/// below the larynx to the nape, above what the shoulders raise.
constexpr double cut_fall = 0.34, cut_rise = 0.002;
/// At this height, of the head's, above the chin skulls are deepest: there their middles are laid upon each other.
constexpr double deepest = 0.60, deepest_band = 0.04;

int node_named(const Model& model, std::string_view name) {
  const auto found = std::ranges::find(model.nodes, name, &Node::name);
  return static_cast<int>(found - model.nodes.begin());
}

Vec3 rest_place(const Model& model, int node) {
  Vec3 place(0.0);
  for (; node >= 0; node = model.nodes[static_cast<std::size_t>(node)].parent)
    place += model.nodes[static_cast<std::size_t>(node)].rest.translation;
  return place;
}

/// Middle of the depths at the height where the skull is deepest.
double middle_depth(std::span<const Vec3> positions, double low, double height) {
  Bounds bounds;
  for (const Vec3& p : positions)
    if (std::abs((p.y - low) / height - deepest) < deepest_band) bounds.add(p);
  return 0.5 * (bounds.low.z + bounds.high.z);
}

std::vector<Influence> border_influences(const Primitive& skin, const NeckBorder::Place& place) {
  return mixed_influences(influences_of(skin.influences, place.from), influences_of(skin.influences, place.to),
                          place.share);
}

/// Closes the band between the figure's border and the head's lowest ring with triangles of the figure's skin.
void close_band(const NeckBorder& border, const Head& head, std::span<const std::uint32_t> ring, const Vec3& origin,
                Primitive& skin) {
  struct Corner {
    double angle;
    std::uint32_t vertex;
  };
  std::vector<Corner> upper;
  const double unit = head.metres();
  for (const std::uint32_t v : ring) {
    const Vec3 place = origin + unit * head.positions[v];
    const NeckBorder::Place below = border.at(border.angle(place));
    upper.push_back({border.angle(place), static_cast<std::uint32_t>(skin.positions.size())});
    const auto influences = border_influences(skin, below);
    const Vec2 uv = glm::mix(skin.texture_coordinates[below.from], skin.texture_coordinates[below.to], below.share);
    skin.positions.push_back(place);
    skin.normals.push_back(head.normals[v]);
    skin.texture_coordinates.push_back(uv);
    skin.influences.add_vertex(influences);
  }
  // Both sides of the band are shaded alike.
  for (const BorderEdge& edge : border.edges()) {
    const double angle = border.angle(skin.positions[edge.from]);
    const auto nearest =
        std::ranges::min_element(upper, {}, [&](const Corner& corner) { return std::abs(corner.angle - angle); });
    for (const std::uint32_t v : {edge.from, edge.to})
      if (border.angle(skin.positions[v]) == angle) skin.normals[v] = skin.normals[nearest->vertex];
  }
  const std::uint32_t at_back = upper.front().vertex;
  upper.front().angle = -std::numbers::pi;
  upper.push_back({std::numbers::pi, at_back});
  std::size_t next = 1;
  for (const BorderEdge& edge : border.edges()) {
    const double end = &edge == &border.edges().back() ? std::numbers::pi : border.angle(skin.positions[edge.to]);
    const double middle = border.angle(0.5 * (skin.positions[edge.from] + skin.positions[edge.to]));
    // Each edge is tied to the ring's corner nearest to its middle.
    for (; next < upper.size() && upper[next].angle <= middle; ++next)
      skin.indices.insert(skin.indices.end(), {edge.from, upper[next].vertex, upper[next - 1].vertex});
    skin.indices.insert(skin.indices.end(), {edge.from, edge.to, upper[next - 1].vertex});
    for (; next < upper.size() && upper[next].angle <= end; ++next)
      skin.indices.insert(skin.indices.end(), {edge.to, upper[next].vertex, upper[next - 1].vertex});
  }
}

/// Measures of the neck so that it begins where the figure's ends, as far as heads have such necks.
void follow_neck(const NeckBorder& border, const Vec3& origin, HeadMeasures& measures) {
  // The rings of a head's neck lie behind its measures by about so much (engine/face/head_cage_neck.cpp).
  constexpr double front_ring = 0.04, back_ring = 0.04;
  const double unit = measures.height / head_units;
  const auto set = [&](std::string_view name, double value) {
    const auto field = std::ranges::find(head_measure_fields(), name, &HeadMeasureField::name);
    measures.*field->member = std::clamp(value, field->low, field->high);
  };
  set("neck_front", (border.at(0.0).position.z - origin.z) / unit + front_ring);
  set("neck_back", (border.at(std::numbers::pi).position.z - origin.z) / unit + back_ring);
}

/// Moves the head to its place and lets it follow the skull, its neck by degrees the figure's.
void hang_on(const NeckBorder& border, const Primitive& skin, const NeckFit& fit, std::uint32_t skull,
             const HeadedFigure& figure, Mesh& mesh) {
  const std::vector<Influence> of_skull{{skull, 1.0}};
  const std::vector<std::uint32_t> from = head_vertices(figure.head);
  std::size_t number = 0;
  for (Primitive& primitive : mesh.primitives)
    for (Vec3& p : primitive.positions) {
      const std::uint32_t v = from[number++];
      p += figure.origin;
      const double own = v < figure.head.skin_vertices ? fit.share[v] : 1.0;
      primitive.influences.add_vertex(
          own == 1.0 ? of_skull : mixed_influences(border_influences(skin, border.at(border.angle(p))), of_skull, own));
    }
}

/// The head's primitives behind the figure's skin. One body, one skin: the face has its colour.
void add_to_figure(Model head, Model& figure) {
  Mesh &mesh = figure.meshes.front(), &worn = head.meshes.front();
  const Material body = figure.materials.front();
  const auto first_material = static_cast<int>(figure.materials.size());
  for (const MorphTarget& target : worn.primitives.front().morph_targets)
    mesh.primitives.front().morph_targets.push_back({target.name, {}, {}});
  mesh.morph_weights = worn.morph_weights;
  for (Primitive& primitive : worn.primitives) {
    primitive.material += first_material;
    mesh.primitives.push_back(std::move(primitive));
  }
  for (Material& material : head.materials) {
    if (material.name == body.name) {
      material = body;
      material.name = "face";
    }
    figure.materials.push_back(std::move(material));
  }
}

}  // namespace

CharacterFace HeadedFigure::face() const {
  CharacterFace out{face_sizes(head.face), {.origin = origin, .unit = head.metres()}, head_guides(head.measures)};
  for (std::uint32_t v = 0; v < first_vertex; ++v) append_vertex({}, {}, out.rig);
  const FaceRig moving = picked_face(head.face, head_vertices(head));
  for (std::size_t v = 0; v < moving.vertices.size(); ++v) {
    const auto run = std::span(moving.deltas).subspan(moving.first[v], moving.first[v + 1] - moving.first[v]);
    append_vertex(moving.vertices[v], {run.begin(), run.end()}, out.rig);
  }
  return out;
}

Result<HeadedFigure> build_headed_figure(const BodyOptions& options, const HeadMeasures& measures, int level,
                                         bool with_shapes) {
  if (auto ok = check_figure_options(options); !ok) return pass_on(std::move(ok));
  BuiltFigure figure = built_figure(options);
  const BodyField field(figure.body);
  Primitive& skin = figure.model.meshes.front().primitives.front();
  double crown = 0.0;
  for (const Vec3& p : skin.positions) crown = std::max(crown, p.y);

  HeadMeasures own = measures;
  own.height = head_share * crown;
  const HeadMaker maker(level);
  auto head = maker.head(own);
  if (!head) return pass_on(std::move(head));
  const double unit = head->metres(), chin = crown - own.height;
  const Vec3 origin(0.0, chin,
                    middle_depth(skin.positions, chin, own.height) -
                        unit * middle_depth(std::span(head->positions).first(head->skin_vertices), 0.0, head_units));

  const NeckPlane plane{rest_place(figure.model, node_named(figure.model, "vc4")) + Vec3(0.0, cut_rise * crown, 0.0),
                        cut_fall};
  const NeckBorder border(skin, cut_above(plane, skin));
  follow_neck(border, origin, own);
  head = maker.head(own);
  if (!head) return pass_on(std::move(head));
  const NeckFit fit = fit_neck(figure, field, border, origin, level, *head);
  close_band(border, *head, fit.ring, origin, skin);

  const auto skull = static_cast<std::uint32_t>(
      std::ranges::find(figure.model.skins.front().joints, node_named(figure.model, "skullbase")) -
      figure.model.skins.front().joints.begin());
  HeadedFigure out{.model = {}, .head = std::move(*head), .origin = origin, .first_vertex = 0};
  out.first_vertex = static_cast<std::uint32_t>(skin.positions.size());
  const std::vector<HeadShape> shapes = with_shapes ? head_shapes(out.head, false) : std::vector<HeadShape>{};
  Model worn = head_model(out.head, nullptr, shapes);
  hang_on(border, skin, fit, skull, out, worn.meshes.front());
  add_to_figure(std::move(worn), figure.model);
  out.model = std::move(figure.model);
  return out;
}

}  // namespace sinew
