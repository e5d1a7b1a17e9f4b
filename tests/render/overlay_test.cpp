#include "engine/render/overlay.h"

#include <gtest/gtest.h>

#include "engine/render/screen.h"

namespace sinew {
namespace {

constexpr int width = 640, height = 480;

Picture grey() { return {width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height, 0xD8)}; }

Viewpoint front_view() {
  Bounds box;
  box.add(Vec3(-1.0));
  box.add(Vec3(1.0));
  return look_at(Vec3(0.0), 6.0, box, {0.0, 0.0});
}

Mat4 at(const Vec3& place) {
  Mat4 m(1.0);
  m[3] = Vec4(place, 1.0);
  return m;
}

/// A chain: root, a node that is no joint, a joint, and an end.
SkeletonOverlay chain() {
  SkeletonOverlay skeleton;
  skeleton.global = {at({-0.8, -0.5, 0}), at({0.5, 0.9, 0}), at({0.1, 0.2, 0.3}), at({0.7, 0.6, -0.2})};
  skeleton.parents = {-1, 0, 1, 2};
  skeleton.joints = {true, false, true, true};
  skeleton.names = {"root", "helper", "elbow", "tip"};
  return skeleton;
}

/// Pixels within `radius` of a place that differ between the pictures.
int changed_near(const Picture& a, const Picture& b, const Vec2& place, double radius) {
  int changed = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const std::size_t i = (std::size_t(y) * a.width + x) * 4;
      if (glm::distance(place, Vec2(x + 0.5, y + 0.5)) <= radius && !std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]))
        ++changed;
    }
  return changed;
}

Picture drawn(const OverlayContent& content, const Font* font = nullptr, const Viewpoint& view = front_view()) {
  Picture picture = grey();
  const auto ok = draw_overlay(picture, font, view, content);
  EXPECT_TRUE(ok) << ok.error().message;
  return picture;
}

Font any_font() {
  auto font = Font::find();
  if (!font) throw std::runtime_error(font.error().message);
  return std::move(*font);
}

TEST(Overlay, InkIsWhereTheJointsAre) {
  const SkeletonOverlay skeleton = chain();
  const Screen screen(front_view(), width, height);
  for (const BoneShape shape : {BoneShape::diamond, BoneShape::line}) {
    OverlayContent content;
    content.skeletons = {skeleton};
    content.skeletons[0].shape = shape;
    const Picture picture = drawn(content), plain = grey();
    for (const int node : {0, 2, 3})
      EXPECT_GT(changed_near(picture, plain, screen.point(Vec3(skeleton.global[node][3]))->at, 3.0), 20) << node;
    EXPECT_EQ(changed_near(picture, plain, screen.point(Vec3(skeleton.global[1][3]))->at, 6.0), 0) << "no joint";
    const Vec3 middle = 0.5 * Vec3(skeleton.global[0][3] + skeleton.global[2][3]);
    EXPECT_GT(changed_near(picture, plain, screen.point(middle)->at, 3.0), 2) << "a bone past what is no joint";
    EXPECT_EQ(changed_near(picture, plain, {20.0, 20.0}, 15.0), 0);
  }
}

TEST(Overlay, FarBonesAreFainterAndBehindNearOnes) {
  SkeletonOverlay skeleton;
  skeleton.global = {at({-0.8, 0, 0.9}), at({-0.4, 0, 0.9}), at({0.4, 0, -0.9}), at({0.8, 0, -0.9})};
  skeleton.parents = {-1, 0, -1, 2};
  skeleton.joints = {true, true, true, true};
  OverlayContent content;
  content.skeletons = {skeleton};
  const Picture picture = drawn(content);
  const Screen screen(front_view(), width, height);
  const auto difference = [&](int node) {
    const Vec2 p = screen.point(Vec3(skeleton.global[node][3]))->at;
    const std::size_t i = (std::size_t(p.y) * width + std::size_t(p.x) + 2) * 4;
    return std::abs(picture.rgba[i] - 0xD8) + std::abs(picture.rgba[i + 1] - 0xD8) +
           std::abs(picture.rgba[i + 2] - 0xD8);
  };
  EXPECT_GT(difference(0), 1.2 * difference(2));
}

TEST(Overlay, SurvivesWhatLiesBehindTheEyeOrNowhere) {
  SkeletonOverlay skeleton = chain();
  skeleton.global[3] = at({0.2, 0.1, 30.0});
  OverlayContent content;
  content.skeletons = {skeleton};
  const Picture cut = drawn(content), plain = grey();
  const Screen screen(front_view(), width, height);
  EXPECT_GT(changed_near(cut, plain, screen.point({0.1, 0.2, 0.3})->at, 4.0), 20);
  for (const double bad : {double(NAN), double(INFINITY), 1e300, -1e300}) {
    content.skeletons[0].global[2] = at(Vec3(bad));
    content.box = Bounds{Vec3(-1.0), Vec3(std::abs(bad))};
    content.muscles = {MuscleOverlay{}};
    content.muscles[0].plane = {Vec3(bad), Vec3(0.0), Vec3(1.0), Vec3(bad, 0, 0)};
    content.muscles[0].centre = Vec3(0.0, 0.0, bad);
    content.muscles[0].points = {Vec3(bad), Vec3(0.0)};
    const Font font = any_font();
    (void)drawn(content, &font);
  }
}

TEST(Overlay, RefusesSkeletonsThatAreNone) {
  Picture picture = grey();
  const auto reason = [&](const SkeletonOverlay& skeleton) {
    OverlayContent content;
    content.skeletons = {skeleton};
    const auto ok = draw_overlay(picture, nullptr, front_view(), content);
    return ok ? std::string() : ok.error().message;
  };
  SkeletonOverlay skeleton = chain();
  skeleton.parents.pop_back();
  EXPECT_NE(reason(skeleton).find("3 parents"), std::string::npos);
  skeleton = chain();
  skeleton.names.pop_back();
  EXPECT_NE(reason(skeleton).find("3 names"), std::string::npos);
  skeleton = chain();
  skeleton.parents[1] = 9;
  EXPECT_NE(reason(skeleton).find("node 9"), std::string::npos);
  skeleton = chain();
  skeleton.parents[0] = 3;
  EXPECT_NE(reason(skeleton).find("itself"), std::string::npos);
  EXPECT_EQ(picture.rgba, grey().rgba) << "nothing is drawn";
}

TEST(Overlay, NamesNeedAFontAndAreDrawnBesideTheirJoints) {
  OverlayContent content;
  content.skeletons = {chain()};
  const Font font = any_font();
  const Picture without = drawn(content), with = drawn(content, &font);
  const Screen screen(front_view(), width, height);
  for (const int node : {0, 2, 3})
    EXPECT_GT(changed_near(with, without, screen.point(Vec3(content.skeletons[0].global[node][3]))->at, 60.0), 60);
  EXPECT_EQ(with.rgba, drawn(content, &font).rgba);
}

/// A muscle on a limb along x, facing z, in rest space.
std::pair<Muscle, MuscleRegion> biceps() {
  Muscle muscle;
  muscle.name = "biceps_left";
  muscle.sigma = {0.2, 0.1};
  MuscleRegion region;
  region.plane = {{-0.5, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1.0};
  region.centre = {0.1, 0.0, 0.0};
  region.vertices = {{.vertex = 2}, {.vertex = 0}};
  return {muscle, region};
}

TEST(Overlay, APosedMuscleFollowsItsBone) {
  const auto [muscle, region] = biceps();
  // A quarter turn about z, twice the size, two units up.
  Mat4 pose(0.0);
  pose[0] = {0, 2, 0, 0};
  pose[1] = {-2, 0, 0, 0};
  pose[2] = {0, 0, 2, 0};
  pose[3] = {0, 2, 0, 1};
  const std::vector<Vec3> positions{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, normals{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const MuscleOverlay posed = posed_muscle(muscle, region, pose, positions, normals, 0.5);
  EXPECT_EQ(posed.centre, Vec3(0.0, 2.2, 0.0));
  EXPECT_LT(glm::distance(posed.along, Vec3(0.0, 0.4, 0.0)), 1e-12);
  EXPECT_LT(glm::distance(posed.across, Vec3(-0.2, 0.0, 0.0)), 1e-12);
  EXPECT_LT(glm::distance(posed.normal, Vec3(0, 0, 1)), 1e-12);
  EXPECT_EQ(posed.points, (std::vector<Vec3>{{3, 0, 0}, {1, 0, 0}}));
  EXPECT_EQ(posed.normals, (std::vector<Vec3>{{0, 0, 1}, {1, 0, 0}}));
  for (const Vec3& corner : posed.plane) EXPECT_NEAR(corner.z, 0.0, 1e-12);
  const Vec3 middle = 0.25 * (posed.plane[0] + posed.plane[1] + posed.plane[2] + posed.plane[3]);
  EXPECT_LT(glm::distance(middle, Vec3(0.0, 2.0, 0.0)), 1e-12);
}

TEST(Overlay, AMuscleShowsItsPlaneEllipsesCentreAndVertices) {
  const auto [muscle, region] = biceps();
  const std::vector<Vec3> positions{{0.3, 0.35, 0.1}, {0, 0, 0}, {-0.3, -0.35, 0.1}}, normals(3, Vec3(0, 0, 1));
  OverlayContent content;
  content.muscles = {posed_muscle(muscle, region, Mat4(1.0), positions, normals, 1.0)};
  const Picture picture = drawn(content), plain = grey();
  const Screen screen(front_view(), width, height);
  const auto changed = [&](const Vec3& p, double radius) {
    return changed_near(picture, plain, screen.point(p)->at, radius);
  };
  EXPECT_GT(changed({0.1, 0.0, 0.0}, 3.0), 20) << "centre";
  EXPECT_GT(changed({0.3, 0.0, 0.0}, 2.0), 8) << "one sigma along";
  EXPECT_GT(changed({0.1, 0.1, 0.0}, 2.0), 8) << "one sigma across";
  EXPECT_GT(changed({0.3, 0.35, 0.1}, 2.0), 3) << "a vertex";
  EXPECT_GT(changed({-0.4, 0.1, 0.0}, 3.0), 20) << "the plane";
  EXPECT_EQ(changed({0.0, 0.8, 0.0}, 10.0), 0);
  const Vec2 plane = screen.point({-0.4, 0.1, 0.0})->at;
  const std::uint8_t* pixel = &picture.rgba[(std::size_t(plane.y) * width + std::size_t(plane.x)) * 4];
  EXPECT_LT(pixel[0], 0xD8);
  EXPECT_GT(pixel[0], 0xA0) << "translucent";
}

TEST(Overlay, AProjectionShowsTheWayFromTheSkinToThePlane) {
  auto [muscle, region] = biceps();
  region.vertices = {{.vertex = 0, .x = -0.3, .y = 0.2}};
  const std::vector<Vec3> positions{{-0.2, 0.2, 0.6}}, normals{{0, 0, 1}};
  OverlayContent content;
  content.muscles = {posed_muscle(muscle, region, Mat4(1.0), positions, normals, 1.0)};
  ASSERT_EQ(content.muscles[0].feet.size(), 1u);
  EXPECT_LT(glm::distance(content.muscles[0].feet[0], Vec3(-0.2, 0.2, 0.0)), 1e-12);
  content.muscles[0].gaussian = false;
  const auto seen = [&](const Vec3& p) {
    const Screen screen(front_view(), width, height);
    return changed_near(drawn(content), grey(), screen.point(p)->at, 2.0);
  };
  // From the front a foot hides behind its vertex, and the line between them is seen end on.
  EXPECT_EQ(seen({0.3, 0.0, 0.0}), 0) << "neither plane nor ellipse";
  content.muscles[0].projection = true;
  EXPECT_GT(seen({-0.2, 0.2, 0.0}), 3) << "the foot";
  EXPECT_GT(seen({0.1, 0.0, 0.0}), 3) << "the centre";
}

TEST(Overlay, ArrowsReachOutFromTheSkin) {
  auto [muscle, region] = biceps();
  region.vertices = {{.vertex = 0}};
  const std::vector<Vec3> positions{{0.0, 0.3, 0.0}}, normals{{0, 1, 0}};
  OverlayContent content;
  content.muscles = {posed_muscle(muscle, region, Mat4(1.0), positions, normals, 1.0)};
  content.muscles[0].gaussian = false;
  const Screen screen(front_view(), width, height);
  // 0.35 of the mean sigma, 0.15: an arrow from 0.3 to 0.3525.
  const Vec2 tip = screen.point({0.0, 0.3475, 0.0})->at;
  EXPECT_EQ(changed_near(drawn(content), grey(), tip, 1.0), 0);
  content.muscles[0].arrows = true;
  EXPECT_GT(changed_near(drawn(content), grey(), tip, 1.5), 0);
}

TEST(Overlay, HiddenEdgesOfTheBoxAreFainter) {
  OverlayContent content;
  content.box = Bounds{Vec3(-0.5), Vec3(0.5)};
  Bounds all;
  all.add(Vec3(-1.0));
  all.add(Vec3(1.0));
  const Viewpoint view = look_at(Vec3(0.0), 6.0, all, {35.0, 25.0});
  const Picture picture = drawn(content, nullptr, view), plain = grey();
  const Screen screen(view, width, height);
  const auto ink_along = [&](const Vec3& from, const Vec3& to) {
    double ink = 0.0;
    const auto seen = screen.segment(from, to);
    for (int i = 10; i <= 90; ++i) {
      const Vec2 p = glm::mix(seen->first.at, seen->second.at, i / 100.0);
      ink += 0xD8 - picture.rgba[(std::size_t(p.y) * width + std::size_t(p.x)) * 4];
    }
    return ink;
  };
  const double near_edge = ink_along({0.5, -0.5, 0.5}, {0.5, 0.5, 0.5});
  const double hidden_edge = ink_along({-0.5, -0.5, -0.5}, {-0.5, 0.5, -0.5});
  EXPECT_GT(near_edge, 2.5 * hidden_edge);
  EXPECT_GT(hidden_edge, 0.0);
  const Font font = any_font();
  EXPECT_NE(drawn(content, &font, view).rgba, picture.rgba) << "sizes";
}

TEST(Overlay, AxesStandInTheLowerLeftCorner) {
  OverlayContent content;
  content.axes = true;
  const Font font = any_font();
  const Picture picture = drawn(content, &font), plain = grey();
  EXPECT_GT(changed_near(picture, plain, {60.0, 420.0}, 60.0), 200);
  EXPECT_EQ(changed_near(picture, plain, {400.0, 200.0}, 180.0), 0);
  // Seen from the front, x goes to the right in red and y up in green.
  int red = 0, green = 0;
  Vec2 red_sum(0.0), green_sum(0.0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::uint8_t* p = &picture.rgba[(std::size_t(y) * width + x) * 4];
      if (p[0] > p[1] + 80 && p[0] > p[2] + 80) red_sum += Vec2(x, y), ++red;
      if (p[1] > p[0] + 40 && p[1] > p[2] + 40) green_sum += Vec2(x, y), ++green;
    }
  ASSERT_GT(red, 20);
  ASSERT_GT(green, 20);
  EXPECT_GT(red_sum.x / red, green_sum.x / green + 10.0);
  EXPECT_LT(green_sum.y / green, red_sum.y / red - 10.0);
}

TEST(Overlay, LeavesTransparencyWhereNothingIsDrawn) {
  Picture picture{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height)};
  OverlayContent content;
  content.skeletons = {chain()};
  ASSERT_TRUE(draw_overlay(picture, nullptr, front_view(), content));
  EXPECT_EQ(picture.rgba[(20 * width + 20) * 4 + 3], 0);
  const Vec2 joint = Screen(front_view(), width, height).point({0.1, 0.2, 0.3})->at;
  EXPECT_GT(picture.rgba[(std::size_t(joint.y) * width + std::size_t(joint.x)) * 4 + 3], 150);
  Picture empty;
  EXPECT_TRUE(draw_overlay(empty, nullptr, front_view(), content));
}

}  // namespace
}  // namespace sinew
