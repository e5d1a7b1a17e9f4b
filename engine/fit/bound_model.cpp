#include "engine/fit/bound_model.h"

#include <utility>

#include "engine/deform/ssd.h"
#include "engine/rig/joint_tree.h"
#include "engine/rig/pose.h"

namespace sinew {
namespace {

/// A joint that squeezes space to less than this share cannot be bound to.
constexpr double least_volume = 1e-12;

Result<Skin> rest_skin(const Model& skeleton) {
  const std::vector<Mat4> global = global_transforms(skeleton, hierarchy_order(skeleton), rest_pose(skeleton));
  const JointTree tree(skeleton, global);
  Skin skin;
  skin.name = skeleton.skins.empty() ? "skin" : skeleton.skins.front().name;
  for (const int node : hierarchy_order(skeleton)) {
    if (!tree.is_joint(node) || (skeleton.skins.empty() && skeleton.nodes[node].mesh >= 0)) continue;
    const double volume = std::abs(glm::determinant(Mat3(global[node])));
    if (!(volume > least_volume) || !std::isfinite(volume))
      return bad_input("{}, nodes/{} \"{}\": its rest transform has no inverse; expected a scale other than 0",
                       skeleton.file, node, skeleton.nodes[node].name);
    skin.joints.push_back(node);
    skin.inverse_bind.push_back(glm::inverse(global[node]));
  }
  if (skin.joints.empty())
    return bad_input("{}: has no skeleton; expected joints: nodes without a mesh, or a skin", skeleton.file);
  return skin;
}

/// Where every drawn vertex stands at rest, and the 3x3 that carried it there.
struct StandingMesh {
  CharacterMesh mesh;
  std::vector<Vec3> positions, normals;
  std::vector<Mat3> blend;
};

StandingMesh stand(const Model& model) {
  StandingMesh out{character_mesh(model), {}, {}, {}};
  const std::size_t vertices = out.mesh.vertices();
  out.positions.resize(vertices);
  out.normals.resize(vertices);
  out.blend.resize(vertices);
  const std::vector<Mat4> global = global_transforms(model, hierarchy_order(model), rest_pose(model));
  const std::vector<Mat34> palette = palette_transforms(out.mesh, global);
  SsdJob{{out.mesh.positions, out.mesh.normals, palette, out.mesh.influences}, {out.positions, out.normals, out.blend}}
      .run();
  return out;
}

/// A primitive's vertices where the standing mesh has them, from `first` on.
Primitive standing(Primitive primitive, const StandingMesh& stands, std::size_t first, bool with_morphs) {
  primitive.influences = {};
  if (!with_morphs) primitive.morph_targets.clear();
  for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
    const Mat3& carried = stands.blend[first + i];
    primitive.positions[i] = stands.positions[first + i];
    primitive.normals[i] = stands.normals[first + i];
    if (!primitive.tangents.empty())
      primitive.tangents[i] = tangent_in_plane(carry_tangent(carried, primitive.tangents[i]), primitive.normals[i]);
    for (MorphTarget& target : primitive.morph_targets) {
      if (!target.positions.empty()) target.positions[i] = carried * target.positions[i];
      if (!target.normals.empty()) target.normals[i] = carried * target.normals[i];
    }
    primitive.influences.add_vertex({{0, 1.0}});
  }
  return primitive;
}

/// Nodes that draw a mesh without a skin, on a joint or somewhere below one: what a character holds or wears.
std::vector<bool> hung_nodes(const Model& model, const Skin& skin) {
  std::vector<bool> joint(model.nodes.size()), hung(model.nodes.size());
  for (const int node : skin.joints) joint[node] = true;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    if (model.nodes[i].mesh < 0 || model.nodes[i].skin >= 0) continue;
    for (int above = static_cast<int>(i); above >= 0 && !hung[i]; above = model.nodes[above].parent)
      hung[i] = joint[above];
  }
  return hung;
}

}  // namespace

Result<Model> bound_model(const Model& mesh, const Model& skeleton, const BindOptions& options) {
  auto skin = rest_skin(skeleton);
  if (!skin) return pass_on(std::move(skin));
  const StandingMesh stands = stand(mesh);
  const std::vector<bool> kept = options.keep_hung && mesh.file == skeleton.file
                                     ? hung_nodes(skeleton, *skin)
                                     : std::vector<bool>(skeleton.nodes.size());

  Model out;
  out.file = mesh.file;
  out.nodes = skeleton.nodes;
  out.roots = skeleton.roots;
  out.clips = skeleton.clips;
  out.vrm_bones = skeleton.vrm_bones;
  out.materials = mesh.materials;
  out.images = mesh.images;
  for (std::size_t i = 0; i < out.nodes.size(); ++i) {
    Node& node = out.nodes[i];
    if (kept[i]) {
      out.meshes.push_back(mesh.meshes[node.mesh]);
      node.mesh = static_cast<int>(out.meshes.size()) - 1;
      continue;
    }
    node.mesh = node.skin = -1;
    node.morph_weights.clear();
  }
  for (Clip& clip : out.clips)
    std::erase_if(clip.channels,
                  [&](const Channel& channel) { return channel.path == ChannelPath::weights && !kept[channel.node]; });
  out.skins.push_back(std::move(*skin));

  int drawn = -1;
  std::size_t in_mesh = 0;
  bool any = false;
  for (const MeshPart& part : stands.mesh.parts) {
    if (mesh.file == skeleton.file && kept[part.node]) continue;
    any = any || part.vertex_count > 0;
    const Node& source = mesh.nodes[part.node];
    const Mesh& from = mesh.meshes[source.mesh];
    if (part.node != drawn) {
      drawn = part.node;
      in_mesh = 0;
      Node node;
      node.name = source.name;
      node.mesh = static_cast<int>(out.meshes.size());
      node.skin = 0;
      if (options.morphs) node.morph_weights = source.morph_weights;
      out.roots.push_back(static_cast<int>(out.nodes.size()));
      out.nodes.push_back(std::move(node));
      out.meshes.push_back({from.name, {}, options.morphs ? from.morph_weights : std::vector<double>{}});
    }
    Primitive& primitive = out.meshes.back().primitives.emplace_back(
        standing(from.primitives[in_mesh++], stands, part.first_vertex, options.morphs));
    if (part.vertex_count > 0 && glm::determinant(stands.blend[part.first_vertex]) < 0.0)
      for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3)
        std::swap(primitive.indices[i + 1], primitive.indices[i + 2]);
  }
  if (!any) return bad_input("{}: draws no vertices that could be bound; expected a mesh", mesh.file);
  return out;
}

}  // namespace sinew
