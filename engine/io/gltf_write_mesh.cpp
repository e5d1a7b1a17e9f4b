#include <algorithm>

#include "engine/io/gltf_write_parts.h"

namespace sinew {
namespace {

constexpr std::size_t joints_a_set = 4;

/// JOINTS_n and WEIGHTS_n of one primitive, all sets.
struct WrittenInfluences {
  std::vector<std::vector<std::uint32_t>> joints;  ///< [sets][vertices * 4]
  std::vector<std::vector<float>> weights;         ///< [sets][vertices * 4]
};

/// A vertex's run as it is written. A weight that is 0 as a float has no place: glTF asks for joint 0 beside weight 0.
std::vector<Influence> written_run(const Primitive& primitive, std::size_t vertex, int follow_joint) {
  std::vector<Influence> run;
  if (primitive.influences.vertices() != 0)
    for (std::uint32_t i = primitive.influences.first[vertex]; i < primitive.influences.first[vertex + 1]; ++i)
      if (static_cast<float>(primitive.influences.entries[i].weight) > 0.0f)
        run.push_back(primitive.influences.entries[i]);
  if (run.empty()) run.push_back({static_cast<std::uint32_t>(follow_joint), 1.0});
  return run;
}

WrittenInfluences written_influences(const Primitive& primitive, int follow_joint) {
  const std::size_t vertices = primitive.positions.size();
  WrittenInfluences out;
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::vector<Influence> run = written_run(primitive, v, follow_joint);
    while (out.joints.size() * joints_a_set < run.size()) {
      out.joints.emplace_back(vertices * joints_a_set, 0);
      out.weights.emplace_back(vertices * joints_a_set, 0.0f);
    }
    for (std::size_t i = 0; i < run.size(); ++i) {
      const std::size_t set = i / joints_a_set, place = v * joints_a_set + i % joints_a_set;
      out.joints[set][place] = run[i].joint;
      out.weights[set][place] = static_cast<float>(run[i].weight);
    }
  }
  return out;
}

void add_influences(const std::string& place, const Primitive& primitive, int follow_joint, Json& attributes,
                    GlbBuilder& glb) {
  const WrittenInfluences influences = written_influences(primitive, follow_joint);
  for (std::size_t set = 0; set < influences.joints.size(); ++set) {
    const std::string weights = fmt::format("WEIGHTS_{}", set);
    attributes[fmt::format("JOINTS_{}", set)] =
        glb.add_unsigned(influences.joints[set], AccessorShape::vec4, ViewTarget::vertices);
    attributes[weights] = glb.add_floats(fmt::format("{}/{}", place, weights), influences.weights[set],
                                         AccessorShape::vec4, ViewTarget::vertices);
  }
}

/// Whether a texture of the primitive's material is looked up with these coordinates.
bool needs_coordinates(const Model& model, int material, int coordinates) {
  if (material < 0) return false;
  const Material& m = model.materials[material];
  for (const Texture* texture : {&m.base_colour_texture, &m.metallic_roughness_texture, &m.normal_texture,
                                 &m.occlusion_texture, &m.emissive_texture})
    if (texture->there() && texture->coordinates == coordinates) return true;
  return false;
}

void add_coordinates(const std::string& place, const Model& model, const Primitive& primitive, Json& attributes,
                     GlbBuilder& glb) {
  std::vector<float> sets[] = {floats(primitive.texture_coordinates), floats(primitive.second_texture_coordinates)};
  for (int set = 1; set >= 0; --set) {
    // glTF refuses a picture on a primitive without coordinates, and a second set without a first; zeros draw what a
    // missing attribute draws.
    const bool needed = needs_coordinates(model, primitive.material, set) || (set == 0 && !sets[1].empty());
    if (sets[set].empty() && needed) sets[set].resize(2 * primitive.positions.size());
  }
  for (int set = 0; set < 2; ++set) {
    const std::string name = fmt::format("TEXCOORD_{}", set);
    if (!sets[set].empty())
      attributes[name] =
          glb.add_floats(fmt::format("{}/{}", place, name), sets[set], AccessorShape::vec2, ViewTarget::vertices);
  }
}

Json written_attributes(const std::string& place, const Model& model, const Primitive& primitive, const RigMesh& mesh,
                        GlbBuilder& glb) {
  Json attributes;
  attributes["POSITION"] = glb.add_floats(place + "/POSITION", floats(primitive.positions), AccessorShape::vec3,
                                          ViewTarget::vertices, AccessorBounds::written);
  attributes["NORMAL"] =
      glb.add_floats(place + "/NORMAL", floats(primitive.normals), AccessorShape::vec3, ViewTarget::vertices);
  if (!primitive.tangents.empty())
    attributes["TANGENT"] =
        glb.add_floats(place + "/TANGENT", floats(primitive.tangents), AccessorShape::vec4, ViewTarget::vertices);
  add_coordinates(place, model, primitive, attributes, glb);
  if (!primitive.colours.empty())
    attributes["COLOR_0"] =
        glb.add_floats(place + "/COLOR_0", floats(primitive.colours), AccessorShape::vec4, ViewTarget::vertices);
  if (mesh.skinned) add_influences(place, primitive, mesh.follow_joint, attributes, glb);
  return attributes;
}

Json written_target(const std::string& place, const MorphTarget& target, std::size_t vertices, GlbBuilder& glb) {
  std::vector<float> positions = floats(target.positions);
  // A target has to have an attribute, and players take the positions for granted.
  positions.resize(3 * vertices);
  Json out;
  out["POSITION"] = glb.add_sparse_floats(place + "/POSITION", positions, AccessorShape::vec3, AccessorBounds::written);
  if (!target.normals.empty())
    out["NORMAL"] = glb.add_sparse_floats(place + "/NORMAL", floats(target.normals), AccessorShape::vec3);
  return out;
}

Json written_primitive(const std::string& place, const Model& model, const Primitive& primitive, const RigMesh& mesh,
                       GlbBuilder& glb) {
  Json out;
  out["attributes"] = written_attributes(place + "/attributes", model, primitive, mesh, glb);
  out["indices"] = glb.add_unsigned(primitive.indices, AccessorShape::scalar, ViewTarget::indices);
  if (primitive.material >= 0) out["material"] = primitive.material;
  Json targets = Json::array();
  for (std::size_t i = 0; i < primitive.morph_targets.size(); ++i)
    targets.push_back(written_target(fmt::format("{}/targets/{}", place, i), primitive.morph_targets[i],
                                     primitive.positions.size(), glb));
  set_unless_empty(out, "targets", std::move(targets));
  return out;
}

Json target_names(const Primitive& primitive) {
  Json names = Json::array();
  bool any = false;
  for (const MorphTarget& target : primitive.morph_targets) {
    names.push_back(target.name);
    any = any || !target.name.empty();
  }
  return any ? names : Json::array();
}

Json written_mesh(const std::string& place, const Model& model, const RigMesh& rig_mesh, GlbBuilder& glb) {
  const Mesh& mesh = model.meshes[rig_mesh.source];
  Json out, primitives = Json::array();
  if (!mesh.name.empty()) out["name"] = mesh.name;
  for (const Primitive& primitive : mesh.primitives)
    if (has_triangles(primitive))
      primitives.push_back(written_primitive(fmt::format("{}/primitives/{}", place, primitives.size()), model,
                                             primitive, rig_mesh, glb));
  out["primitives"] = std::move(primitives);
  const Primitive& first = mesh.primitives.front();
  if (mesh.morph_weights.size() == first.morph_targets.size()) set_unless_empty(out, "weights", mesh.morph_weights);
  if (Json names = target_names(first); !names.empty()) out["extras"]["targetNames"] = std::move(names);
  return out;
}

}  // namespace

Json written_meshes(const Model& model, const RigLayout& layout, GlbBuilder& glb) {
  Json meshes = Json::array();
  for (const RigMesh& mesh : layout.meshes)
    meshes.push_back(written_mesh(fmt::format("meshes/{}", meshes.size()), model, mesh, glb));
  return meshes;
}

}  // namespace sinew
