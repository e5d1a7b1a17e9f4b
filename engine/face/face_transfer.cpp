#include "engine/face/face_transfer.h"

#include <algorithm>

#include "engine/core/parallel.h"
#include "engine/face/head_normals.h"
#include "engine/face/head_regions.h"
#include "engine/face/lid_opening.h"
#include "engine/face/skin_values.h"
#include "engine/face/template_fit.h"

namespace sinew {
namespace {

double apart(const Landmarks& marks, const char* a, const char* b) { return glm::distance(marks.at(a), marks.at(b)); }

/// The mesh's measure over the template's.
double over(const Landmarks& mesh, const Landmarks& head, const char* a, const char* b) {
  if (!mesh.contains(a) || !mesh.contains(b)) return 1.0;
  return apart(mesh, a, b) / apart(head, a, b);
}

/// Hinge, sizes, limits and pivots.
void set_measures(const Head& from, const Landmarks& head_marks, const FaceMesh& mesh, const TemplateFit& fit,
                  FaceRig& face) {
  constexpr double least_reach = 0.4;
  const Landmarks& marks = mesh.marks;
  face.eye_scale = 0.5 * (over(marks, head_marks, "eyeInnerLeft", "eyeOuterLeft") +
                          over(marks, head_marks, "eyeInnerRight", "eyeOuterRight"));
  face.mouth_scale = over(marks, head_marks, "lipCornerLeft", "lipCornerRight");
  face.jaw_scale = over(marks, head_marks, "lipContact", "chin");
  const double nose = marks.contains("noseWingLeft") ? over(marks, head_marks, "noseWingLeft", "noseWingRight")
                                                     : over(marks, head_marks, "eyeInnerLeft", "eyeInnerRight");
  face.limits = face_limits(face, nose);
  face.hinge = fit.warp.point(from.face.hinge);
  face.hinge.x = 0.0;
  face.chin_reach = std::max(least_reach, marks.at("chin").z - face.hinge.z);
  face.chin_fall = face.hinge.y - marks.at("chin").y;
  face.eye_radius = mesh.eye_radius;
  face.eye_centres = mesh.eye_centres;
  const double depth = head_marks.at("browMiddleLeft").z;
  const auto bent = [&](const Vec2& p) { return Vec2(fit.warp.point({p.x, p.y, depth})); };
  for (const Vec2& p : from.face.brow_outline) face.brow_outline.push_back(bent(p));
  const double height = head_marks.at("browMiddleLeft").y;
  face.brow_inner = bent({from.face.brow_inner, height}).x;
  face.brow_outer = bent({from.face.brow_outer, height}).x;
}

/// What one unit of a signal is on this face over what it is on the template: channels are this face's own lengths.
double signal_scale(const FaceRig& face, std::size_t signal, double nose) {
  if (signal >= 2 * face_side_signals) {
    switch (static_cast<FaceMiddleSignal>(signal - 2 * face_side_signals)) {
      case FaceMiddleSignal::upper_lip_up:
      case FaceMiddleSignal::lower_lip_up:
      case FaceMiddleSignal::lower_lip_down:
        return face.mouth_scale;
      case FaceMiddleSignal::nose:
        return nose;
      default:
        return 1.0;
    }
  }
  switch (static_cast<FaceSignal>(signal % face_side_signals)) {
    case FaceSignal::corner_out:
    case FaceSignal::corner_in:
    case FaceSignal::corner_up:
    case FaceSignal::corner_down:
      return face.mouth_scale;
    case FaceSignal::brow_turn_inner:
    case FaceSignal::brow_turn_outer:
      return 1.0;
    default:
      return face.eye_scale;
  }
}

}  // namespace

const Head& template_head() {
  static const Head head = HeadMaker().head(measures_of_age(0.0)).value();
  return head;
}

Result<TransferredFace> transfer_face(const Head& from, const CharacterMesh& mesh, const Landmarks& landmarks,
                                      const std::string& name) {
  Landmarks head_marks;
  for (const auto& [mark, vertex] : from.marks) head_marks[mark] = from.positions[vertex];
  auto made = face_mesh(mesh, landmarks, head_marks, name);
  if (!made) return pass_on(std::move(made));
  const FaceMesh& target = *made;
  const TemplateFit fit = fit_template(from, target);

  TransferredFace out;
  out.to_mesh = target.to_mesh;
  out.place_of = target.place_of;
  for (const FaceGuideName& guide : face_guide_names())
    if (const auto mark = target.marks.find(guide.name); mark != target.marks.end())
      out.guides.*guide.height = mark->second.y;
  out.head.positions = target.positions;
  out.head.skin_vertices = target.positions.size();
  for (std::size_t i = 0; i < target.triangles.size(); i += 3)
    out.head.triangles.push_back(
        {{target.triangles[i], target.triangles[i + 1], target.triangles[i + 2]}, HeadMaterial::skin});
  // What deltas are counted from, to the bit: weighed otherwise, every signal would bend what it does not move.
  out.head.normals = head_normals(out.head, out.head.positions);
  out.head.measures = from.measures;
  out.head.measures.height = head_units * target.to_mesh.scale;
  FaceRig& face = out.head.face;
  set_measures(from, head_marks, target, fit, face);
  const double nose = face.limits.nose_wrinkle / from.face.limits.nose_wrinkle;

  SkinValues values(from.face, fit, target, [&](std::size_t signal) { return signal_scale(face, signal, nose); });
  values.fill();
  values.carry_small_parts();

  const TriangleTree skin(target.positions, target.skin_triangles);
  const std::array<LidOpening, 2> lids{LidOpening(target, skin, 0), LidOpening(target, skin, 1)};
  for (std::size_t side = 0; side < 2; ++side) {
    const char* word = side == 0 ? "left" : "right";
    if (!lids[side].open()) out.notes.push_back(fmt::format("the {} eye has no opening: its lids do not close", word));
    if (!target.has_eyeball[side])
      out.notes.push_back(fmt::format("the {} eye has no ball of its own: its gaze does not move", word));
  }
  constexpr double clearance = 0.011, still = 1e-6, ball_share = 0.9;
  for (std::size_t v = 0; v < target.positions.size(); ++v) {
    FaceVertex vertex;
    vertex.jaw = values.jaw(v);
    vertex.jaw_sealed = values.jaw_sealed(v);
    const ShellKind kind = target.kind(v);
    if (kind == ShellKind::eyeball) {
      vertex.ball = true;
      vertex.eye = target.eye_of_shell[target.graph.shell[v]];
    } else if (kind == ShellKind::skin || kind == ShellKind::attached) {
      const std::size_t side = target.positions[v].x > 0 ? 0 : 1;
      const auto closing = lids[side].closing(values.root(v));
      if (closing[0] > still || closing[1] > still) {
        vertex.eye = static_cast<int>(side);
        vertex.close_upper = closing[0];
        vertex.close_lower = closing[1];
        const double distance = glm::distance(target.positions[v], target.eye_centres[side]);
        if (kind == ShellKind::skin && target.has_eyeball[side] && distance > ball_share * target.eye_radius)
          vertex.least_distance = std::min(distance, target.eye_radius + clearance);
      }
    }
    append_vertex(vertex, values.deltas(v), face);
  }
  add_normal_deltas(out.head);
  return out;
}

}  // namespace sinew
