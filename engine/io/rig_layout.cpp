#include "engine/io/rig_layout.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace sinew {
namespace {

/// What the model says about drawing one node, and where that is drawn in the rig.
struct DrawnNode {
  int node = -1;
  RigMesh mesh;
  bool moved = false;  ///< drawn by a root of its own, away from the node's place in the hierarchy
};

/// Joints that cannot stand under one root by themselves get this one.
constexpr const char* common_root_name = "skeletons";

class RigLayouter {
 public:
  explicit RigLayouter(const Model& model) : model_(model) {}

  RigLayout run() {
    copy_nodes();
    copy_skins();
    for (std::size_t i = 0; i < model_.nodes.size(); ++i)
      if (model_.nodes[i].matrix) write_shear_as_chain(static_cast<int>(i));
    find_drawn_nodes();
    show_joint_trees();
    join_joint_trees();
    collect_pinned_nodes();
    for (DrawnNode& drawn : drawn_) place(drawn);
    list_meshes();
    order_roots();
    return std::move(layout_);
  }

 private:
  int add_node(RigNode node, int parent) {
    layout_.nodes.push_back(std::move(node));
    parents_.push_back(parent);
    return static_cast<int>(layout_.nodes.size()) - 1;
  }

  int top_of(int node) const {
    while (parents_[node] >= 0) node = parents_[node];
    return node;
  }

  void copy_nodes() {
    for (const Node& node : model_.nodes) {
      const int i = add_node({node.name, node.rest, node.children, -1, -1, node.morph_weights}, node.parent);
      layout_.moved_node.push_back(i);
    }
    layout_.drawing_node.assign(model_.nodes.size(), -1);
    layout_.roots = model_.roots;
  }

  void copy_skins() {
    for (const Skin& skin : model_.skins) {
      skin_index_.push_back(skin.joints.empty() ? -1 : static_cast<int>(layout_.skins.size()));
      if (!skin.joints.empty()) layout_.skins.push_back(skin);
    }
  }

  /// Puts `above` between a node and its parent.
  void insert_above(int node, int above) {
    const int parent = parents_[node];
    std::vector<int>& siblings = parent >= 0 ? layout_.nodes[parent].children : layout_.roots;
    std::replace(siblings.begin(), siblings.end(), node, above);
    layout_.nodes[above].children = {node};
    parents_[above] = parent;
    parents_[node] = above;
  }

  /// A pose turns a sheared node as T R (R_rest^-1 M), so the chain is T R, then R_rest^-1 U S, then V^T, where
  /// M = U S V^T is the singular value decomposition of the matrix's linear part. The node itself is the last of it.
  void write_shear_as_chain(int i) {
    const Node& node = model_.nodes[i];
    const Mat3 linear(*node.matrix);
    Eigen::Matrix3d m;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) m(row, column) = linear[column][row];
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d u = svd.matrixU(), v = svd.matrixV();
    // A rotation has determinant 1; what the factors lose by that, the scale takes over as its sign.
    for (Eigen::Matrix3d* factor : {&u, &v})
      if (factor->determinant() < 0) factor->col(2) *= -1;
    const Eigen::Vector3d s = (u.transpose() * m * v).diagonal();

    const Quat turn = glm::conjugate(node.rest.rotation) * quaternion(u);
    const int stretched = add_node({node.name + " stretch", {Vec3(0.0), turn, Vec3(s(0), s(1), s(2))}}, -1);
    insert_above(i, stretched);
    const int moved = add_node({node.name + " place", {node.rest.translation, node.rest.rotation, Vec3(1.0)}}, -1);
    insert_above(stretched, moved);
    layout_.nodes[i].rest = {Vec3(0.0), quaternion(v.transpose()), Vec3(1.0)};
    layout_.moved_node[i] = moved;
  }

  static Quat quaternion(const Eigen::Matrix3d& rotation) {
    const Eigen::Quaterniond q(rotation);
    return {q.w(), q.x(), q.y(), q.z()};
  }

  /// Depth first from the scene's roots: the order in which the model is drawn.
  void find_drawn_nodes() {
    std::vector<int> open(model_.roots.rbegin(), model_.roots.rend());
    while (!open.empty()) {
      const int i = open.back();
      open.pop_back();
      const std::vector<int>& children = model_.nodes[i].children;
      open.insert(open.end(), children.rbegin(), children.rend());
      if (model_.nodes[i].mesh >= 0) find_drawn_mesh(i);
    }
  }

  void find_drawn_mesh(int i) {
    const Node& node = model_.nodes[i];
    const bool can_skin = node.skin >= 0 && skin_index_[node.skin] >= 0;
    bool any = false, skinned = false, loose = false;
    for (const Primitive& primitive : model_.meshes[node.mesh].primitives) {
      if (!has_triangles(primitive)) continue;
      any = true;
      if (!primitive.influences.entries.empty()) skinned = can_skin;
      const std::vector<std::uint32_t>& first = primitive.influences.first;
      if (primitive.influences.vertices() == 0 || std::adjacent_find(first.begin(), first.end()) != first.end())
        loose = true;
    }
    if (!any) return;
    const int follow = skinned && loose ? follow_joint(i, layout_.skins[skin_index_[node.skin]]) : -1;
    drawn_.push_back({i, {node.mesh, skinned, follow}});
  }

  /// Makes the node a joint with an identity inverse bind matrix, or, where it is one already, a child of it.
  int follow_joint(int i, Skin& skin) {
    int joint = i;
    if (std::find(skin.joints.begin(), skin.joints.end(), i) != skin.joints.end()) {
      joint = add_node({model_.nodes[i].name + " itself"}, i);
      layout_.nodes[i].children.push_back(joint);
    }
    skin.joints.push_back(joint);
    skin.inverse_bind.push_back(Mat4(1.0));
    return static_cast<int>(skin.joints.size()) - 1;
  }

  /// A scene that draws a skinned mesh has to hold the joints. Nothing else that hangs there is drawn.
  void show_joint_trees() {
    for (const DrawnNode& drawn : drawn_) {
      if (!drawn.mesh.skinned) continue;
      for (int joint : layout_.skins[skin_index_[model_.nodes[drawn.node].skin]].joints) {
        const int top = top_of(joint);
        if (std::find(layout_.roots.begin(), layout_.roots.end(), top) == layout_.roots.end())
          layout_.roots.push_back(top);
      }
    }
  }

  void join_joint_trees() {
    std::vector<int> apart;
    for (const Skin& skin : layout_.skins) {
      std::set<int> tops;
      for (int joint : skin.joints) tops.insert(top_of(joint));
      if (tops.size() > 1) apart.insert(apart.end(), tops.begin(), tops.end());
    }
    if (apart.empty()) return;
    const auto is_apart = [&](int node) { return std::find(apart.begin(), apart.end(), node) != apart.end(); };

    const int root = add_node({common_root_name}, -1);
    const auto first = std::find_if(layout_.roots.begin(), layout_.roots.end(), is_apart);
    if (first != layout_.roots.end()) layout_.roots.insert(first, root);
    for (std::size_t i = 0; i < layout_.nodes.size(); ++i) {
      const int node = static_cast<int>(i);
      if (node == root || parents_[node] >= 0 || !is_apart(node)) continue;
      layout_.nodes[root].children.push_back(node);
      parents_[node] = root;
    }
    std::erase_if(layout_.roots, is_apart);
  }

  /// Nodes that something else than their mesh needs where they are.
  void collect_pinned_nodes() {
    for (const Skin& skin : layout_.skins) pinned_.insert(skin.joints.begin(), skin.joints.end());
    for (const Clip& clip : model_.clips)
      for (const Channel& channel : clip.channels)
        if (channel.path != ChannelPath::weights) animated_.insert(layout_.moved_node[channel.node]);
    pinned_.insert(animated_.begin(), animated_.end());
  }

  bool is_identity_root(int node) const {
    const Transform& rest = layout_.nodes[node].rest;
    return parents_[node] < 0 && rest.translation == Vec3(0.0) && rest.rotation == Quat(1, 0, 0, 0) &&
           rest.scale == Vec3(1.0) && !animated_.contains(node);
  }

  void place(DrawnNode& drawn) {
    int& drawing = layout_.drawing_node[drawn.node];
    drawing = drawn.node;
    if (drawn.mesh.skinned && !is_identity_root(drawn.node)) {
      drawn.moved = true;
      drawing = own_root(drawn.node);
    }
    if (drawn.mesh.skinned) layout_.nodes[drawing].skin = skin_index_[model_.nodes[drawn.node].skin];
  }

  /// The node as a root without transform; where it is needed in its place, a new root that takes the mesh over.
  int own_root(int node) {
    RigNode& original = layout_.nodes[node];
    if (!original.children.empty() || pinned_.contains(node)) {
      RigNode root{original.name};
      root.morph_weights = std::exchange(original.morph_weights, {});
      return add_node(std::move(root), -1);
    }
    original.rest = {};
    if (parents_[node] >= 0) std::erase(layout_.nodes[parents_[node]].children, node);
    parents_[node] = -1;
    return node;
  }

  void list_meshes() {
    std::set<RigMesh> distinct;
    for (const DrawnNode& drawn : drawn_) distinct.insert(drawn.mesh);
    layout_.meshes.assign(distinct.begin(), distinct.end());
    for (const DrawnNode& drawn : drawn_)
      layout_.nodes[layout_.drawing_node[drawn.node]].mesh =
          static_cast<int>(std::distance(distinct.begin(), distinct.find(drawn.mesh)));
  }

  /// Drawn nodes that became roots stand beside the tree they came from: before it, or after it once the tree draws
  /// something itself, so that the scene draws its meshes in the model's order wherever roots can express it.
  void order_roots() {
    std::map<int, std::vector<int>> before, after;
    std::set<int> draws;
    for (const DrawnNode& drawn : drawn_) {
      const int top = original_top(drawn.node);
      if (!drawn.moved)
        draws.insert(top);
      else
        (draws.contains(top) ? after : before)[top].push_back(layout_.drawing_node[drawn.node]);
    }
    std::vector<int> ordered;
    for (int root : layout_.roots) {
      const std::vector<int>&first = before[root], &last = after[root];
      ordered.insert(ordered.end(), first.begin(), first.end());
      if (std::find(first.begin(), first.end(), root) == first.end()) ordered.push_back(root);
      ordered.insert(ordered.end(), last.begin(), last.end());
    }
    layout_.roots = std::move(ordered);
  }

  /// The root, as the rig's scene lists it, of the tree in which the model has the node.
  int original_top(int node) const {
    while (model_.nodes[node].parent >= 0) node = model_.nodes[node].parent;
    return top_of(layout_.moved_node[node] == node ? node : layout_.moved_node[node]);
  }

  const Model& model_;
  RigLayout layout_;
  std::vector<int> parents_;     // [layout nodes]
  std::vector<int> skin_index_;  // [model skins] index into layout_.skins, -1 where the skin has no joints
  std::vector<DrawnNode> drawn_;
  std::set<int> pinned_, animated_;
};

}  // namespace

bool has_triangles(const Primitive& primitive) { return !primitive.positions.empty() && !primitive.indices.empty(); }

RigLayout rig_layout(const Model& model) { return RigLayouter(model).run(); }

}  // namespace sinew
