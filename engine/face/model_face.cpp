#include "engine/face/model_face.h"

#include <algorithm>
#include <map>

#include "engine/deform/rest_shape.h"
#include "engine/rig/humanoid.h"
#include "engine/rig/motion_rig.h"

namespace sinew {
namespace {

/// Where a drawn part's primitive is in the model.
struct PartPlace {
  std::size_t mesh, primitive;
  std::uint32_t first_vertex;
};

/// Each primitive once: a mesh that two nodes draw has its face where it is drawn first.
std::vector<PartPlace> part_places(const Model& model, const CharacterMesh& mesh) {
  std::vector<PartPlace> out;
  std::map<int, std::size_t> next;
  std::vector<bool> seen(model.meshes.size(), false);
  for (const MeshPart& part : mesh.parts) {
    const auto at = static_cast<std::size_t>(model.nodes[static_cast<std::size_t>(part.node)].mesh);
    const std::size_t primitive = next[part.node]++;
    if (!seen[at]) out.push_back({at, primitive, part.first_vertex});
    if (primitive + 1 == model.meshes[at].primitives.size()) seen[at] = true;
  }
  return out;
}

/// What a shape adds to one vertex, in the space of its primitive.
struct Change {
  Vec3 position{0.0}, normal{0.0};
};

Change change_of(const ModelFace& face, const HeadShape& shape, std::uint32_t v) {
  constexpr double still = 3e-6, unturned = 1e-3;  // drawing units: a fifth of a micron on a head
  const TransferredFace& t = face.transfer;
  const std::uint32_t place = t.place_of[v];
  const Vec3 move = shape.positions[place] - t.head.positions[place];
  const Vec3 turn = shape.normals[place] - t.head.normals[place];
  Change out;
  if (glm::length(move) > still)
    out.position = glm::inverse(face.blend[v]) * (t.to_mesh.scale * t.to_mesh.direction(move));
  if (glm::length(turn) > unturned)
    out.normal = glm::transpose(face.blend[v]) * t.to_mesh.direction(turn) /
                 std::cbrt(std::abs(glm::determinant(face.blend[v])));
  return out;
}

}  // namespace

Result<FoundLandmarks> find_model_landmarks(const Model& model) {
  if (auto ok = check_drawn_vertices(model); !ok) return pass_on(std::move(ok));
  CharacterMesh mesh = character_mesh(model);
  RestShape rest = rest_shape(model, mesh, hierarchy_order(model));
  mesh.positions = std::move(rest.positions);
  HeadSite site;
  const Humanoid humanoid = find_humanoid(model, rest.global);
  const int head = humanoid.find(HumanoidBone::head);
  if (head >= 0) {
    const BodyAxes axes = standing_axes(model, humanoid, rest.global);
    site.axes = Mat3(axes.left, axes.up, axes.front);
    std::vector<bool> of_head(model.nodes.size(), false);
    for (const int node : hierarchy_order(model)) {
      const auto at = static_cast<std::size_t>(node);
      const int parent = model.nodes[at].parent;
      of_head[at] = node == head || (parent >= 0 && of_head[static_cast<std::size_t>(parent)]);
    }
    site.inside.resize(mesh.vertices());
    for (std::size_t v = 0; v < mesh.vertices(); ++v) site.inside[v] = of_head[static_cast<std::size_t>(mesh.bone(v))];
  }
  return find_landmarks(mesh, site, model.file);
}

Result<ModelFace> model_face(const Model& model, const LandmarkPlaces& landmarks, const std::string& name) {
  if (auto ok = check_drawn_vertices(model); !ok) return pass_on(std::move(ok));
  ModelFace out;
  out.mesh = character_mesh(model);
  RestShape rest = rest_shape(model, out.mesh, hierarchy_order(model));
  out.mesh.positions = std::move(rest.positions);
  out.mesh.normals = std::move(rest.normals);
  out.blend = std::move(rest.blend);
  const auto places = placed_landmarks(out.mesh, landmarks, name);
  if (!places) return tl::unexpected<Error>(places.error());
  auto transfer = transfer_face(template_head(), out.mesh, *places, name);
  if (!transfer) return pass_on(std::move(transfer));
  out.transfer = std::move(*transfer);
  return out;
}

Result<CharacterFace> character_face(const ModelFace& face, const CharacterMesh& bind, const std::string& name) {
  constexpr double alike = 1e-4;  // of a drawing unit
  CharacterFace out;
  out.rig = face.transfer.rig();
  out.guides = face.transfer.guides;
  const Similarity& to_rest = face.transfer.to_mesh;
  std::optional<std::size_t> first;
  for (std::size_t v = 0; v < bind.vertices(); ++v) {
    if (!out.rig.moves(v)) continue;
    if (!first) first = v;
    const Mat3& blend = face.blend[*first];
    const Vec3 here = face.mesh.positions[*first] + blend * (bind.positions[v] - bind.positions[*first]);
    if (glm::distance(here, face.mesh.positions[v]) > alike * to_rest.scale)
      return bad_input("{}: the parts of its face stand in spaces of their own; sinew head --on gives it morph targets",
                       name);
  }
  if (!first) return out;
  const Mat3 back = glm::inverse(face.blend[*first]);
  const double scale = std::cbrt(glm::determinant(back));
  out.place.unit = scale * to_rest.scale;
  out.place.axes = back * to_rest.rotation / scale;
  out.place.origin = bind.positions[*first] + back * (to_rest.translation - face.mesh.positions[*first]);
  return out;
}

std::size_t add_face_targets(const ModelFace& face, std::span<const HeadShape> shapes, Model& model) {
  std::size_t moving = 0;
  const std::vector<PartPlace> parts = part_places(model, face.mesh);
  std::vector<std::vector<bool>> moves(parts.size());
  std::vector<bool> has_face(model.meshes.size(), false);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto count = model.meshes[parts[i].mesh].primitives[parts[i].primitive].positions.size();
    moves[i].assign(count, false);
    for (std::uint32_t v = 0; v < count; ++v) {
      for (const HeadShape& shape : shapes)
        if (change_of(face, shape, parts[i].first_vertex + v).position != Vec3(0.0)) {
          moves[i][v] = true;
          break;
        }
      moving += moves[i][v];
    }
    if (std::ranges::find(moves[i], true) != moves[i].end()) has_face[parts[i].mesh] = true;
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!has_face[parts[i].mesh]) continue;
    Primitive& primitive = model.meshes[parts[i].mesh].primitives[parts[i].primitive];
    for (const HeadShape& shape : shapes) {
      MorphTarget target{shape.name, {}, {}};
      for (std::uint32_t v = 0; v < moves[i].size(); ++v) {
        const Change change = moves[i][v] ? change_of(face, shape, parts[i].first_vertex + v) : Change{};
        target.positions.push_back(change.position);
        target.normals.push_back(change.normal);
      }
      primitive.morph_targets.push_back(std::move(target));
    }
  }
  for (std::size_t m = 0; m < model.meshes.size(); ++m) {
    if (!has_face[m]) continue;
    const std::size_t before = model.meshes[m].primitives[0].morph_targets.size() - shapes.size();
    model.meshes[m].morph_weights.resize(before, 0.0);
    model.meshes[m].morph_weights.resize(before + shapes.size(), 0.0);
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
      Node& node = model.nodes[n];
      if (node.mesh != static_cast<int>(m)) continue;
      if (!node.morph_weights.empty()) node.morph_weights.resize(before + shapes.size(), 0.0);
      for (Clip& clip : model.clips)
        for (Channel& channel : clip.channels) {
          if (channel.node != static_cast<int>(n) || channel.path != ChannelPath::weights) continue;
          std::vector<double> values;
          for (std::size_t at = 0; at < channel.values.size(); at += channel.width) {
            values.insert(values.end(), channel.values.begin() + static_cast<std::ptrdiff_t>(at),
                          channel.values.begin() + static_cast<std::ptrdiff_t>(at + channel.width));
            values.insert(values.end(), shapes.size(), 0.0);
          }
          channel.width += shapes.size();
          channel.values = std::move(values);
        }
    }
  }
  return moving;
}

void set_face_shape(const ModelFace& face, const HeadShape& shape, Model& model) {
  for (const PartPlace& part : part_places(model, face.mesh)) {
    Primitive& primitive = model.meshes[part.mesh].primitives[part.primitive];
    for (std::uint32_t v = 0; v < primitive.positions.size(); ++v) {
      const Change change = change_of(face, shape, part.first_vertex + v);
      primitive.positions[v] += change.position;
      primitive.normals[v] = unit_or(primitive.normals[v] + change.normal, primitive.normals[v]);
    }
  }
}

}  // namespace sinew
