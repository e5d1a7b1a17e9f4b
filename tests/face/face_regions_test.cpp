/// Regions on a real head: limits, lids that slide, lips that meet, nothing turned inside out.

#include "tests/face/head_fixture.h"

namespace sinew::test {
namespace {

using C = FaceChannel;

const std::vector<std::string> emotions = {"neutral", "smile", "laugh",   "anger", "surprise",
                                           "shout",   "fear",  "sadness", "doubt", "disgust"};

/// Where the skin comes nearest to an eyeball, in its radii: corners, edges and middles of the lids' triangles.
double nearest_lid(const Head& head, const std::vector<Vec3>& posed) {
  double least = INFINITY;
  for (const HeadTriangle& t : head.triangles) {
    if (t.corners[0] >= head.skin_vertices) continue;
    bool lid = true;
    for (const std::uint32_t v : t.corners) lid = lid && head.face.vertices[v].least_distance > 0.0;
    if (!lid) continue;
    const Vec3 &a = posed[t.corners[0]], &b = posed[t.corners[1]], &c = posed[t.corners[2]];
    const Vec3& centre = head.face.eye_centres[static_cast<std::size_t>(head.face.vertices[t.corners[0]].eye)];
    for (const Vec3& p : {a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (a + b + c) / 3.0})
      least = std::min(least, glm::distance(p, centre) / head.face.eye_radius);
  }
  return least;
}

/// The least gap between the lips where they meet, drawing units.
double lip_gap(const Head& head, const std::vector<Vec3>& posed) {
  double least = INFINITY;
  for (const auto& [upper, lower] : head.lip_line) least = std::min(least, posed[upper].y - posed[lower].y);
  return least;
}

/// Triangles of the skin that face away from all three of their corners' normals: turned over against the surface round
/// them. The mouth's and nostrils' insides, which nobody sees, do not count.
int turned_over(const Head& head, const std::vector<Vec3>& posed) {
  const std::vector<Vec3> normals = head_normals(head, posed);
  int count = 0;
  for (const HeadTriangle& t : head.triangles) {
    if (t.material != HeadMaterial::skin && t.material != HeadMaterial::lip && t.material != HeadMaterial::lash)
      continue;
    const Vec3 face = glm::cross(posed[t.corners[1]] - posed[t.corners[0]], posed[t.corners[2]] - posed[t.corners[0]]);
    bool away = true;
    for (const std::uint32_t v : t.corners) away = away && glm::dot(face, normals[v]) < 0.0;
    count += away;
  }
  return count;
}

void expect_sound(const Head& head, const std::vector<Vec3>& posed, const std::string& what) {
  // Chords between vertices that are pushed out to 1.037 radii stay outside the ball.
  EXPECT_GT(nearest_lid(head, posed), 1.0) << what;
  // At rest the lips' vertices lie 0.003 to 0.02 apart.
  EXPECT_GT(lip_gap(head, posed), -1e-9) << what;
  EXPECT_EQ(turned_over(head, posed), 0) << what;
}

TEST(FaceRegions, ExpressionsAreSoundAtEveryStrengthAgeAndSkull) {
  for (const std::string& age : {std::string("adult"), std::string("child"), std::string("infant")})
    for (const std::string& skull : {std::string(), std::string("round")})
      for (const std::string& name : emotions)
        for (const double strength : {0.25, 0.5, 0.75, 1.0, 1.6})
          expect_sound(head_of(age, skull), shown(head_of(age, skull), name, strength),
                       age + " " + skull + " " + name + " " + std::to_string(strength));
}

TEST(FaceRegions, ExpressionsAreSoundOnTheFineMesh) {
  for (const std::string& name : emotions)
    expect_sound(head_of("adult", "", 2), shown(head_of("adult", "", 2), name, 1.0), name);
}

TEST(FaceRegions, FiveHundredRandomMixesAreSound) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> strength(0.0, 1.2);
  std::uniform_int_distribution<std::size_t> which(0, expressions().size() - 1);
  const Head& head = head_of("adult");
  for (int i = 0; i < 500; ++i) {
    std::vector<WeighedExpression> mix;
    std::string words;
    for (int k = 0; k < 3; ++k) {
      mix.push_back({&expressions()[which(random)], strength(random)});
      words += mix.back().expression->name + " " + std::to_string(mix.back().strength) + " ";
    }
    expect_sound(head, shown(head, mix_expressions(mix, false)), words);
  }
}

TEST(FaceRegions, MovesBeyondTheirLimitsAreHeldAndReported) {
  const FaceRig& face = head_of("adult").face;
  for (std::size_t i = 0; i < face_channels; ++i)
    for (const double far : {-1e3, 1e3}) {
      FaceChannels asked{};
      asked[i] = far;
      const HeldFace held = hold_at_limits(face, asked);
      ASSERT_EQ(held.held.size(), 1u) << i;
      EXPECT_EQ(held.held[0].channel, static_cast<C>(i));
      EXPECT_EQ(held.held[0].asked, far);
      EXPECT_EQ(held.held[0].held, held.channels[i]);
      EXPECT_TRUE(hold_at_limits(face, held.channels).held.empty()) << "held again at " << held.channels[i];
    }
  EXPECT_TRUE(hold_at_limits(face, FaceChannels{}).held.empty());
}

TEST(FaceRegions, BrowsAreHeldByTheirHighestAndLowestPoints) {
  const FaceRig& face = head_of("adult").face;
  FaceChannels asked{};
  channel(asked, C::brow_left_turn) = 20.0;
  channel(asked, C::brow_left_up) = 1.0;
  const HeldFace held = hold_at_limits(face, asked);
  // The outer end is up already, so the whole may rise less far.
  EXPECT_LT(channel(held.channels, C::brow_left_up), face.limits.eyebrow_up_vertical - 0.05);
  double rest = -INFINITY, high = -INFINITY;
  const double slope = std::tan(20.0 * degrees_to_radians);
  for (const Vec2& p : face.brow_outline) {
    rest = std::max(rest, p.y);
    high = std::max(high, p.y + slope * (p.x - face.brow_inner) + channel(held.channels, C::brow_left_up));
  }
  EXPECT_NEAR(high - rest, face.limits.eyebrow_up_vertical, 1e-9);
}

TEST(FaceRegions, TheBrowsFreeEndRises) {
  // Counter-clockwise for the viewer about the leftmost end, clockwise about the rightmost (Yen 1990, 4.2).
  const Head& head = head_of("adult");
  for (const double turn : {15.0, -15.0})
    for (const bool left : {true, false}) {
      FaceChannels c{};
      channel(c, left ? C::brow_left_turn : C::brow_right_turn) = turn;
      const std::vector<Vec3> posed = posed_positions(head, c);
      double leftmost = INFINITY, rightmost = -INFINITY, at_left = 0, at_right = 0;
      for (const HeadTriangle& t : head.triangles)
        for (const std::uint32_t v : t.corners) {
          const Vec3& p = head.positions[v];
          if (t.material != HeadMaterial::brow || (p.x > 0) != left) continue;
          if (p.x < leftmost) leftmost = p.x, at_left = posed[v].y - p.y;
          if (p.x > rightmost) rightmost = p.x, at_right = posed[v].y - p.y;
        }
      const double free_end = turn > 0 ? at_right : at_left, pivot = turn > 0 ? at_left : at_right;
      EXPECT_GT(free_end, 0.08) << turn << left;
      EXPECT_LT(std::abs(pivot), 0.02) << turn << left;
    }
}

TEST(FaceRegions, AShutLidComesDownAndCornersStay) {
  const Head& head = head_of("adult", "", 2);
  FaceChannels c{};
  channel(c, C::upper_lid_left) = 1.0;
  const std::vector<Vec3> posed = posed_positions(head, c);
  EXPECT_GT(nearest_lid(head, posed), 1.0);
  // The lid comes down: none of its points rises.
  double highest_upper = -INFINITY;
  for (std::size_t v = 0; v < head.skin_vertices; ++v) {
    const FaceVertex& vertex = head.face.vertices[v];
    if (vertex.eye == 0 && vertex.close_upper > 0.0)
      highest_upper = std::max(highest_upper, posed[v].y - head.positions[v].y);
    if (vertex.close_upper == 0.0) {
      EXPECT_LT(glm::distance(posed[v], head.positions[v]), 1e-12) << v;
    }
  }
  EXPECT_LE(highest_upper, 1e-3);
}

TEST(FaceRegions, SealedLipsStayShutWhileTheJawDrops) {
  const Head& head = head_of("adult");
  FaceChannels open{}, sealed{};
  channel(open, C::jaw_drop) = channel(sealed, C::jaw_drop) = 0.3;
  channel(sealed, C::lip_seal) = 1.0;
  const std::vector<Vec3> gaping = posed_positions(head, open), shut = posed_positions(head, sealed);
  EXPECT_GT(gaping[head.lip_line[0][0]].y - gaping[head.lip_line[0][1]].y, 0.15);
  for (const auto& [upper, lower] : head.lip_line)
    EXPECT_NEAR(shut[upper].y - shut[lower].y, head.positions[upper].y - head.positions[lower].y, 0.004);
  const std::uint32_t chin = head.landmarks.at("chin");
  // The chin's underside runs over into the neck, which stays.
  EXPECT_NEAR(head.positions[chin].y - shut[chin].y, 0.3, 0.08);
}

TEST(FaceRegions, TheJawTakesTheLowerTeethAlong) {
  const Head& head = head_of("adult");
  FaceChannels c{};
  channel(c, C::jaw_drop) = 0.4;
  const std::vector<Vec3> posed = posed_positions(head, c);
  double upper = 0.0, lower = INFINITY;
  for (const HeadTriangle& t : head.triangles)
    if (t.material == HeadMaterial::teeth)
      for (const std::uint32_t v : t.corners) {
        const double fall = head.positions[v].y - posed[v].y;
        if (head.face.vertices[v].jaw == 0.0)
          upper = std::max(upper, std::abs(fall));
        else
          lower = std::min(lower, fall);
      }
  EXPECT_EQ(upper, 0.0);
  EXPECT_GT(lower, 0.15);
}

TEST(FaceRegions, PuckeredAndPressedLipsAreNarrowerAndThinner) {
  const Head& head = head_of("adult");
  const auto size = [&](C c) {
    FaceChannels channels{};
    channel(channels, c) = 1.0;
    const std::vector<Vec3> posed = posed_positions(head, channels);
    Bounds bounds;
    for (const HeadTriangle& t : head.triangles)
      if (t.material == HeadMaterial::lip)
        for (const std::uint32_t v : t.corners) bounds.add(posed[v]);
    return bounds.high - bounds.low;
  };
  const Vec3 rest = size(C::nose_wrinkle);
  EXPECT_LT(size(C::lip_pucker).x, 0.65 * rest.x);
  EXPECT_LT(size(C::lip_press).y, 0.70 * rest.y);
}

TEST(FaceRegions, NormalsForTheComputePassAreThoseOfTheSurface) {
  const Head& head = head_of("adult", "", 2);
  for (const std::string& name : emotions) {
    const WeighedExpression one[] = {{find_expression(name).value(), 1.0}};
    const FaceState state =
        face_state(head.face, hold_at_limits(head.face, for_head(head.face, mix_expressions(one, false))).channels);
    std::vector<Vec3> posed(head.positions.size()), normals(posed.size());
    const FaceJob job{head.face, state, head.positions, head.normals, posed, normals};
    ASSERT_TRUE(job.validate());
    job.run();
    const std::vector<Vec3> exact = head_normals(head, posed);
    double sum = 0.0;
    for (std::size_t v = 0; v < head.skin_vertices; ++v) sum += angle_degrees(normals[v], exact[v]);
    // Signals are linear in the normals, the surface is not: exact for one at its limit, near for several.
    EXPECT_LT(sum / double(head.skin_vertices), 1.5) << name;
  }
}

TEST(FaceJob, SaysWhichSpanIsShort) {
  const Head& head = head_of("adult");
  const FaceState state = face_state(head.face, {});
  std::vector<Vec3> posed(head.positions.size()), few(3);
  EXPECT_TRUE((FaceJob{head.face, state, head.positions, {}, posed, {}}.validate()));
  EXPECT_NE((FaceJob{head.face, state, few, {}, posed, {}}.validate().error().message.find("rest")), std::string::npos);
  EXPECT_NE((FaceJob{head.face, state, head.positions, {}, few, {}}.validate().error().message.find("posed")),
            std::string::npos);
  EXPECT_NE(
      (FaceJob{head.face, state, head.positions, few, posed, posed}.validate().error().message.find("rest_normals")),
      std::string::npos);
}

}  // namespace
}  // namespace sinew::test
