/// Faces laid on other meshes: the template on itself, moved copies, refined copies, real files.

#include <filesystem>
#include <fstream>

#include "engine/body/built_in_model.h"
#include "engine/deform/face.h"
#include "engine/face/face_shapes.h"
#include "engine/face/model_face.h"
#include "engine/io/obj_model.h"
#include "tests/face/head_fixture.h"
#include "tests/support/assets.h"

namespace sinew::test {
namespace {

/// The head's skin, eyes, brows and teeth as a mesh without a face.
CharacterMesh mesh_of(const Head& head) {
  CharacterMesh out;
  out.positions = head.positions;
  out.normals = head.normals;
  for (const HeadTriangle& t : head.triangles)
    out.triangles.insert(out.triangles.end(), t.corners.begin(), t.corners.end());
  return out;
}

Landmarks marks_of(const Head& head) {
  Landmarks out;
  for (const auto& [name, vertex] : head.marks) out[name] = head.positions[vertex];
  return out;
}

/// Where a channel takes every vertex, drawing units.
std::vector<Vec3> posed(const FaceRig& rig, const std::vector<Vec3>& rest, const FaceChannels& channels) {
  std::vector<Vec3> out(rest.size());
  const FaceState state = face_state(rig, hold_at_limits(rig, channels).channels);
  FaceJob{rig, state, rest, {}, out, {}}.run();
  return out;
}

/// Root mean square of how far two faces move the same vertices apart, over that of how far the first moves them.
double difference(const Head& head, const FaceRig& other, const std::vector<Vec3>& other_rest, const std::string& name,
                  const std::function<Vec3(const Vec3&)>& back) {
  const WeighedExpression one[] = {{find_expression(name).value(), 1.0}};
  const FaceChannels channels = mix_expressions(one, false);
  const std::vector<Vec3> ours = posed(head.face, head.positions, channels),
                          theirs = posed(other, other_rest, channels);
  double apart = 0.0, moved = 0.0;
  for (std::size_t v = 0; v < ours.size(); ++v) {
    const Vec3 a = ours[v] - head.positions[v], b = back(theirs[v]) - back(other_rest[v]);
    apart += glm::dot(a - b, a - b);
    moved += glm::dot(a, a);
  }
  return std::sqrt(apart / moved);
}

Vec3 same(const Vec3& p) { return p; }

/// What a transfer has in the order of the mesh it was given.
struct Laid {
  FaceRig rig;
  std::vector<Vec3> rest;
};
Laid laid(const Head& head, const CharacterMesh& mesh, const Landmarks& marks) {
  const auto transfer = transfer_face(head, mesh, marks, "test");
  EXPECT_TRUE(transfer) << transfer.error().message;
  Laid out{transfer->rig(), {}};
  for (const std::uint32_t place : transfer->place_of) out.rest.push_back(transfer->head.positions[place]);
  return out;
}

TEST(Transfer, OntoItselfIsTheIdentity) {
  const Head& head = head_of("adult");
  const Laid on_itself = laid(head, mesh_of(head), marks_of(head));
  // Deltas and shares of the skin are copied; a place answers to itself, so that only rounding is left.
  for (std::size_t v = 0; v < head.skin_vertices; ++v) {
    ASSERT_NEAR(on_itself.rig.vertices[v].jaw, head.face.vertices[v].jaw, 1e-6) << v;
    for (std::uint32_t i = head.face.first[v]; i < head.face.first[v + 1]; ++i) {
      const FaceDelta& delta = head.face.deltas[i];
      Vec3 found(0.0);
      for (std::uint32_t k = on_itself.rig.first[v]; k < on_itself.rig.first[v + 1]; ++k)
        if (on_itself.rig.deltas[k].signal == delta.signal) found = on_itself.rig.deltas[k].position;
      ASSERT_LT(glm::distance(found, delta.position), 1e-5) << v << " signal " << delta.signal;
    }
  }
  EXPECT_NEAR(on_itself.rig.limits.chin_drop, head.face.limits.chin_drop, 1e-9);
  EXPECT_NEAR(on_itself.rig.eye_radius, head.face.eye_radius, 1e-6);
  // Lids are not copied but found by looking out of the eye, and what stands on the skin rides on it at one place
  // instead of six: measured 0.37 where lids alone move, up to 0.19 where they move beside others.
  EXPECT_LT(difference(head, on_itself.rig, on_itself.rest, "blink", same), 0.42);
  for (const char* name : {"smile", "anger", "aa", "disgust"})
    EXPECT_LT(difference(head, on_itself.rig, on_itself.rest, name, same), 0.22) << name;
}

TEST(Transfer, FollowsScaleTurnAndShift) {
  const Head& head = head_of("adult");
  Similarity moved;
  moved.scale = 37.0;
  moved.rotation = glm::mat3_cast(glm::angleAxis(2.1, glm::normalize(Vec3(0.3, -1.0, 0.5))));
  moved.translation = {400.0, -20.0, 7.0};
  CharacterMesh mesh = mesh_of(head);
  Landmarks marks = marks_of(head);
  for (Vec3& p : mesh.positions) p = moved.point(p);
  for (Vec3& n : mesh.normals) n = moved.direction(n);
  for (auto& [name, p] : marks) p = moved.point(p);
  const Laid plain = laid(head, mesh_of(head), marks_of(head)), there = laid(head, mesh, marks);
  for (std::size_t v = 0; v < plain.rest.size(); ++v) {
    ASSERT_LT(glm::distance(plain.rest[v], there.rest[v]), 1e-8) << v;
    ASSERT_NEAR(plain.rig.vertices[v].jaw, there.rig.vertices[v].jaw, 1e-6) << v;
    ASSERT_NEAR(plain.rig.vertices[v].close_upper, there.rig.vertices[v].close_upper, 1e-4) << v;
  }
}

TEST(Transfer, OntoAFinerHeadIsNearlyTheSame) {
  const Head& coarse = head_of("adult", "", 1);
  const Head& fine = head_of("adult", "", 2);
  const Laid on_fine = laid(coarse, mesh_of(fine), marks_of(fine));
  // The finer skin lies up to a hundredth of a unit off the coarser one's facets.
  for (const char* name : {"smile", "anger", "aa", "sadness"})
    EXPECT_LT(difference(fine, on_fine.rig, on_fine.rest, name, same), 0.25) << name;
}

TEST(Transfer, LipsOfATouchingMouthGoTheirOwnWays) {
  const Head& head = head_of("adult");
  const Laid on_itself = laid(head, mesh_of(head), marks_of(head));
  for (const auto& [upper, lower] : head.lip_line) {
    EXPECT_LT(on_itself.rig.vertices[upper].jaw, on_itself.rig.vertices[lower].jaw + 1e-9);
    EXPECT_NEAR(on_itself.rig.vertices[upper].jaw, head.face.vertices[upper].jaw, 1e-6);
    EXPECT_NEAR(on_itself.rig.vertices[lower].jaw, head.face.vertices[lower].jaw, 1e-6);
  }
}

TEST(Transfer, RefusesLandmarksThatMakeNoFace) {
  const Head& head = head_of("adult");
  const CharacterMesh mesh = mesh_of(head);
  const auto message = [&](const std::function<void(Landmarks&)>& change) {
    Landmarks marks = marks_of(head);
    change(marks);
    const auto result = transfer_face(head, mesh, marks, "marks.json");
    return result ? std::string() : result.error().message;
  };
  EXPECT_EQ(message([](Landmarks&) {}), "");
  EXPECT_NE(message([](Landmarks& m) { m["chin"] = m["noseTip"]; }), "");
  EXPECT_NE(message([](Landmarks& m) {
              for (auto& [name, p] : m) p = Vec3(p.y, 0.0, 0.0);
            }),
            "");
  EXPECT_NE(message([](Landmarks& m) {
              Landmarks exchanged;
              for (const auto& [name, p] : m) {
                std::string other = name;
                if (const auto at = name.find("Left"); at != std::string::npos) other.replace(at, 4, "Right");
                if (const auto at = name.find("Right"); at != std::string::npos) other.replace(at, 5, "Left");
                exchanged[other] = p;
              }
              m = exchanged;
            }),
            "");
}

TEST(Landmarks, ErrorsNameThePlaceAndTheNearestName) {
  const auto error = [](const char* text) {
    const auto result = parse_landmarks(text, "f.json");
    return result ? std::string() : result.error().message;
  };
  EXPECT_NE(error(R"({"landmarks": {"noseTop": 1}})").find("noseTip"), std::string::npos);
  EXPECT_NE(error(R"({"landmarks": {"noseTip": "a"}})").find("/landmarks/noseTip"), std::string::npos);
  EXPECT_NE(error(R"({"landmarks": {"noseTip": 1}})").find("no \"noseBase\""), std::string::npos);
  EXPECT_NE(error("{}").find("landmarks"), std::string::npos);
  LandmarkPlaces all;
  for (const LandmarkName& l : landmark_names()) all[l.name] = Vec3(0.25, 1.0, 0.5);
  EXPECT_EQ(parse_landmarks(landmarks_text(all), "f.json").value(), all);
  const auto placed = placed_landmarks(mesh_of(head_of("adult")), {{"chin", 4'000'000u}}, "f.json");
  ASSERT_FALSE(placed);
  EXPECT_NE(placed.error().message.find("/landmarks/chin"), std::string::npos);
}

/// Multi-PIE's 68 points by their ICT-FaceKit vertices (its README).
LandmarkPlaces ict_landmarks() {
  constexpr std::uint32_t points[68] = {
      1225, 1888, 1052, 367,  1719, 1722, 2199, 1447, 966,  3661, 4390, 3927, 3924, 2608, 3272, 4088, 3443,
      268,  493,  1914, 2044, 1401, 3615, 4240, 4114, 2734, 2509, 978,  4527, 4942, 4857, 1140, 2075, 1147,
      4269, 3360, 1507, 1542, 1537, 1528, 1518, 1511, 3742, 3751, 3756, 3721, 3725, 3732, 5708, 5695, 2081,
      0,    4275, 6200, 6213, 6346, 6461, 5518, 5957, 5841, 5702, 5711, 5533, 6216, 6207, 6470, 5517, 5966};
  LandmarkPlaces out;
  const auto sides = [&](const std::string& name, int right, int left) {
    out[name + "Right"] = points[right];
    out[name + "Left"] = points[left];
  };
  out["eyeLine"] = points[27];
  out["noseTip"] = points[30];
  out["noseBase"] = points[33];
  out["lipTop"] = points[51];
  out["lipBottom"] = points[57];
  out["upperLip"] = points[62];
  out["lowerLip"] = points[66];
  out["chin"] = points[8];
  sides("browOuter", 17, 26);
  sides("browMiddle", 19, 24);
  sides("browInner", 21, 22);
  sides("noseWing", 31, 35);
  sides("eyeOuter", 36, 45);
  sides("lidUpperOuter", 37, 44);
  sides("lidUpperInner", 38, 43);
  sides("eyeInner", 39, 42);
  sides("lidLowerInner", 40, 47);
  sides("lidLowerOuter", 41, 46);
  sides("lipCorner", 48, 54);
  sides("lipTopSide", 49, 53);
  sides("lipPeak", 50, 52);
  sides("lipBottomSide", 59, 55);
  sides("upperLipSide", 61, 63);
  sides("lowerLipSide", 67, 65);
  sides("jawCorner", 4, 12);
  return out;
}

/// Of what the face moves at an expression: whether the chin falls, how far its lowest mover is under the chin.
void expect_face(const ModelFace& face, const std::string& what) {
  const Head& head = face.transfer.head;
  for (const FacePreset& e : expressions()) {
    const std::vector<Vec3> at = posed(head.face, head.positions, for_head(head.face, e.channels(false)));
    double farthest = 0.0;
    for (std::size_t v = 0; v < at.size(); ++v) {
      ASSERT_TRUE(std::isfinite(glm::length(at[v]))) << what << " " << e.name;
      const double move = glm::distance(at[v], head.positions[v]);
      farthest = std::max(farthest, move);
      // The template's neck ends there: what lies lower, shoulders and hands, has to stay.
      if (head.positions[v].y < -1.0 || head.positions[v].y > 3.6) {
        ASSERT_LT(move, 1e-9) << what << " " << e.name;
      }
    }
    // Two thirds of a unit is a jaw thrown open as far as it goes.
    EXPECT_LT(farthest, 0.9) << what << " " << e.name;
    if (e.name != "neutral" && !e.name.starts_with("look")) {
      EXPECT_GT(farthest, 0.01) << what << " " << e.name;
    }
  }
}

TEST(Transfer, IctFaceTakesEveryExpression) {
  SINEW_ASSETS_OR_SKIP(assets);
  const auto model = obj_model(assets / "faces/ict/generic_neutral_mesh.obj");
  ASSERT_TRUE(model);
  const auto face = model_face(*model, ict_landmarks(), "ict");
  ASSERT_TRUE(face) << face.error().message;
  EXPECT_TRUE(face->transfer.notes.empty());  // both eyes have balls and open lids
  expect_face(*face, "ict");
  const Head& head = face->transfer.head;
  const auto place = [&](const char* mark) {
    return face->transfer.place_of[std::get<std::uint32_t>(ict_landmarks().at(mark))];
  };
  // The lips touch there, and part.
  EXPECT_LT(head.face.vertices[place("upperLip")].jaw, 0.1);
  EXPECT_GT(head.face.vertices[place("lowerLip")].jaw, 0.9);
  EXPECT_GT(head.face.vertices[place("chin")].jaw, 0.9);
  EXPECT_GT(head.face.vertices[place("lidUpperInnerLeft")].close_upper, 0.2);
  EXPECT_EQ(head.face.vertices[place("lidUpperInnerLeft")].close_lower, 0.0);
}

/// A real head with the face that its own landmarks give it.
ModelFace found_face(const std::filesystem::path& file) {
  const auto model = read_mesh_model(file);
  EXPECT_TRUE(model) << model.error().message;
  const auto found = find_model_landmarks(*model);
  EXPECT_TRUE(found) << found.error().message;
  LandmarkPlaces places;
  for (const auto& [name, place] : found->marks) places[name] = place;
  auto face = model_face(*model, places, file.string());
  EXPECT_TRUE(face) << face.error().message;
  return std::move(*face);
}

TEST(Transfer, ShapesLeaveForeignEyeballsWhereTheyAre) {
  SINEW_ASSETS_OR_SKIP(assets);
  for (const char* file : {"characters/makehuman/mh_male_game.glb", "faces/ict/generic_neutral_mesh.obj"}) {
    const ModelFace face = found_face(assets / file);
    const Head& head = face.transfer.head;
    const HeadShape rest{"", head.positions, head.normals};
    for (const ShapeRecipe& recipe : shape_recipes(head.face, false)) {
      const auto changes = [&](std::initializer_list<FaceChannel> channels) {
        return std::ranges::any_of(channels, [&](FaceChannel c) { return channel(recipe.to, c) != 0.0; });
      };
      using C = FaceChannel;
      if (changes({C::eye_left_yaw, C::eye_left_pitch, C::eye_right_yaw, C::eye_right_pitch})) continue;
      const HeadShape shape =
          shape_of(head.face, rest, recipe, [&](const FaceChannels& c) { return posed_head(head, c); });
      std::array<double, 2> moved{};
      for (std::size_t v = 0; v < head.positions.size(); ++v)
        if (const FaceVertex& vertex = head.face.vertices[v]; vertex.ball)
          moved[static_cast<std::size_t>(vertex.eye)] = std::max(moved[static_cast<std::size_t>(vertex.eye)],
                                                                 glm::distance(shape.positions[v], head.positions[v]));
      const std::array<bool, 2> lids{changes({C::upper_lid_left, C::lower_lid_left}),
                                     changes({C::upper_lid_right, C::lower_lid_right})};
      // Shut lids need a fifth of the radius, and the ball's farthest vertex lies a little beyond its radius. What
      // moves the skin round the lids, such as the brow, pulls them a little.
      for (std::size_t eye = 0; eye < 2; ++eye)
        EXPECT_LT(moved[eye], (lids[eye] ? 1.1 * (1.0 - least_eye_share) : 0.02) * head.face.eye_radius)
            << file << " " << recipe.name << " eye " << eye;
    }
  }
}

TEST(Transfer, NormalsAreThoseOfTheMovedSurface) {
  SINEW_ASSETS_OR_SKIP(assets);
  const ModelFace face = found_face(assets / "characters/makehuman/mh_male_game.glb");
  const Head& head = face.transfer.head;
  for (const char* name : {"smile", "laugh", "surprise", "anger", "disgust"}) {
    const FaceState state = face_state(head.face, for_head(head.face, find_expression(name).value()->channels(false)));
    std::vector<Vec3> posed(head.positions.size()), normals(head.positions.size());
    FaceJob{head.face, state, head.positions, head.normals, posed, normals}.run();
    const std::vector<Vec3> wanted = head_normals(head, posed);
    double sum = 0.0;
    int count = 0;
    for (std::size_t v = 0; v < posed.size(); ++v) {
      if (glm::distance(posed[v], head.positions[v]) > 1e-3) {
        sum += angle_degrees(normals[v], wanted[v]);
        ++count;
      } else if (wanted[v] == head.normals[v]) {
        ASSERT_LT(angle_degrees(normals[v], wanted[v]), 1.0) << name << ": what does not move is shaded as at rest";
      }
    }
    // Signals add up linearly, surfaces turn: a few degrees where several meet.
    EXPECT_LT(sum / count, 4.0) << name;
  }
}

TEST(Transfer, LipsThatTouchAlongACutPart) {
  SINEW_ASSETS_OR_SKIP(assets);
  const ModelFace face = found_face(assets / "characters/mesh2motion/human-sintel.glb");
  EXPECT_TRUE(face.transfer.notes.empty()) << face.transfer.notes[0];  // eyes that lie on the lids' edge are balls
  // In the middle of the mouth the jaw's share never changes between neighbours by more than a lip's thickness does.
  const FaceRig& rig = face.transfer.head.face;
  const std::vector<Vec3>& at = face.transfer.head.positions;
  const double contact = 0.66, half_mouth = 0.15;  // drawing units
  for (const HeadTriangle& t : face.transfer.head.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = t.corners[c], b = t.corners[(c + 1) % 3];
      if (std::abs(at[a].x) > half_mouth || std::abs(at[a].y - contact) > 0.1 || at[a].z < 1.3) continue;
      EXPECT_LT(std::abs(rig.vertices[a].jaw - rig.vertices[b].jaw), 0.5) << a << " " << b;
    }
}

TEST(Transfer, ABodyWithoutASkeletonHasItsHeadAboveItsNeck) {
  SINEW_ASSETS_OR_SKIP(assets);
  // A body with helpers for clothes and joints about it, in decimetres.
  const auto model = read_mesh_model(assets / "makehuman/base.obj");
  ASSERT_TRUE(model) << model.error().message;
  const auto found = find_model_landmarks(*model);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_TRUE(found->by_features);
  // Its foremost vertex, and where the chin turns under.
  EXPECT_NEAR(found->marks.at("noseTip").y, 6.914, 0.03);
  EXPECT_NEAR(found->marks.at("chin").y, 6.17, 0.04);
  const ModelFace face = found_face(assets / "makehuman/base.obj");
  EXPECT_NEAR(face.transfer.head.measures.height, 2.3, 0.25);
  EXPECT_TRUE(face.transfer.notes.empty());
  expect_face(face, "base.obj");
}

TEST(Transfer, AHeadWithoutAFaceIsKnown) {
  auto body = built_in_model("builtin:woman");
  ASSERT_TRUE(body);
  const auto smooth = find_model_landmarks(*body);
  ASSERT_TRUE(smooth) << smooth.error().message;
  EXPECT_FALSE(smooth->by_features);
  SINEW_ASSETS_OR_SKIP(assets);
  // A crown hides the face: what is missing is named.
  const auto king = read_mesh_model(assets / "characters/quaternius/modular_men_King.glb");
  ASSERT_TRUE(king);
  const auto found = find_model_landmarks(*king);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().kind, ErrorKind::bad_input);
  EXPECT_NE(found.error().message.find("no \"eyeInnerLeft\""), std::string::npos) << found.error().message;
}

TEST(Transfer, MakeHumanBodyFindsItsOwnLandmarks) {
  SINEW_ASSETS_OR_SKIP(assets);
  const auto model = read_mesh_model(assets / "characters/makehuman/mh_male_game.glb");
  ASSERT_TRUE(model);
  const auto found = find_model_landmarks(*model);
  ASSERT_TRUE(found) << found.error().message;
  LandmarkPlaces places;
  for (const auto& [name, place] : found->marks) places[name] = place;
  const auto face = model_face(*model, places, "mh");
  ASSERT_TRUE(face) << face.error().message;
  expect_face(*face, "makehuman");
  // A head is an eighth to a seventh of a man.
  EXPECT_NEAR(face->transfer.head.measures.height, 0.23, 0.03);
  int balls = 0;
  for (const FaceVertex& v : face->transfer.head.face.vertices) balls += v.ball;
  EXPECT_GT(balls, 100);
  const auto character = character_face(*face, character_mesh(*model), "mh");
  ASSERT_TRUE(character);
  EXPECT_NEAR(character->place.unit, face->transfer.to_mesh.scale, 1e-9);
}

}  // namespace
}  // namespace sinew::test
