#pragma once
/// A model: what a glTF file holds, as plain data, every index already checked. Lengths in world units, Y up.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/math.h"
#include "engine/model/material.h"

namespace sinew {

/// One joint of one vertex.
struct Influence {
  std::uint32_t joint = 0;  ///< index into the skin's joint list, or, in a CharacterMesh, into its palette
  double weight = 0.0;      ///< > 0; the weights of a vertex sum to 1
};

constexpr std::size_t max_influences = 8;

/// The influences of all vertices, one run after another. In a run no joint stands twice, weights fall, and equal
/// weights stand in the order of the joint list: the first is the vertex's bone (engine/definitions.md 6). A run may be
/// empty: such a vertex follows its mesh's node.
struct Influences {
  std::vector<std::uint32_t> first{0};  ///< [vertices + 1] where each vertex's run starts in `entries`
  std::vector<Influence> entries;

  std::size_t vertices() const { return first.size() - 1; }
  /// Appends a vertex with this run.
  void add_vertex(const std::vector<Influence>& run) {
    entries.insert(entries.end(), run.begin(), run.end());
    first.push_back(static_cast<std::uint32_t>(entries.size()));
  }
};

/// A blend shape: what is added to each vertex at weight 1. Either list may be empty (no change).
struct MorphTarget {
  std::string name;
  std::vector<Vec3> positions;  ///< [vertices] or empty
  std::vector<Vec3> normals;    ///< [vertices] or empty
};

/// Triangles that share a material.
struct Primitive {
  std::vector<Vec3> positions;            ///< [vertices] bind pose, model units
  std::vector<Vec3> normals;              ///< [vertices] unit length, never empty
  std::vector<Vec4> tangents;             ///< [vertices] unit length, w: side of the bitangent, 1 or -1; or empty
  std::vector<Vec2> texture_coordinates;  ///< [vertices] Texture::coordinates 0, or empty
  std::vector<Vec2> second_texture_coordinates;  ///< [vertices] Texture::coordinates 1, or empty
  std::vector<Vec4> colours;                     ///< [vertices] linear RGBA, factors of the base colour, or empty
  Influences influences;               ///< vertices() == vertices, joints of the skin; or vertices() == 0: unskinned
  std::vector<std::uint32_t> indices;  ///< three a triangle
  std::vector<MorphTarget> morph_targets;
  int material = -1;  ///< index into Model::materials, -1: the default
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;  ///< all with the same number of morph targets
  std::vector<double> morph_weights;  ///< default weight of each morph target
};

/// A place in the hierarchy; a joint is a node that a skin names.
struct Node {
  std::string name;
  int parent = -1;
  std::vector<int> children;
  Transform rest;              ///< local transform of the file's rest pose
  std::optional<Mat4> matrix;  ///< set only where the file's local matrix has shear, which `rest` cannot hold
  int mesh = -1;
  int skin = -1;                      ///< only where mesh >= 0
  std::vector<double> morph_weights;  ///< overrides the mesh's, or empty

  Mat4 rest_local() const { return matrix ? *matrix : rest.matrix(); }
};

struct Skin {
  std::string name;
  std::vector<int> joints;         ///< distinct node indices
  std::vector<Mat4> inverse_bind;  ///< [joints] bind pose to joint space
};

enum class Interpolation { step, linear, cubic_spline };
enum class ChannelPath { translation, rotation, scale, weights };

/// One animated property of one node.
struct Channel {
  int node = -1;
  ChannelPath path = ChannelPath::translation;
  Interpolation interpolation = Interpolation::linear;
  std::size_t width = 3;      ///< numbers a key: 3, 4 (x, y, z, w), or the number of morph targets
  std::vector<double> times;  ///< [keys] seconds, strictly rising
  std::vector<double>
      values;  ///< [keys * width], or [keys * 3 * width] for cubic_spline: in-tangent, value, out-tangent
};

struct Clip {
  std::string name;
  std::vector<Channel> channels;
  double duration = 0.0;  ///< seconds: the last key of any channel
};

struct Model {
  std::string file;  ///< as it was asked for, for messages
  std::vector<Node> nodes;
  std::vector<int> roots;  ///< of the scene that is shown, in its order
  std::vector<Mesh> meshes;
  std::vector<Skin> skins;
  std::vector<Clip> clips;
  std::vector<Material> materials;
  std::vector<EncodedImage> images;
  std::map<std::string, int> vrm_bones;  ///< humanoid name (VRM 1.0 spelling) -> node, from the file's own VRM map
  std::vector<std::string> problems;     ///< what was repaired, cut or left out on reading, for people
};

/// A model of one mesh on one node, both of the mesh's name; materials are still to be added.
Model single_mesh_model(Mesh mesh);

}  // namespace sinew
