#include "engine/view/orbit_camera.h"

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

Bounds box() {
  Bounds bounds;
  bounds.add({-1, 0, -0.5});
  bounds.add({1, 2, 0.5});
  return bounds;
}

Viewpoint seen(const OrbitCamera& camera) {
  return look_at(camera.target, camera.distance, box(), camera.direction, camera.rays);
}

/// Where a point is seen, -1 to 1.
Vec2 on_screen(const OrbitCamera& camera, const Vec3& p) {
  const Vec4 clip = seen(camera).view_projection(1.0) * Vec4(p, 1.0);
  return Vec2(clip) / clip.w;
}

TEST(OrbitCamera, FramesAsRenderDoes) {
  for (const Rays rays : {Rays::from_eye, Rays::parallel}) {
    OrbitCamera camera;
    camera.direction = {40.0, 15.0};
    camera.rays = rays;
    camera.frame(box(), 1.5);
    EXPECT_LT(glm::distance(seen(camera).eye, frame_box(box(), camera.direction, 1.5, rays).eye), 1e-12);
  }
}

TEST(OrbitCamera, FramesABallUpright) {
  const Vec3 centre(0.2, 1.4, 0.1);
  for (const double aspect : {1.5, 0.5}) {
    OrbitCamera camera;
    camera.frame(centre, 0.3, aspect);
    const Viewpoint view = seen(camera);
    EXPECT_LT(glm::distance(on_screen(camera, centre), Vec2(0.0)), 1e-12);
    // Upwards it reaches the picture's edge; in a narrow picture it reaches the sides'.
    const double edge = on_screen(camera, centre + 0.3 * view.up).y;
    EXPECT_NEAR(edge, -std::min(aspect, 1.0), 1e-9) << "+y is downwards";
  }
}

TEST(OrbitCamera, OrbitsRoundItsTarget) {
  OrbitCamera camera;
  camera.target = {0, 1, 0};
  camera.distance = 4.0;
  camera.orbit(0.3, 0.1);
  EXPECT_NEAR(glm::distance(seen(camera).eye, camera.target), 4.0, 1e-12);
  EXPECT_LT(glm::length(on_screen(camera, camera.target)), 1e-12);
  EXPECT_LT(seen(camera).eye.x, 0.0) << "dragged to the right, the scene turns to the right";
  EXPECT_GT(seen(camera).eye.y, 1.0) << "dragged down, its top comes forward";
  camera.orbit(0.0, 99.0);
  EXPECT_DOUBLE_EQ(camera.direction.elevation, 90.0) << "not over the top";
}

TEST(OrbitCamera, PanKeepsThePointUnderThePointer) {
  OrbitCamera camera;
  camera.direction = {25.0, -10.0};
  camera.target = {0.2, 1.0, 0.1};
  camera.distance = 3.0;
  const Vec3 point = camera.target;
  camera.pan(0.25, -0.1);  // shares of the height: half the picture is 0.5
  const Vec2 at = on_screen(camera, point);
  EXPECT_NEAR(at.x, 0.5, 1e-12);
  EXPECT_NEAR(at.y, -0.2, 1e-12);
}

TEST(OrbitCamera, ParallelRaysKeepTheTargetsSizeAndWhatIsUnderThePointer) {
  OrbitCamera camera;
  camera.direction = {25.0, -10.0};
  camera.target = {0.2, 1.0, 0.1};
  camera.distance = 3.0;
  const Vec3 beside = camera.target + 0.3 * seen(camera).up;  // as far away as the target
  const Vec2 in_perspective = on_screen(camera, beside);
  camera.rays = Rays::parallel;
  EXPECT_LT(glm::distance(on_screen(camera, beside), in_perspective), 1e-12);
  const Vec3 point = camera.target;
  camera.pan(0.25, -0.1);
  EXPECT_NEAR(on_screen(camera, point).x, 0.5, 1e-12);
  EXPECT_EQ(camera.camera().projection, Projection::orthographic);
}

TEST(OrbitCamera, ZoomsBySteps) {
  OrbitCamera camera;
  camera.distance = 10.0;
  camera.zoom(1);
  EXPECT_DOUBLE_EQ(camera.distance, 9.0);
  camera.zoom(-1);
  EXPECT_NEAR(camera.distance, 10.0, 1e-12);
  camera.zoom(1e6);
  EXPECT_GT(camera.distance, 0.0);
}

TEST(OrbitCamera, IsTheScenesCameraAgain) {
  OrbitCamera camera;
  camera.direction = {200.0, -33.0};
  camera.target = {1, 2, 3};
  camera.distance = 5.0;
  const Camera scene = camera.camera();
  EXPECT_EQ(scene.view, View::front);
  EXPECT_EQ(scene.projection, Projection::perspective);
  EXPECT_EQ(scene.orbit.value_at(0), 200.0);
  EXPECT_EQ(scene.elevation, -33.0);
  EXPECT_EQ(scene.target->value_at(7), Vec3(1, 2, 3));
  EXPECT_EQ(scene.distance->value_at(7), 5.0);
}

}  // namespace
}  // namespace sinew::test
