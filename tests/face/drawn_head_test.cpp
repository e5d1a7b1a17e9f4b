#include "engine/face/drawn_head.h"

#include <gtest/gtest.h>

#include "engine/face/head_model.h"

namespace sinew::test {
namespace {

const HeadSpec film{.age = {{{0, 0.0}, {48, 1.0}}, Ease::linear}, .skull = {{"round", 0.5}}, .level = 1};

const DrawnHead& aging() {
  static const DrawnHead head = *DrawnHead::make(film, 0.0);
  return head;
}

CharacterMesh mesh_at(const DrawnHead& head, double frame) {
  CharacterMesh mesh = character_mesh(head.model());
  mesh.face = head.face();
  head.age(frame, mesh);
  return mesh;
}

/// A head drawn at this very age.
struct Exact {
  Head head;
  std::vector<std::uint32_t> vertices;
};
Exact exact(double age) {
  HeadMeasures measures = measures_of_age(age);
  apply_skull(film.skull, measures);
  Exact out{*HeadMaker(1).head(measures), {}};
  out.vertices = head_vertices(out.head);
  return out;
}

TEST(DrawnHead, ItsFaceIsThatOfItsMesh) {
  const CharacterMesh mesh = character_mesh(aging().model());
  EXPECT_EQ(aging().face().rig.vertices.size(), mesh.vertices());
  const Exact adult = exact(0.0);
  ASSERT_EQ(adult.vertices.size(), mesh.vertices());
  for (std::size_t v = 0; v < mesh.vertices(); ++v)
    ASSERT_EQ(mesh.positions[v], adult.head.metres() * adult.head.positions[adult.vertices[v]]);
}

/// Half way between two drawn heads, where a blend is worst, and at one of them.
TEST(DrawnHead, EveryAgeIsTheHeadThatWouldBeDrawn) {
  for (const auto& [frame, tolerance] : {std::pair{12.0, 1e-12}, {13.5, 1e-3}, {31.5, 1e-3}}) {
    const CharacterMesh mesh = mesh_at(aging(), frame);
    const Exact there = exact(frame / 48.0);
    const double metres = there.head.metres();
    EXPECT_NEAR(mesh.face->place.unit, metres, 1e-12);
    double worst = 0.0;
    for (std::size_t v = 0; v < mesh.vertices(); ++v)
      worst = std::max(worst, glm::distance(mesh.positions[v] / metres, there.head.positions[there.vertices[v]]));
    // A thousandth of a head's height.
    EXPECT_LE(worst, tolerance * head_units) << frame;
    EXPECT_NEAR(mesh.face->rig.limits.chin_drop, there.head.face.limits.chin_drop, 1e-3);
  }
}

TEST(DrawnHead, EveryAgeHasTheSameVerticesAndDeltas) {
  const CharacterMesh young = mesh_at(aging(), 47), old = mesh_at(aging(), 0.5);
  EXPECT_EQ(young.vertices(), old.vertices());
  EXPECT_EQ(young.triangles, old.triangles);
  ASSERT_EQ(young.face->rig.first, old.face->rig.first);
  for (std::size_t i = 0; i < young.face->rig.deltas.size(); ++i)
    ASSERT_EQ(young.face->rig.deltas[i].signal, old.face->rig.deltas[i].signal);
}

TEST(DrawnHead, OneAgeNeverChanges) {
  const auto head = DrawnHead::make({.level = 0}, 0.0);
  ASSERT_TRUE(head);
  EXPECT_FALSE(head->changes());
}

TEST(DrawnHead, WrongNamesAndNumbersSayWhere) {
  struct Case {
    HeadSpec spec;
    const char *place, *said;
  };
  for (const auto& [spec, place, said] : {Case{{.skull = {{"rund", 1.0}}}, "/skull: ", "\"round\""},
                                          Case{{.measures = {{"mouth", 0.4}}}, "/measures: ", "mouth"},
                                          Case{{.measures = {{"mouth_width", 4.0}}}, "/measures: ", "0.2"},
                                          Case{{.measures = {{"eye_height", 2.1}}}, ": ", "cross"},
                                          Case{{.file = "nowhere.json"}, "/file: ", "nowhere.json"}}) {
    const auto head = DrawnHead::make(spec, 0.0);
    ASSERT_FALSE(head) << said;
    EXPECT_EQ(head.error().message.substr(0, std::string(place).size()), place) << head.error().message;
    EXPECT_NE(head.error().message.find(said), std::string::npos) << head.error().message;
  }
}

}  // namespace
}  // namespace sinew::test
