#pragma once
/// A limb made by hand: a tube with an elbow, round +Y, that tests bend.

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/model/model.h"

namespace sinew::test {

/// Nodes of tube(). `twist` hangs from `upper` beside `lower` and carries the middle of the upper half.
enum TubeNode { tube_root, tube_upper, tube_twist, tube_lower, tube_hand, tube_skin };

/// Measures of a tube from y = 0 (upper) over y = 1 (lower, the elbow) to y = 2 (hand).
struct TubeShape {
  double radius = 0.2;
  std::size_t rows = 33;     ///< rings of vertices, ends included
  std::size_t columns = 24;  ///< vertices a ring, the first one on +Z
  double blend = 0.25;       ///< to either side of the elbow, where weights pass from upper to lower
  double rest_bend = 0.0;    ///< degrees about x by which the rest pose, not the bind pose, turns the elbow
};

/// A run in the order that Influences asks for: zeros left out, weights falling, then by joint.
inline std::vector<Influence> sorted_run(std::vector<Influence> run) {
  std::erase_if(run, [](const Influence& i) { return i.weight <= 0.0; });
  std::stable_sort(run.begin(), run.end(), [](const Influence& a, const Influence& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
  });
  return run;
}

inline int add_node(Model& model, const std::string& name, int parent, const Transform& rest) {
  Node node;
  node.name = name;
  node.parent = parent;
  node.rest = rest;
  model.nodes.push_back(node);
  const int index = static_cast<int>(model.nodes.size()) - 1;
  (parent >= 0 ? model.nodes[parent].children : model.roots).push_back(index);
  return index;
}

/// Weights at height y on the skin's joints: root, upper, twist, lower, hand. The hand's are 0.
inline std::vector<Influence> tube_weights(const TubeShape& shape, double y) {
  const double lower = smoothstep01((y - 1.0 + shape.blend) / (2.0 * shape.blend));
  const double twist = (1.0 - lower) * std::clamp(2.0 * y - 0.5, 0.0, 1.0);
  return sorted_run({{tube_upper, 1.0 - lower - twist}, {tube_twist, twist}, {tube_lower, lower}});
}

inline Primitive tube_surface(const TubeShape& shape) {
  Primitive skin;
  const auto columns = static_cast<std::uint32_t>(shape.columns);
  for (std::size_t row = 0; row < shape.rows; ++row) {
    const double y = 2.0 * static_cast<double>(row) / static_cast<double>(shape.rows - 1);
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double angle = 2.0 * std::numbers::pi * column / columns;
      const Vec3 out(std::sin(angle), 0.0, std::cos(angle));
      skin.positions.push_back(shape.radius * out + Vec3(0, y, 0));
      skin.normals.push_back(out);
      skin.influences.add_vertex(tube_weights(shape, y));
      if (row + 1 == shape.rows) continue;
      const auto a = static_cast<std::uint32_t>(row) * columns + column;
      const std::uint32_t b = a - column + (column + 1) % columns;
      skin.indices.insert(skin.indices.end(), {a, b, a + columns, a + columns, b, b + columns});
    }
  }
  return skin;
}

/// The bind pose is straight; every joint but a bent elbow rests in it.
inline Model tube(const TubeShape& shape = {}) {
  Model model;
  add_node(model, "root", -1, {});
  add_node(model, "upper", tube_root, {});
  add_node(model, "twist", tube_upper, {.translation = {0, 0.5, 0}});
  add_node(model, "lower", tube_upper,
           {.translation = {0, 1, 0}, .rotation = rotation_xyz_degrees({shape.rest_bend, 0, 0})});
  add_node(model, "hand", tube_lower, {.translation = {0, 1, 0}});
  add_node(model, "skin", -1, {});
  model.nodes[tube_skin].mesh = model.nodes[tube_skin].skin = 0;
  model.meshes.push_back({"tube", {tube_surface(shape)}, {}});
  Skin skin;
  for (const double y : {0.0, 0.0, 0.5, 1.0, 2.0}) {
    skin.joints.push_back(static_cast<int>(skin.joints.size()));
    skin.inverse_bind.push_back(glm::translate(Mat4(1.0), {0, -y, 0}));
  }
  model.skins.push_back(skin);
  return model;
}

/// x to -x.
inline Vec3 mirrored(const Vec3& v) { return {-v.x, v.y, v.z}; }
inline Quat mirrored(const Quat& q) { return {q.w, q.x, -q.y, -q.z}; }
inline Mat4 mirrored(const Mat4& m) {
  const Mat4 flip = glm::scale(Mat4(1.0), {-1, 1, 1});
  return flip * m * flip;
}

/// The character's image in the plane x = 0, joints and skin.
inline Model mirrored(Model model) {
  for (Node& node : model.nodes) {
    node.rest.translation = mirrored(node.rest.translation);
    node.rest.rotation = mirrored(node.rest.rotation);
  }
  for (Skin& skin : model.skins)
    for (Mat4& bind : skin.inverse_bind) bind = mirrored(bind);
  for (Mesh& mesh : model.meshes)
    for (Primitive& primitive : mesh.primitives) {
      for (Vec3& position : primitive.positions) position = mirrored(position);
      for (Vec3& normal : primitive.normals) normal = mirrored(normal);
      for (std::size_t i = 0; i < primitive.indices.size(); i += 3)
        std::swap(primitive.indices[i + 1], primitive.indices[i + 2]);
    }
  return model;
}

}  // namespace sinew::test
