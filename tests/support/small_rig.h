#pragma once
/// A rig made by hand that has a bit of everything, for tests to write, read and bend.

#include <cmath>
#include <random>
#include <string>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "engine/io/png.h"
#include "engine/model/model.h"

namespace sinew::test {

constexpr std::size_t joint_count = 9;
constexpr int body_node = 1, hip = 2, clothes_node = 3, prop_node = 5, first_joint = 6;

inline int link(Model& model, int parent, Node node) {
  const int index = static_cast<int>(model.nodes.size());
  node.parent = parent;
  model.nodes.push_back(node);
  (parent >= 0 ? model.nodes[parent].children : model.roots).push_back(index);
  return index;
}

inline Node named(const std::string& name, const Transform& rest = {}) {
  Node node;
  node.name = name;
  node.rest = rest;
  return node;
}

inline Node drawing(const std::string& name, int mesh, int skin, const Transform& rest = {}) {
  Node node = named(name, rest);
  node.mesh = mesh;
  node.skin = skin;
  return node;
}

inline Transform moved(double x, double y, double z) { return {{x, y, z}}; }

/// A strip of quads along y; vertex v has 1 + v mod `most` influences.
inline Primitive strip(std::size_t rows, std::size_t most, std::size_t targets) {
  Primitive out;
  std::mt19937 random(3);
  const auto some = [&random] { return static_cast<float>(random() % 1000) / 1000.0f; };
  for (std::size_t v = 0; v < 2 * rows; ++v) {
    out.positions.push_back({static_cast<float>(v % 2), 0.1f * static_cast<float>(v / 2), some()});
    out.normals.push_back({0, 0, 1});
    out.texture_coordinates.push_back({some(), some()});
    std::vector<Influence> run;
    const std::size_t count = most == 0 ? 0 : 1 + v % most;
    for (std::size_t i = 0; i < count; ++i)
      run.push_back({static_cast<std::uint32_t>((v + i) % joint_count),
                     2.0 * static_cast<double>(count - i) / static_cast<double>(count * (count + 1))});
    if (most != 0) out.influences.add_vertex(run);
  }
  for (std::uint32_t v = 0; v + 3 < 2 * rows; v += 2)
    out.indices.insert(out.indices.end(), {v, v + 1, v + 2, v + 2, v + 1, v + 3});
  for (std::size_t t = 0; t < targets; ++t) {
    MorphTarget target{t == 0 ? "smile" : "frown", {}, {}};
    for (std::size_t v = 0; v < 2 * rows; ++v) target.positions.push_back({some(), some(), some()});
    if (t == 1) target.normals.assign(2 * rows, Vec3(0.25, 0, 0));
    out.morph_targets.push_back(target);
  }
  out.material = 0;
  return out;
}

inline Channel channel(int node, ChannelPath path, Interpolation interpolation, std::size_t width) {
  Channel out{node, path, interpolation, width, {0.0, 0.5, 1.25}, {}};
  const std::size_t blocks = interpolation == Interpolation::cubic_spline ? 9 : 3;
  for (std::size_t i = 0; i < blocks; ++i) {
    const float turn = 0.25f * static_cast<float>(i);
    const bool tangent = blocks == 9 && i % 3 != 1;
    for (std::size_t k = 0; k < width; ++k)
      out.values.push_back(tangent                         ? 0.125 * static_cast<double>(k)
                           : path == ChannelPath::rotation ? (k == 0   ? std::sin(turn)
                                                              : k == 3 ? std::cos(turn)
                                                                       : 0.0f)
                                                           : 1.0 + 0.25 * static_cast<double>(i + k));
  }
  for (double& value : out.values) value = static_cast<float>(value);
  return out;
}

/// Two skinned meshes on one skin (one on a leaf, one on a node with a child), up to 8 influences, morph targets, an
/// unskinned prop in a joint's hand, three clips and a material with a picture.
inline Model two_meshes_on_one_skin() {
  Model model;
  const int root = link(model, -1, named("root", {{1, 2, 3}, glm::angleAxis(0.5, Vec3(0, 1, 0)), Vec3(2.0)}));
  link(model, root, drawing("body", 0, 0));
  model.nodes[body_node].morph_weights = {0.25, 0.5};
  link(model, root, named("hip", moved(0, 0.5, 0)));
  link(model, root, drawing("clothes", 1, 0, moved(5, 5, 5)));
  link(model, clothes_node, named("brooch", moved(0, 0, 1)));
  link(model, hip, drawing("prop", 2, -1, moved(0.5, 0, 0)));
  int parent = hip;
  for (std::size_t i = 0; i < joint_count; ++i)
    parent = link(model, parent, named(fmt::format("joint {}", i), moved(0, 0.25, 0)));

  Skin skin{"skin", {}, {}};
  for (std::size_t i = 0; i < joint_count; ++i) {
    skin.joints.push_back(first_joint + static_cast<int>(i));
    skin.inverse_bind.push_back(glm::translate(Mat4(1.0), Vec3(0, -0.25 * static_cast<double>(i), 0)));
  }
  model.skins = {skin};
  model.meshes = {{"body", {strip(10, 8, 2), strip(4, 3, 2)}, {0.0, 1.0}},
                  {"clothes", {strip(6, 5, 0)}, {}},
                  {"prop", {strip(3, 0, 0)}, {}}};
  model.clips = {{"Stepped", {channel(hip, ChannelPath::translation, Interpolation::step, 3)}, 1.25},
                 {"Linear",
                  {channel(first_joint, ChannelPath::rotation, Interpolation::linear, 4),
                   channel(body_node, ChannelPath::weights, Interpolation::linear, 2)},
                  1.25},
                 {"Spline",
                  {channel(first_joint + 2, ChannelPath::scale, Interpolation::cubic_spline, 3),
                   channel(first_joint, ChannelPath::rotation, Interpolation::cubic_spline, 4)},
                  1.25}};
  Material material;
  material.name = "cloth";
  material.base_colour = {0.5, 0.25, 1.0, 0.75};
  material.base_colour_texture.image = 0;
  material.base_colour_texture.wrap_u = Wrap::mirror;
  material.base_colour_texture.wrap_v = Wrap::clamp;
  material.base_colour_texture.nearest_filter = material.double_sided = true;
  material.alpha_mode = AlphaMode::mask;
  material.alpha_cutoff = 0.25;
  model.materials = {material};
  model.images = {{"checks", *encode_png(Bytes(16, 200), 2, 2)}};
  return model;
}

constexpr std::size_t dressed_mesh = 1;

/// The same with a second material that has all that a material can have, on the clothes, whose vertices carry all that
/// vertices can carry: tangents, two sets of texture coordinates, colours. Numbers are such that floats hold them.
inline Model dressed_meshes() {
  Model model = two_meshes_on_one_skin();
  Material material;
  material.name = "all";
  material.base_colour = {0.25, 0.5, 0.75, 0.5};
  material.metallic = 0.125;
  material.roughness = 0.375;
  material.normal_scale = 0.5;
  material.occlusion_strength = 0.625;
  material.emissive = {2, 4, 8};
  material.specular = 0.5;
  material.specular_colour = {2, 0.5, 0.25};
  material.double_sided = true;
  material.alpha_mode = AlphaMode::blend;
  material.base_colour_texture.image = 0;
  material.metallic_roughness_texture = {1, 1, Wrap::clamp, Wrap::mirror, false, {0.5, 0.25}, 0.75, {2, 0.5}};
  material.normal_texture = {2, 0, Wrap::repeat, Wrap::repeat, true, {}, 0.5, Vec2(1)};
  material.occlusion_texture = {3, 1, Wrap::mirror, Wrap::clamp, false, {0, 0.5}, 0.0, Vec2(1)};
  material.emissive_texture = {4, 0, Wrap::repeat, Wrap::clamp, false, {}, 0.0, {1, 4}};
  for (int i = 1; i < 5; ++i) {
    const auto grey = static_cast<unsigned char>(40 * i);
    model.images.push_back({fmt::format("picture {}", i), *encode_png(Bytes(16, grey), 2, 2)});
  }
  Primitive& clothes = model.meshes[dressed_mesh].primitives[0];
  clothes.material = static_cast<int>(model.materials.size());
  model.materials.push_back(material);
  for (std::size_t v = 0; v < clothes.positions.size(); ++v) {
    const double share = static_cast<double>(v % 8) / 8.0;
    clothes.tangents.push_back(v % 2 == 0 ? Vec4(1, 0, 0, 1) : Vec4(0, -1, 0, -1));
    clothes.second_texture_coordinates.push_back({share, 1.0 - share});
    clothes.colours.push_back({share, 0.5, 1.0 - share, 1.0 - 0.5 * share});
  }
  return model;
}

}  // namespace sinew::test
