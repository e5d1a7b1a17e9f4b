#include "engine/io/gltf_write.h"

#include "engine/io/gltf_write_parts.h"

namespace sinew {
namespace {

constexpr std::size_t most_joints = 65536;  // a joint's index is written as 16 bits

template <class Vector>
std::span<const float> as_floats(const std::vector<Vector>& vectors) {
  return {reinterpret_cast<const float*>(vectors.data()), vectors.size() * Vector::length()};
}

int add_difference(const std::string& place, const std::vector<Vec3f>& from, const std::vector<Vec3f>& to,
                   AccessorBounds bounds, GlbBuilder& glb) {
  std::vector<Vec3f> difference(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) difference[i] = to[i] - from[i];
  return glb.add_floats(place, as_floats(difference), AccessorShape::vec3, ViewTarget::vertices, bounds);
}

Json baked_targets(const BakedMesh& mesh, GlbBuilder& glb) {
  Json targets = Json::array();
  const BakedFrame& base = mesh.frames.front();
  for (std::size_t i = 0; i < mesh.frames.size(); ++i) {
    const BakedFrame& frame = mesh.frames[i];
    const std::string place = fmt::format("frame {} of the range", i);
    targets.push_back(
        {{"POSITION",
          add_difference(place + ", positions", base.positions, frame.positions, AccessorBounds::written, glb)},
         {"NORMAL", add_difference(place + ", normals", base.normals, frame.normals, AccessorBounds::omitted, glb)}});
  }
  return targets;
}

Json baked_primitive(const BakedMesh& mesh, GlbBuilder& glb) {
  const BakedFrame& base = mesh.frames.front();
  Json attributes;
  attributes["POSITION"] = glb.add_floats("positions", as_floats(base.positions), AccessorShape::vec3,
                                          ViewTarget::vertices, AccessorBounds::written);
  attributes["NORMAL"] = glb.add_floats("normals", as_floats(base.normals), AccessorShape::vec3, ViewTarget::vertices);
  if (!mesh.texture_coordinates.empty())
    attributes["TEXCOORD_0"] = glb.add_floats("texture coordinates", as_floats(mesh.texture_coordinates),
                                              AccessorShape::vec2, ViewTarget::vertices);
  Json primitive;
  primitive["attributes"] = std::move(attributes);
  primitive["indices"] = glb.add_unsigned(mesh.triangles, AccessorShape::scalar, ViewTarget::indices);
  if (mesh.frames.size() > 1) primitive["targets"] = baked_targets(mesh, glb);
  return primitive;
}

/// At frame i's time target i stands alone at weight 1.
Json baked_animation(const BakedMesh& mesh, GlbBuilder& glb) {
  const std::size_t frames = mesh.frames.size();
  std::vector<float> weights(frames * frames, 0.0f);
  for (std::size_t i = 0; i < frames; ++i) weights[i * frames + i] = 1.0f;
  const int input = add_times("animation \"baked\"", mesh.times, glb);
  const int output = glb.add_floats("animation \"baked\"", weights, AccessorShape::scalar, ViewTarget::none);
  Json animation;
  animation["name"] = "baked";
  animation["channels"] = Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}});
  animation["samplers"] = Json::array({{{"input", input}, {"output", output}, {"interpolation", "LINEAR"}}});
  return animation;
}

std::vector<double> numbers(const Vec3& v) { return {v.x, v.y, v.z}; }

Json written_node(const RigNode& node, const Model& model, const RigLayout& layout) {
  Json out = Json::object();
  if (!node.name.empty()) out["name"] = node.name;
  const Transform& rest = node.rest;
  if (rest.translation != Vec3(0.0)) out["translation"] = numbers(rest.translation);
  if (rest.rotation != Quat(1, 0, 0, 0))
    out["rotation"] = {rest.rotation.x, rest.rotation.y, rest.rotation.z, rest.rotation.w};
  if (rest.scale != Vec3(1.0)) out["scale"] = numbers(rest.scale);
  set_unless_empty(out, "children", node.children);
  if (node.skin >= 0) out["skin"] = node.skin;
  if (node.mesh < 0) return out;
  out["mesh"] = node.mesh;
  const Mesh& mesh = model.meshes[layout.meshes[node.mesh].source];
  if (node.morph_weights.size() == mesh.primitives.front().morph_targets.size())
    set_unless_empty(out, "weights", node.morph_weights);
  return out;
}

Json written_skin(const std::string& place, const Skin& skin, GlbBuilder& glb) {
  if (skin.joints.size() > most_joints)
    glb.fail(fmt::format("{}: {} joints are more than the {} that a rig can be written with", place, skin.joints.size(),
                         most_joints));
  std::vector<float> matrices;
  for (const Mat4& m : skin.inverse_bind)
    for (int column = 0; column < 4; ++column)
      // The last row of an affine matrix is written exactly, as glTF asks, whatever rounding left there.
      for (int row = 0; row < 4; ++row)
        matrices.push_back(row < 3 ? static_cast<float>(m[column][row]) : (column == 3 ? 1.0f : 0.0f));
  Json out = Json::object();
  if (!skin.name.empty()) out["name"] = skin.name;
  out["joints"] = skin.joints;
  out["inverseBindMatrices"] =
      glb.add_floats(place + "/inverseBindMatrices", matrices, AccessorShape::mat4, ViewTarget::none);
  return out;
}

}  // namespace

Result<Bytes> baked_glb(const BakedMesh& mesh, std::string_view name) {
  GlbBuilder glb;
  glb.json["scene"] = 0;
  glb.json["scenes"] = Json::array({{{"nodes", Json::array({0})}}});
  Json node = Json::object();
  if (!name.empty()) node["name"] = name;
  if (mesh.triangles.empty() || mesh.frames.front().positions.empty()) {
    glb.json["nodes"] = Json::array({node});
    return glb.finish();
  }
  node["mesh"] = 0;
  glb.json["nodes"] = Json::array({node});
  Json written = Json::object();
  if (!name.empty()) written["name"] = name;
  written["primitives"] = Json::array({baked_primitive(mesh, glb)});
  glb.json["meshes"] = Json::array({written});
  if (mesh.frames.size() > 1) glb.json["animations"] = Json::array({baked_animation(mesh, glb)});
  return glb.finish();
}

void write_rig(const Model& model, GlbBuilder& glb) {
  const RigLayout layout = rig_layout(model);
  if (!layout.roots.empty()) {
    glb.json["scene"] = 0;
    glb.json["scenes"] = Json::array({{{"nodes", layout.roots}}});
  }
  Json nodes = Json::array(), skins = Json::array();
  for (const RigNode& node : layout.nodes) nodes.push_back(written_node(node, model, layout));
  set_unless_empty(glb.json, "nodes", std::move(nodes));
  set_unless_empty(glb.json, "meshes", written_meshes(model, layout, glb));
  for (std::size_t i = 0; i < layout.skins.size(); ++i)
    skins.push_back(written_skin(fmt::format("skins/{}", i), layout.skins[i], glb));
  set_unless_empty(glb.json, "skins", std::move(skins));
  set_unless_empty(glb.json, "animations", written_clips(model, layout, glb));
  write_materials(model, glb);
}

Result<Bytes> rig_glb(const Model& model) {
  GlbBuilder glb;
  write_rig(model, glb);
  return glb.finish();
}

}  // namespace sinew
