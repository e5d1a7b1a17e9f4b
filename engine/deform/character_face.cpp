#include "engine/deform/character_face.h"

#include "engine/core/parallel.h"

namespace sinew {
Result<void> CharacterFaceJob::validate() const {
  const std::size_t n = face.rig.vertices.size();
  if (positions.size() != n) return bad_input("positions has {} of {} vertices", positions.size(), n);
  if (normals.size() != n) return bad_input("normals has {} of {} vertices", normals.size(), n);
  if (!tangents.empty() && tangents.size() != n) return bad_input("tangents has {} of {} vertices", tangents.size(), n);
  return {};
}

void CharacterFaceJob::run() const {
  const std::size_t n = positions.size();
  const FacePlace& place = face.place;
  const Mat3 to_face = glm::transpose(place.axes);
  std::vector<Vec3> rest(n), rest_normals(n), posed(n), posed_normals(n);
  parallel_for(n, [&](std::size_t v) {
    rest[v] = to_face * (positions[v] - place.origin) / place.unit;
    rest_normals[v] = to_face * normals[v];
  });
  FaceJob{face.rig, state, rest, rest_normals, posed, posed_normals}.run();
  parallel_for(n, [&](std::size_t v) {
    if (!face.rig.moves(v)) return;
    positions[v] = place.origin + place.unit * (place.axes * posed[v]);
    normals[v] = place.axes * posed_normals[v];
    if (tangents.empty()) return;
    const Vec3 tangent = turned_with_face(face.rig, state, v, to_face * Vec3(tangents[v]));
    tangents[v] = Vec4(place.axes * tangent, tangents[v].w);
  });
}

}  // namespace sinew
