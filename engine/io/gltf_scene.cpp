#include "engine/io/gltf_scene.h"

#include <algorithm>
#include <set>
#include <unordered_set>

#include "engine/io/gltf_access.h"

namespace sinew::gltf {
namespace {

/// Rounding of matrices that were written as floats stays below this, relative to the largest number.
constexpr double shear_tolerance = 1e-5;
constexpr double unit_tolerance = 1e-3;

Mat4 matrix_from(std::span<const double> numbers) {
  Mat4 m;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) m[column][row] = numbers[static_cast<std::size_t>(4 * column + row)];
  return m;
}

/// True, and the last row set to 0 0 0 1, where it was not.
bool repair_last_row(Mat4& m) {
  const Vec4 row(m[0][3], m[1][3], m[2][3], m[3][3]);
  // Written with four digits by some exporters.
  const bool wrong = glm::length(row - Vec4(0, 0, 0, 1)) > 1e-4;
  for (int column = 0; column < 4; ++column) m[column][3] = column == 3 ? 1.0 : 0.0;
  return wrong;
}

double difference(const Mat4& a, const Mat4& b) {
  double largest = 0.0, apart = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) {
      largest = std::max(largest, std::abs(a[column][row]));
      apart = std::max(apart, std::abs(a[column][row] - b[column][row]));
    }
  return largest > 0.0 ? apart / largest : apart;
}

Quat read_rotation(Document& document, const std::vector<double>& r, std::size_t node) {
  const double largest = std::max({std::abs(r[0]), std::abs(r[1]), std::abs(r[2]), std::abs(r[3])});
  if (largest < 1e-12) {
    document.problem("nodes/{}/rotation: a quaternion of length 0; no rotation is used", node);
    return Quat(1, 0, 0, 0);
  }
  const Quat scaled(r[3] / largest, r[0] / largest, r[1] / largest, r[2] / largest);
  const double length = glm::length(scaled) * largest;
  if (std::abs(length - 1.0) > unit_tolerance)
    document.problem("nodes/{}/rotation: a quaternion of length {:.4g}; normalised", node, length);
  return glm::normalize(scaled);
}

void read_matrix(Document& document, const tinygltf::Node& from, std::size_t index, Node& to) {
  Mat4 m = matrix_from(from.matrix);
  if (repair_last_row(m)) document.problem("nodes/{}/matrix: its last row is not 0 0 0 1; set so", index);
  to.rest = decompose(m);
  if (difference(m, to.rest.matrix()) <= shear_tolerance) return;
  to.matrix = m;
  document.problem("nodes/{}/matrix: has shear, which translation, rotation and scale cannot hold; kept as a matrix",
                   index);
}

Node read_node(Document& document, std::size_t index) {
  const tinygltf::Node& from = document.gltf.nodes[index];
  Node node;
  node.name = from.name;
  node.children = from.children;
  node.mesh = from.mesh;
  node.skin = from.skin;
  node.morph_weights = from.weights;
  if (!from.matrix.empty()) {
    read_matrix(document, from, index, node);
  } else {
    if (!from.translation.empty())
      node.rest.translation = {from.translation[0], from.translation[1], from.translation[2]};
    if (!from.rotation.empty()) node.rest.rotation = read_rotation(document, from.rotation, index);
    if (!from.scale.empty()) node.rest.scale = {from.scale[0], from.scale[1], from.scale[2]};
  }
  if (node.mesh >= 0) return node;
  if (node.skin >= 0) document.problem("nodes/{}: has a skin but no mesh; the skin is ignored here", index);
  if (!node.morph_weights.empty()) document.problem("nodes/{}: has morph weights but no mesh; ignored", index);
  node.skin = -1;
  node.morph_weights.clear();
  return node;
}

Result<void> set_parents(std::vector<Node>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const int child : nodes[i].children) {
      int& parent = nodes[static_cast<std::size_t>(child)].parent;
      if (parent >= 0)
        return bad_input("nodes/{}/children: node {} is a child of node {} already; a node has one parent", i, child,
                         parent);
      parent = static_cast<int>(i);
    }
  }
  return {};
}

/// With one parent each, nodes that no root leads to go round in a circle.
Result<void> check_cycles(const std::vector<Node>& nodes) {
  std::vector<bool> reached(nodes.size(), false);
  std::vector<int> pending;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].parent < 0) pending.push_back(static_cast<int>(i));
  while (!pending.empty()) {
    const auto node = static_cast<std::size_t>(pending.back());
    pending.pop_back();
    reached[node] = true;
    pending.insert(pending.end(), nodes[node].children.begin(), nodes[node].children.end());
  }
  const auto lost = std::ranges::find(reached, false);
  if (lost == reached.end()) return {};
  return bad_input("nodes/{}: is its own ancestor; the hierarchy must not have a cycle", lost - reached.begin());
}

/// The root above each node.
std::vector<int> topmost(const std::vector<Node>& nodes) {
  std::vector<int> top(nodes.size(), -1), pending;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent >= 0) continue;
    pending.push_back(static_cast<int>(i));
    while (!pending.empty()) {
      const auto node = static_cast<std::size_t>(pending.back());
      pending.pop_back();
      top[node] = static_cast<int>(i);
      pending.insert(pending.end(), nodes[node].children.begin(), nodes[node].children.end());
    }
  }
  return top;
}

Result<void> read_inverse_bind(Document& document, int accessor, const std::string& place, Skin& skin) {
  constexpr int floats[] = {TINYGLTF_COMPONENT_TYPE_FLOAT};
  auto numbers =
      read_accessor(document, accessor, place + "/inverseBindMatrices", {TINYGLTF_TYPE_MAT4, floats, "MAT4 of floats"});
  if (!numbers) return pass_on(std::move(numbers));
  if (numbers->count() < skin.joints.size())
    return bad_input("{}/inverseBindMatrices: {} matrices for {} joints", place, numbers->count(), skin.joints.size());
  std::size_t projective = 0, singular = 0;
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    if (!numbers->finite(i))
      return bad_input("{}/inverseBindMatrices: matrix {} has a number that is not finite", place, i);
    Mat4 m = matrix_from(numbers->at(i));
    projective += repair_last_row(m) ? 1 : 0;
    const Mat3 linear(m);
    const double volume = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
    singular += std::abs(glm::determinant(linear)) <= 1e-9 * volume ? 1 : 0;
    skin.inverse_bind.push_back(m);
  }
  if (projective > 0)
    document.problem("{}/inverseBindMatrices: {} matrices whose last row is not 0 0 0 1; set so", place, projective);
  if (singular > 0)
    document.problem("{}/inverseBindMatrices: {} matrices flatten the mesh (their determinant is 0)", place, singular);
  return {};
}

Result<Skin> read_skin(Document& document, const std::vector<int>& top, std::size_t index) {
  const tinygltf::Skin& from = document.gltf.skins[index];
  const std::string place = fmt::format("skins/{}", index);
  Skin skin;
  skin.name = from.name;
  skin.joints = from.joints;
  std::unordered_set<int> distinct;
  for (std::size_t i = 0; i < skin.joints.size(); ++i)
    if (!distinct.insert(skin.joints[i]).second)
      return bad_input("{}/joints/{}: node {} stands in the list already; joints must be distinct", place, i,
                       skin.joints[i]);
  if (std::ranges::any_of(skin.joints, [&](int joint) {
        return top[static_cast<std::size_t>(joint)] != top[static_cast<std::size_t>(skin.joints[0])];
      }))
    document.problem("{}/joints: the joints have no common root; each tree moves on its own", place);
  if (auto taken = document.take_memory(skin.joints.size() * (sizeof(Mat4) + sizeof(int)), place); !taken)
    return pass_on(std::move(taken));
  if (from.inverseBindMatrices >= 0) {
    if (auto read = read_inverse_bind(document, from.inverseBindMatrices, place, skin); !read)
      return pass_on(std::move(read));
  } else {
    skin.inverse_bind.assign(skin.joints.size(), Mat4(1.0));
  }
  return skin;
}

}  // namespace

Transform decompose(const Mat4& matrix) {
  Transform t;
  t.translation = Vec3(matrix[3]);
  Mat3 linear(matrix);
  for (int axis = 0; axis < 3; ++axis) t.scale[axis] = glm::length(linear[axis]);
  // Gram-Schmidt, falling back on any direction at right angles where an axis has no length.
  const Vec3 x = unit_or(linear[0], unit_or(glm::cross(linear[1], linear[2]), Vec3(1, 0, 0)));
  const Vec3 spare = std::abs(x.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  const Vec3 y = unit_or(linear[1] - x * glm::dot(x, linear[1]),
                         unit_or(glm::cross(linear[2], x), unit_or(spare - x * glm::dot(x, spare), Vec3(0, 1, 0))));
  const Vec3 z = glm::cross(x, y);
  const bool mirrored = glm::dot(z, linear[2]) < 0.0;
  if (mirrored) t.scale.x = -t.scale.x;
  t.rotation = glm::normalize(glm::quat_cast(mirrored ? Mat3(-x, y, -z) : Mat3(x, y, z)));
  return t;
}

Result<std::vector<Node>> read_nodes(Document& document) {
  std::vector<Node> nodes;
  nodes.reserve(document.gltf.nodes.size());
  for (std::size_t i = 0; i < document.gltf.nodes.size(); ++i) nodes.push_back(read_node(document, i));
  if (auto parents = set_parents(nodes); !parents) return pass_on(std::move(parents));
  if (auto cycles = check_cycles(nodes); !cycles) return pass_on(std::move(cycles));
  return nodes;
}

Result<std::vector<int>> read_roots(Document& document, const std::vector<Node>& nodes) {
  std::vector<int> roots;
  if (document.gltf.scenes.empty()) {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (nodes[i].parent < 0) roots.push_back(static_cast<int>(i));
    return roots;
  }
  const auto shown = static_cast<std::size_t>(std::max(document.gltf.defaultScene, 0));
  for (std::size_t s = 0; s < document.gltf.scenes.size(); ++s) {
    std::set<int> listed;
    for (const int node : document.gltf.scenes[s].nodes) {
      if (nodes[static_cast<std::size_t>(node)].parent >= 0)
        return bad_input("scenes/{}/nodes: node {} is not a root but a child of node {}", s, node,
                         nodes[static_cast<std::size_t>(node)].parent);
      if (!listed.insert(node).second) return bad_input("scenes/{}/nodes: node {} is listed twice", s, node);
    }
    if (s == shown) roots = document.gltf.scenes[s].nodes;
  }
  return roots;
}

Result<std::vector<Skin>> read_skins(Document& document, const std::vector<Node>& nodes) {
  const std::vector<int> top = topmost(nodes);
  std::vector<Skin> skins;
  for (std::size_t i = 0; i < document.gltf.skins.size(); ++i) {
    auto skin = read_skin(document, top, i);
    if (!skin) return pass_on(std::move(skin));
    skins.push_back(std::move(*skin));
  }
  return skins;
}

}  // namespace sinew::gltf
