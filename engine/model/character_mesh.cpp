#include "engine/model/character_mesh.h"

#include <map>

#include "engine/model/tangents.h"

namespace sinew {
namespace {

void append_subtree(const Model& model, int root, std::vector<int>& order) {
  std::vector<int> pending{root};
  while (!pending.empty()) {
    const int node = pending.back();
    pending.pop_back();
    order.push_back(node);
    const std::vector<int>& children = model.nodes[node].children;
    pending.insert(pending.end(), children.rbegin(), children.rend());
  }
}

/// What the scene shows, depth first.
std::vector<int> scene_nodes(const Model& model) {
  std::vector<int> nodes;
  for (int root : model.roots) append_subtree(model, root, nodes);
  return nodes;
}

/// Builds a CharacterMesh primitive by primitive.
class Gatherer {
 public:
  explicit Gatherer(const Model& model) : model_(model) { result_.morph_first.push_back(0); }

  void add_node(int node) {
    const Node& drawn = model_.nodes[node];
    if (drawn.mesh < 0) return;
    const Mesh& mesh = model_.meshes[drawn.mesh];
    const auto slot = static_cast<std::uint32_t>(result_.morph_slots.size());
    if (!mesh.primitives.empty())
      for (std::size_t i = 0; i < mesh.primitives.front().morph_targets.size(); ++i)
        result_.morph_slots.push_back({node, i});
    for (const Primitive& primitive : mesh.primitives) add_primitive(node, mesh, primitive, slot);
  }

  CharacterMesh finish() { return std::move(result_); }

 private:
  void add_primitive(int node, const Mesh& mesh, const Primitive& primitive, std::uint32_t first_slot) {
    MeshPart part;
    part.mesh = mesh.name;
    part.node = node;
    part.material = primitive.material;
    part.first_vertex = static_cast<std::uint32_t>(result_.positions.size());
    part.vertex_count = static_cast<std::uint32_t>(primitive.positions.size());
    part.first_index = static_cast<std::uint32_t>(result_.triangles.size());
    part.index_count = static_cast<std::uint32_t>(primitive.indices.size());
    result_.parts.push_back(part);

    append(result_.positions, primitive.positions);
    append(result_.normals, primitive.normals);
    append(result_.texture_coordinates, primitive.texture_coordinates);
    result_.texture_coordinates.resize(result_.positions.size(), Vec2(0.0));
    append_or_fill(result_.second_texture_coordinates, primitive.second_texture_coordinates, part, Vec2(0.0));
    append_or_fill(result_.colours, primitive.colours, part, Vec4(1.0));
    add_tangents(primitive, part);
    for (std::uint32_t index : primitive.indices) result_.triangles.push_back(part.first_vertex + index);
    add_influences(node, primitive);
    add_morphs(primitive, first_slot);
  }

  /// Attributes that most characters lack take no room until a primitive has them.
  template <class T>
  void append_or_fill(std::vector<T>& to, const std::vector<T>& from, const MeshPart& part, const T& filling) {
    if (to.empty() && from.empty()) return;
    to.resize(part.first_vertex, filling);
    append(to, from);
    to.resize(result_.positions.size(), filling);
  }

  void add_tangents(const Primitive& primitive, const MeshPart& part) {
    const Material* material = primitive.material < 0 ? nullptr : &model_.materials[primitive.material];
    const bool relief = material != nullptr && material->normal_texture.there();
    append_or_fill(result_.tangents,
                   !relief                      ? std::vector<Vec4>{}
                   : primitive.tangents.empty() ? generate_tangents(primitive, material->normal_texture)
                                                : primitive.tangents,
                   part, Vec4(1.0, 0.0, 0.0, 1.0));
  }

  void add_influences(int node, const Primitive& primitive) {
    const int skin = model_.nodes[node].skin;
    const bool skinned = skin >= 0 && primitive.influences.vertices() == primitive.positions.size();
    const Influences& source = primitive.influences;
    for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
      std::vector<Influence> run;
      if (skinned)
        for (std::uint32_t i = source.first[v]; i < source.first[v + 1]; ++i)
          run.push_back({skin_palette(skin) + source.entries[i].joint, source.entries[i].weight});
      if (run.empty()) run.push_back({rigid_palette(node), 1.0});
      result_.influences.add_vertex(run);
    }
  }

  void add_morphs(const Primitive& primitive, std::uint32_t first_slot) {
    for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
      for (std::size_t i = 0; i < primitive.morph_targets.size(); ++i) {
        const MorphTarget& target = primitive.morph_targets[i];
        MorphDelta delta{first_slot + static_cast<std::uint32_t>(i)};
        if (!target.positions.empty()) delta.position = target.positions[v];
        if (!target.normals.empty()) delta.normal = target.normals[v];
        if (delta.position != Vec3(0.0) || delta.normal != Vec3(0.0)) result_.morph_deltas.push_back(delta);
      }
      result_.morph_first.push_back(static_cast<std::uint32_t>(result_.morph_deltas.size()));
    }
  }

  /// Palette index of the skin's first joint.
  std::uint32_t skin_palette(int skin) {
    const auto [found, added] = skins_.try_emplace(skin, static_cast<std::uint32_t>(result_.palette.size()));
    if (added) {
      const Skin& source = model_.skins[skin];
      for (std::size_t i = 0; i < source.joints.size(); ++i)
        result_.palette.push_back({source.joints[i], source.inverse_bind[i]});
    }
    return found->second;
  }

  /// Palette index of a node that carries its vertices as they are.
  std::uint32_t rigid_palette(int node) {
    const auto [found, added] = rigid_.try_emplace(node, static_cast<std::uint32_t>(result_.palette.size()));
    if (added) result_.palette.push_back({node, Mat4(1.0)});
    return found->second;
  }

  template <class T>
  static void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
  }

  const Model& model_;
  CharacterMesh result_;
  std::map<int, std::uint32_t> skins_, rigid_;
};

}  // namespace

std::vector<int> hierarchy_order(const Model& model) {
  std::vector<int> order = scene_nodes(model);
  std::vector<bool> seen(model.nodes.size());
  for (int node : order) seen[node] = true;
  for (std::size_t node = 0; node < model.nodes.size(); ++node)
    if (model.nodes[node].parent < 0 && !seen[node]) append_subtree(model, static_cast<int>(node), order);
  return order;
}

CharacterMesh character_mesh(const Model& model) {
  Gatherer gatherer(model);
  for (int node : scene_nodes(model)) gatherer.add_node(node);
  return gatherer.finish();
}

Result<void> check_drawn_vertices(const Model& model) {
  std::size_t vertices = 0;
  for (int node : scene_nodes(model))
    if (model.nodes[node].mesh >= 0)
      for (const Primitive& primitive : model.meshes[model.nodes[node].mesh].primitives)
        vertices += primitive.positions.size();
  if (vertices <= most_drawn_vertices) return {};
  return bad_input("{}: its nodes draw {} vertices in all, {} is the most", model.file, vertices, most_drawn_vertices);
}

}  // namespace sinew
