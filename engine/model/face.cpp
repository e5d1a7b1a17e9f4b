#include "engine/model/face.h"

#include <map>

namespace sinew {

const std::array<FaceChannelName, face_channels>& face_channel_names() {
  static constexpr std::array<FaceChannelName, face_channels> names = {
      {{"browLeft", "right"},    {"browLeft", "up"},      {"browLeft", "turn"},
       {"browRight", "right"},   {"browRight", "up"},     {"browRight", "turn"},
       {"upperLidLeft", ""},     {"upperLidRight", ""},   {"lowerLidLeft", ""},
       {"lowerLidRight", ""},    {"eyeLeft", "yaw"},      {"eyeLeft", "pitch"},
       {"eyeRight", "yaw"},      {"eyeRight", "pitch"},   {"upperLip", ""},
       {"lowerLip", ""},         {"cornerLeft", "right"}, {"cornerLeft", "up"},
       {"cornerRight", "right"}, {"cornerRight", "up"},   {"jaw", ""},
       {"cheekLeft", ""},        {"cheekRight", ""},      {"nose", ""},
       {"lipPucker", ""},        {"lipPress", ""},        {"lipSeal", ""}}};
  return names;
}

std::string channel_word(FaceChannel channel) {
  const FaceChannelName& name = face_channel_names()[static_cast<std::size_t>(channel)];
  return *name.number ? std::string(name.region) + "." + name.number : name.region;
}

std::span<const FaceGuideName> face_guide_names() {
  static constexpr std::array<FaceGuideName, 7> names = {{{"crown", "crown", &FaceGuides::crown},
                                                          {"hairLine", "hair line", &FaceGuides::hair_line},
                                                          {"brow", "brow", &FaceGuides::brow},
                                                          {"eyeLine", "eyes", &FaceGuides::eye_line},
                                                          {"noseBase", "nose", &FaceGuides::nose_base},
                                                          {"lipContact", "mouth", &FaceGuides::lip_contact},
                                                          {"chin", "chin", &FaceGuides::chin}}};
  return names;
}

void append_vertex(const FaceVertex& vertex, const std::vector<FaceDelta>& deltas, FaceRig& rig) {
  rig.vertices.push_back(vertex);
  rig.deltas.insert(rig.deltas.end(), deltas.begin(), deltas.end());
  rig.first.push_back(static_cast<std::uint32_t>(rig.deltas.size()));
}

FaceBlend blend_vertices(const FaceRig& rig, std::span<const std::uint32_t> vertices, std::span<const double> weights) {
  FaceBlend out;
  std::map<std::uint32_t, FaceDelta> sums;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::uint32_t v = vertices[i];
    out.vertex.jaw += weights[i] * rig.vertices[v].jaw;
    out.vertex.jaw_sealed += weights[i] * rig.vertices[v].jaw_sealed;
    for (std::uint32_t d = rig.first[v]; d < rig.first[v + 1]; ++d) {
      FaceDelta& sum = sums.try_emplace(rig.deltas[d].signal, FaceDelta{rig.deltas[d].signal, {}, {}}).first->second;
      sum.position += weights[i] * rig.deltas[d].position;
      sum.normal += weights[i] * rig.deltas[d].normal;
    }
  }
  for (const auto& [signal, delta] : sums) out.deltas.push_back(delta);
  return out;
}

FaceRig face_sizes(const FaceRig& rig) {
  FaceRig out;
  out.hinge = rig.hinge;
  out.chin_reach = rig.chin_reach;
  out.chin_fall = rig.chin_fall;
  out.eye_radius = rig.eye_radius;
  out.eye_centres = rig.eye_centres;
  out.limits = rig.limits;
  out.eye_scale = rig.eye_scale;
  out.mouth_scale = rig.mouth_scale;
  out.jaw_scale = rig.jaw_scale;
  out.brow_outline = rig.brow_outline;
  out.brow_inner = rig.brow_inner;
  out.brow_outer = rig.brow_outer;
  return out;
}

FaceRig picked_face(const FaceRig& rig, std::span<const std::uint32_t> vertices) {
  FaceRig out = face_sizes(rig);
  for (const std::uint32_t v : vertices)
    append_vertex(rig.vertices[v], {rig.deltas.begin() + rig.first[v], rig.deltas.begin() + rig.first[v + 1]}, out);
  return out;
}

}  // namespace sinew
