#include "engine/face/head_write.h"

#include "engine/io/gltf_write_parts.h"

namespace sinew {

Result<Bytes> head_glb(const Head& head, const Model& model) {
  GlbBuilder glb;
  write_rig(model, glb);
  const std::vector<std::uint32_t> numbers = model_vertices(head);
  std::vector<Vec3> all;
  for (const Primitive& primitive : model.meshes[0].primitives)
    all.insert(all.end(), primitive.positions.begin(), primitive.positions.end());
  Json landmarks = Json::object(), measures = Json::object();
  for (const auto& [name, vertex] : head.landmarks) {
    const Vec3& p = all[numbers[vertex]];
    landmarks[name] = {{"vertex", numbers[vertex]}, {"position", {p.x, p.y, p.z}}};
  }
  for (const HeadMeasureField& field : head_measure_fields()) measures[field.name] = head.measures.*field.member;
  Json& extras = glb.json["meshes"][0]["extras"];
  extras["landmarks"] = std::move(landmarks);
  extras["drawingUnit"] = head.metres();
  extras["measures"] = std::move(measures);
  return glb.finish();
}

}  // namespace sinew
