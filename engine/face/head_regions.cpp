#include "engine/face/head_regions.h"

#include <algorithm>
#include <map>

#include <nlohmann/json.hpp>

#include "embedded/face_regions.h"
#include "engine/face/head_cage_parts.h"
#include "engine/face/region_moves.h"

namespace sinew {
namespace {

using Json = nlohmann::json;

const Json& document() {
  static const Json parsed = Json::parse(face_regions);
  return parsed;
}

/// Angles by which the lids' points turn when the lid shuts, upper and lower, and how much of a point is inside the
/// ball by intention.
struct LidValues {
  CageValues upper, lower, sleeve;
};

LidValues lid_values(const HeadPlan& plan, const HeadCage& cage) {
  // The inner rings go all the way; the fold lags, the socket stays.
  constexpr double upper_share[] = {1, 1, 1, 0.80, 0.42, 0.06}, lower_share[] = {1, 1, 1, 0.64, 0.34, 0.05};
  const std::size_t n = cage.positions.size();
  LidValues out{CageValues(n), CageValues(n), CageValues(n)};
  for (int k = 1; k < 8; ++k) {
    const double opening = lid_margin(plan, k).elevation - lid_margin(plan, 16 - k).elevation;
    // A little further, so that no slit stays; more in the corners, where it would stay longest.
    const double closing = 1.04 * opening + (k == 1 || k == 7 ? 0.10 : 0.02);
    for (int ring = 0; ring < 6; ++ring) {
      out.upper[cage.index(eye_point(ring, k))] = closing * upper_share[ring];
      out.lower[cage.index(eye_point(ring, 16 - k))] = closing * lower_share[ring];
    }
  }
  for (int k = 0; k < eye_places; ++k) out.sleeve[cage.index(eye_point(0, k))] = 1.0;
  return out;
}

void set_lids(const HeadPlan& plan, const HeadTopology& topology, const HeadCage& cage, const std::vector<Vec3>& skin,
              FaceRig& face) {
  constexpr double clearance = 0.011, sleeve_share = 0.35, reach = 1.4;
  const LidValues lids = lid_values(plan, cage);
  const std::vector<double> upper = topology.left_values(lids.upper), lower = topology.left_values(lids.lower),
                            sleeve = topology.left_values(lids.sleeve);
  const double radius = plan.m.eye_radius;
  for (std::size_t v = 0; v < topology.vertices(); ++v) {
    const bool near = glm::distance(skin[v], plan.eye_centre) < reach * radius && skin[v].z > plan.eye_centre.z;
    if (!near && upper[v] == 0.0 && lower[v] == 0.0) continue;
    FaceVertex& left = face.vertices[v];
    left.eye = 0;
    left.close_upper = upper[v];
    left.close_lower = lower[v];
    left.least_distance = near && sleeve[v] < sleeve_share ? radius + clearance : 0.0;
    FaceVertex& right = face.vertices[topology.mirror()[v]];
    right.eye = 1;
    right.close_upper = left.close_upper;
    right.close_lower = left.close_lower;
    right.least_distance = left.least_distance;
  }
}

}  // namespace

FaceLimits face_limits(const FaceRig& face, double nose_scale) {
  const Json& l = document()["limits"];
  const double eye = face.eye_scale, mouth = face.mouth_scale;
  return {.eyebrow_up_vertical = eye * double(l["EYEBROW_U_VERT_LIMIT"]),
          .eyebrow_down_vertical = eye * double(l["EYEBROW_D_VERT_LIMIT"]),
          .eyebrow_out_horizontal = eye * double(l["EYEBROW_OUT_HORT_LIMIT"]),
          .eyebrow_in_horizontal = eye * double(l["EYEBROW_IN_HORT_LIMIT"]),
          .eyebrow_rotate_range = l["EYEBROW_ROTATE_RANGE"],
          .eyelid_upper_wide = l["EYELID_U_U_VERT_LIMIT"],
          .eyelid_lower_up = l["EYELID_D_U_VERT_LIMIT"],
          .eyeball_yaw = l["EYEBALL_HORT_LIMIT"],
          .eyeball_up = l["EYEBALL_U_VERT_LIMIT"],
          .eyeball_down = l["EYEBALL_D_VERT_LIMIT"],
          .lip_up = mouth * double(l["LIP_U_VERT_LIMIT"]),
          .lip_down = mouth * double(l["LIP_D_VERT_LIMIT"]),
          .corner_out = mouth * double(l["MOUTH_CORNER_OUT_HORT_LIMIT"]),
          .corner_in = mouth * double(l["MOUTH_CORNER_IN_HORT_LIMIT"]),
          .corner_up = mouth * double(l["MOUTH_CORNER_U_VERT_LIMIT"]),
          .corner_down = mouth * double(l["MOUTH_CORNER_D_VERT_LIMIT"]),
          .chin_drop = face.jaw_scale * double(l["CHIN_D_LIMIT"]),
          .cheek_up = eye * double(l["CHEEK_U_VERT_LIMIT"]),
          .nose_wrinkle = nose_scale * double(l["NOSE_WRINKLE_LIMIT"])};
}

CageValues region_weights(const HeadCage& cage, const char* region) {
  const std::map<std::string, HeadPart> parts = {
      {"eye", HeadPart::eye},           {"nose", HeadPart::nose},   {"mouth", HeadPart::mouth},
      {"bag", HeadPart::bag},           {"cheek", HeadPart::cheek}, {"chin", HeadPart::chin},
      {"forehead", HeadPart::forehead}, {"side", HeadPart::side},   {"neck", HeadPart::neck}};
  CageValues out(cage.positions.size(), 0.0);
  for (const auto& [key, weights] : document()["weights"][region].items()) {
    const std::size_t point = key.find('.');
    const HeadPart part = parts.at(key.substr(0, point));
    const int ring = std::stoi(key.substr(point + 1));
    for (std::size_t place = 0; place < weights.size(); ++place)
      if (weights[place] != 0.0) out[cage.index({part, ring, static_cast<int>(place)})] = weights[place];
  }
  return out;
}

FaceRig skin_face(const HeadPlan& plan, const HeadTopology& topology, const HeadCage& cage,
                  const std::vector<Vec3>& skin) {
  constexpr double adult_mouth_height = 0.66, adult_nose_width = 0.26;
  FaceRig face;
  face.vertices.resize(topology.vertices());
  face.eye_scale = plan.eye_scale;
  face.mouth_scale = plan.mouth_scale;
  face.jaw_scale = plan.mouth / adult_mouth_height;
  face.limits = face_limits(face, plan.m.nose_width / adult_nose_width);
  face.hinge = {0.0, plan.m.ear_bottom + 0.12, plan.m.ear_depth + 0.10};
  face.chin_reach = plan.m.chin_depth - face.hinge.z;
  face.chin_fall = face.hinge.y;
  face.eye_radius = plan.m.eye_radius;
  face.eye_centres = {plan.eye_centre, Vec3(-plan.eye_centre.x, plan.eye_centre.y, plan.eye_centre.z)};
  face.brow_inner = plan.m.eye_spacing - 0.31 * plan.eye_scale;
  face.brow_outer = plan.m.eye_spacing + 0.39 * plan.eye_scale;
  const std::vector<double> jaw = topology.even_values(jaw_weights(plan, cage, false)),
                            sealed = topology.even_values(jaw_weights(plan, cage, true));
  for (std::size_t v = 0; v < face.vertices.size(); ++v) {
    face.vertices[v].jaw = jaw[v];
    face.vertices[v].jaw_sealed = sealed[v];
  }
  set_lids(plan, topology, cage, skin, face);
  add_region_moves(plan, topology, cage, skin, face);
  return face;
}

void push_out_of_eyes(const FaceRig& face, std::vector<Vec3>& skin) {
  for (std::size_t v = 0; v < skin.size(); ++v) {
    const FaceVertex& vertex = face.vertices[v];
    if (vertex.eye < 0) continue;
    const Vec3& centre = face.eye_centres[static_cast<std::size_t>(vertex.eye)];
    const double distance = glm::distance(skin[v], centre);
    if (distance < vertex.least_distance) skin[v] = centre + vertex.least_distance / distance * (skin[v] - centre);
  }
}

}  // namespace sinew
