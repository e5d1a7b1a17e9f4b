#include "engine/body/headed_figure.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "engine/deform/face.h"
#include "engine/face/head_model.h"

namespace sinew::test {
namespace {

struct Kind {
  const char* name;
  BodyOptions options;
  double age;
};

std::vector<Kind> kinds() {
  BodyOptions woman = *figure_preset("woman"), skeleton = *figure_preset("skeleton"), heavy, slim;
  heavy.build = heavy.muscle = 1.0;
  slim.sex = 1.0, slim.build = -1.0, slim.muscle = 0.0, slim.height = 1.2;
  return {{"default", {}, 0.0},
          {"woman", woman, 0.25},
          {"skeleton", skeleton, 0.0},
          {"heavy", heavy, 0.0},
          {"slim child", slim, 0.75}};
}

HeadedFigure built(const Kind& kind, bool with_shapes = false) {
  auto out = build_headed_figure(kind.options, measures_of_age(kind.age), 1, with_shapes);
  EXPECT_TRUE(out) << kind.name << ": " << out.error().message;
  return std::move(*out);
}

using Key = std::tuple<double, double, double>;
Key key_of(const Vec3& p) { return {p.x, p.y, p.z}; }

using VertexWeights = std::map<std::uint32_t, double>;
VertexWeights run_of(const Primitive& primitive, std::size_t v) {
  VertexWeights out;
  for (std::uint32_t i = primitive.influences.first[v]; i < primitive.influences.first[v + 1]; ++i)
    out[primitive.influences.entries[i].joint] = primitive.influences.entries[i].weight;
  return out;
}

double difference(const VertexWeights& a, const VertexWeights& b) {
  double sum = 0.0;
  for (const auto& [joint, weight] : a) sum += std::abs(weight - (b.contains(joint) ? b.at(joint) : 0.0));
  for (const auto& [joint, weight] : b)
    if (!a.contains(joint)) sum += weight;
  return 0.5 * sum;
}

TEST(HeadedFigure, IsAsTallAsAskedAndItsHeadSitsOnTop) {
  for (const Kind& kind : kinds()) {
    const HeadedFigure figure = built(kind);
    double high = 0.0, plain_high = 0.0;
    for (const Primitive& primitive : figure.model.meshes[0].primitives)
      for (const Vec3& p : primitive.positions) high = std::max(high, p.y);
    const Model plain = *build_figure(kind.options);
    for (const Vec3& p : plain.meshes[0].primitives[0].positions) plain_high = std::max(plain_high, p.y);
    EXPECT_NEAR(high, plain_high, 1e-9) << kind.name;
    const Vec3 chin = figure.origin + figure.head.metres() * figure.head.positions[figure.head.landmarks.at("chin")];
    EXPECT_NEAR(plain_high - chin.y, 0.127 * plain_high, 0.002 * plain_high) << kind.name;
  }
}

// Below the cut every vertex of the plain figure stands as it stood.
TEST(HeadedFigure, KeepsTheBody) {
  for (const Kind& kind : kinds()) {
    const HeadedFigure figure = built(kind);
    const Primitive& skin = figure.model.meshes[0].primitives[0];
    std::set<Key> there;
    for (const Vec3& p : skin.positions) there.insert(key_of(p));
    const Model plain = *build_figure(kind.options);
    std::size_t kept = 0;
    double highest_kept = 0.0, lowest_gone = INFINITY;
    for (const Vec3& p : plain.meshes[0].primitives[0].positions) {
      if (there.contains(key_of(p)))
        ++kept, highest_kept = std::max(highest_kept, p.y);
      else
        lowest_gone = std::min(lowest_gone, p.y);
    }
    // A head has about a fifth of the vertices of a figure.
    EXPECT_GT(kept, 7 * plain.meshes[0].primitives[0].positions.size() / 10) << kind.name;
    EXPECT_LT(highest_kept, figure.origin.y + 0.03) << kind.name << ": nothing of the plain head above the chin";
    EXPECT_GT(lowest_gone, figure.origin.y - 0.08) << kind.name;
  }
}

TEST(HeadedFigure, IsSymmetric) {
  for (const Kind& kind : kinds()) {
    const HeadedFigure figure = built(kind);
    for (const Primitive& primitive : figure.model.meshes[0].primitives) {
      std::set<Key> there;
      for (const Vec3& p : primitive.positions) there.insert(key_of({p.x == 0.0 ? 0.0 : p.x, p.y, p.z}));
      for (const Vec3& p : primitive.positions)
        EXPECT_TRUE(there.contains(key_of({p.x == 0.0 ? 0.0 : -p.x, p.y, p.z})))
            << kind.name << " " << p.x << " " << p.y << " " << p.z;
    }
  }
}

/// Edges of the figure's skin and the face's, welded by place.
std::map<std::pair<Key, Key>, int> skin_edges(const Model& model) {
  std::map<std::pair<Key, Key>, int> uses;
  for (const Primitive& primitive : model.meshes[0].primitives) {
    const std::string& name = model.materials[static_cast<std::size_t>(primitive.material)].name;
    if (name != "skin" && name != "face" && name != "lips" && name != "mouth" && name != "nostrils" && name != "lashes")
      continue;
    for (std::size_t i = 0; i < primitive.indices.size(); i += 3)
      for (std::size_t c = 0; c < 3; ++c) {
        Key a = key_of(primitive.positions[primitive.indices[i + c]]),
            b = key_of(primitive.positions[primitive.indices[i + (c + 1) % 3]]);
        if (b < a) std::swap(a, b);
        ++uses[{a, b}];
      }
  }
  return uses;
}

// The sleeves of the lids, hidden in the eyeballs, are the only border that is left.
TEST(HeadedFigure, HasNoGapAtTheNeck) {
  for (const Kind& kind : kinds()) {
    const HeadedFigure figure = built(kind);
    int open = 0, used = 0;
    for (const auto& [edge, uses] : skin_edges(figure.model)) {
      // An edge of no length joins a point to itself.
      if (edge.first == edge.second) continue;
      EXPECT_LE(uses, 2) << kind.name;
      ++used;
      if (uses != 1) continue;
      ++open;
      EXPECT_GT(std::get<1>(edge.first), figure.origin.y + 0.04 * figure.head.measures.height / 0.23)
          << kind.name << ": open below the eyes";
    }
    EXPECT_EQ(open, 64) << kind.name << ": two sleeves of 32 edges";
    EXPECT_GT(used, 10000) << kind.name;
  }
}

// A head that turns may tear nothing: along no edge, and over no shared place, do the influences jump.
TEST(HeadedFigure, WeightsRunOnOverTheNeck) {
  for (const Kind& kind : kinds()) {
    const HeadedFigure figure = built(kind);
    std::map<Key, VertexWeights> at;
    double most = 0.0;
    for (const Primitive& primitive : figure.model.meshes[0].primitives) {
      for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
        const VertexWeights run = run_of(primitive, v);
        double sum = 0.0;
        for (const auto& [joint, weight] : run) sum += weight;
        EXPECT_NEAR(sum, 1.0, 1e-12);
        EXPECT_LE(run.size(), 4u);
        const auto [place, is_new] = at.try_emplace(key_of(primitive.positions[v]), run);
        if (!is_new) {
          EXPECT_LT(difference(place->second, run), 1e-9) << kind.name;
        }
      }
      for (std::size_t i = 0; i < primitive.indices.size(); i += 3) {
        const Vec3& a = primitive.positions[primitive.indices[i]];
        if (std::abs(a.y - figure.origin.y) > 0.08 || std::abs(a.x) > 0.1) continue;
        most = std::max(
            most, difference(run_of(primitive, primitive.indices[i]), run_of(primitive, primitive.indices[i + 1])));
      }
    }
    // The borders between vertebrae are some 6 cm wide; the edges of this level's heads reach half as far, a coarse
    // figure's further.
    EXPECT_LT(most, kind.options.vertices < 4000 ? 0.8 : 0.5) << kind.name;
  }
}

TEST(HeadedFigure, TheFaceFollowsTheSkullAndStillMoves) {
  const HeadedFigure figure = built(kinds()[0], true);
  const Model& model = figure.model;
  const auto skull = static_cast<std::uint32_t>(
      std::ranges::find_if(
          model.skins[0].joints,
          [&](int joint) { return model.nodes[static_cast<std::size_t>(joint)].name == "skullbase"; }) -
      model.skins[0].joints.begin());
  std::size_t first = 0, face = 0;
  const auto from = head_vertices(figure.head);
  for (const Primitive& primitive : model.meshes[0].primitives) {
    EXPECT_EQ(primitive.morph_targets.size(), model.meshes[0].morph_weights.size());
    if (&primitive != &model.meshes[0].primitives[0])
      for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
        const Vec3& rest = figure.head.positions[from[first + v - figure.first_vertex]];
        EXPECT_LT(glm::distance(primitive.positions[v], figure.origin + figure.head.metres() * rest), 1e-12);
        if (rest.y < 0.3 || rest.z < 0.7) continue;
        ++face;
        EXPECT_EQ(run_of(primitive, v), (VertexWeights{{skull, 1.0}}));
      }
    first += primitive.positions.size();
  }
  EXPECT_EQ(first, figure.first_vertex + from.size());
  EXPECT_GT(face, 1000u);
  // A dropping jaw takes the chin along and leaves the lower neck where it is.
  FaceChannels drop{};
  channel(drop, FaceChannel::jaw_drop) = 0.5;
  const auto open = posed_positions(figure.head, drop);
  const std::uint32_t chin = figure.head.landmarks.at("chin");
  EXPECT_LT(open[chin].y, figure.head.positions[chin].y - 0.3);
  std::set<std::uint32_t> used(from.begin(), from.end());
  for (const std::uint32_t v : used)
    if (figure.head.positions[v].y < -0.45) {
      EXPECT_LT(glm::distance(open[v], figure.head.positions[v]), 0.02) << "a drawing unit is 6 cm";
    }
}

TEST(HeadedFigure, EqualOptionsGiveTheSameBits) {
  const HeadedFigure a = built(kinds()[1]), b = built(kinds()[1]);
  ASSERT_EQ(a.model.meshes[0].primitives.size(), b.model.meshes[0].primitives.size());
  for (std::size_t p = 0; p < a.model.meshes[0].primitives.size(); ++p) {
    EXPECT_EQ(a.model.meshes[0].primitives[p].positions, b.model.meshes[0].primitives[p].positions);
    EXPECT_EQ(a.model.meshes[0].primitives[p].indices, b.model.meshes[0].primitives[p].indices);
  }
}

TEST(HeadedFigure, WrongOptionsAreTold) {
  BodyOptions options;
  options.joints = 5;
  const auto figure = build_headed_figure(options, measures_of_age(0.0));
  ASSERT_FALSE(figure);
  EXPECT_NE(figure.error().message.find("--joints 5"), std::string::npos);
  HeadMeasures crossed = measures_of_age(0.0);
  crossed.mouth_height = crossed.nose_height + 0.2;
  EXPECT_FALSE(build_headed_figure({}, crossed));
}

}  // namespace
}  // namespace sinew::test
