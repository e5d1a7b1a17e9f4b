#include "engine/face/face_shapes.h"

#include <algorithm>
#include <map>
#include <set>

#include "engine/core/parallel.h"

namespace sinew {
namespace {

/// The size of one eyeball that lids on their straight way from rest to `posed` need. A lid that turns keeps its
/// distance from the eyeball's centre; by what a straight one comes nearer than that, and below the ball's surface, the
/// ball gives way. How near a lid lies at either end is the mesh's own matter.
double clear_eye_share(const FaceRig& face, const std::vector<Vec3>& rest, const std::vector<Vec3>& posed, int eye) {
  constexpr int steps = 20;
  constexpr double gap = 0.004;
  const Vec3& centre = face.eye_centres[static_cast<std::size_t>(eye)];
  double share = 1.0;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const FaceVertex& vertex = face.vertices[v];
    if (vertex.eye != eye || vertex.least_distance == 0.0 || posed[v] == rest[v]) continue;
    const double first = glm::distance(rest[v], centre), last = glm::distance(posed[v], centre);
    for (int i = 1; i < steps; ++i) {
      const double t = double(i) / steps;
      const double distance = glm::distance(glm::mix(rest[v], posed[v], t), centre);
      const double wanted = std::min(face.eye_radius + gap, glm::mix(first, last, t));
      // Of the ball's share 1 - t (1 - s).
      share = std::min(share, 1.0 - (wanted - distance) / (face.eye_radius * t));
    }
  }
  return std::max(share, least_eye_share);
}

/// The mesh's bind pose in the face's drawing units.
HeadShape rest_shape_of(const CharacterMesh& mesh) {
  const FacePlace& place = mesh.face->place;
  const Mat3 to_face = glm::transpose(place.axes);
  HeadShape out;
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    out.positions.push_back(to_face * (mesh.positions[v] - place.origin) / place.unit);
    out.normals.push_back(to_face * mesh.normals[v]);
  }
  return out;
}

}  // namespace

std::string channel_shape_name(std::size_t i, bool positive) {
  return channel_word(static_cast<FaceChannel>(i)) + (positive ? "+" : "-");
}

std::vector<ShapeRecipe> shape_recipes(const FaceRig& face, bool strict) {
  std::vector<ShapeRecipe> out;
  for (std::size_t i = 0; i < face_channels; ++i)
    for (const bool positive : {true, false}) {
      FaceChannels far{};
      // Beyond any limit: held there, or at 0 where the channel cannot go that way alone.
      far[i] = positive ? 1e3 : -1e3;
      const FaceChannels held = hold_at_limits(face, far).channels;
      if (held[i] != 0.0) out.push_back({channel_shape_name(i, positive), {}, held, FaceHalf::both});
    }
  for (const auto list : {expressions(), arkit_shapes()})
    for (const FacePreset& e : list) {
      const FaceChannels from = for_head(face, e.from);
      FaceChannels to = for_head(face, e.channels(strict));
      for (std::size_t i = 0; i < face_channels; ++i) to[i] += from[i];
      out.push_back({e.name, hold_at_limits(face, from).channels, hold_at_limits(face, to).channels, e.half});
    }
  return out;
}

HeadShape shape_of(const FaceRig& face, const HeadShape& rest, const ShapeRecipe& recipe,
                   const std::function<HeadShape(const FaceChannels&)>& posed) {
  HeadShape out = posed(recipe.to);
  out.name = recipe.name;
  const std::array shares{clear_eye_share(face, rest.positions, out.positions, 0),
                          clear_eye_share(face, rest.positions, out.positions, 1)};
  for (std::size_t v = 0; v < out.positions.size(); ++v) {
    const FaceVertex& vertex = face.vertices[v];
    if (!vertex.ball) continue;
    const auto eye = static_cast<std::size_t>(vertex.eye);
    const Vec3& centre = face.eye_centres[eye];
    if (shares[eye] < 1.0) out.positions[v] = centre + shares[eye] * (out.positions[v] - centre);
  }
  if (recipe.from == FaceChannels{} && recipe.half == FaceHalf::both) return out;

  constexpr double blend_width = 0.15;
  const HeadShape from = posed(recipe.from);
  for (std::size_t v = 0; v < out.positions.size(); ++v) {
    const double to_left = smoothstep01(0.5 + 0.5 * rest.positions[v].x / blend_width);
    const double part = recipe.half == FaceHalf::both ? 1.0 : (recipe.half == FaceHalf::left ? to_left : 1.0 - to_left);
    out.positions[v] = rest.positions[v] + part * (out.positions[v] - from.positions[v]);
    out.normals[v] = rest.normals[v] + part * (out.normals[v] - from.normals[v]);
  }
  return out;
}

void add_face_shapes(const CharacterMesh& mesh, Model& model) {
  const FaceRig& rig = mesh.face->rig;
  const FacePlace& place = mesh.face->place;
  const HeadShape rest = rest_shape_of(mesh);
  const auto posed = [&rig, &rest](const FaceChannels& channels) {
    const FaceState state = face_state(rig, channels);
    HeadShape out{"", rest.positions, rest.normals};
    FaceJob{rig, state, rest.positions, rest.normals, out.positions, out.normals}.run();
    return out;
  };
  const std::vector<ShapeRecipe> recipes = shape_recipes(rig, false);
  std::vector<HeadShape> shapes(recipes.size());
  parallel_for(
      recipes.size(), [&](std::size_t i) { shapes[i] = shape_of(mesh.face->rig, rest, recipes[i], posed); }, 1);

  std::map<int, std::size_t> primitives_of;  // node -> primitives seen
  std::map<int, int> drawn_by;               // mesh -> the first node that draws it
  for (const MeshPart& part : mesh.parts) {
    const int drawn = model.nodes[part.node].mesh;
    Primitive& primitive = model.meshes[drawn].primitives[primitives_of[part.node]++];
    if (drawn_by.try_emplace(drawn, part.node).first->second != part.node) continue;
    for (const HeadShape& shape : shapes) {
      // Below a tenth of a micron nothing has moved; zeros can be left out of the file.
      constexpr double still = 1e-7, unturned = 1e-5;
      MorphTarget target{shape.name, {}, {}};
      for (std::size_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
        const Vec3 move = place.unit * (place.axes * (shape.positions[v] - rest.positions[v]));
        const Vec3 turn = place.axes * (shape.normals[v] - rest.normals[v]);
        target.positions.push_back(glm::length(move) > still ? move : Vec3(0.0));
        target.normals.push_back(glm::length(turn) > unturned ? turn : Vec3(0.0));
      }
      primitive.morph_targets.push_back(std::move(target));
    }
  }
  for (const auto& [drawn, node] : drawn_by) {
    model.meshes[drawn].morph_weights.resize(model.meshes[drawn].primitives.front().morph_targets.size(), 0.0);
    if (!model.nodes[node].morph_weights.empty())
      model.nodes[node].morph_weights.resize(model.meshes[drawn].morph_weights.size(), 0.0);
  }
}

}  // namespace sinew
