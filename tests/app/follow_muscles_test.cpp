/// A picture whose muscles have changed, against one that is made anew.

#include "engine/app/frame.h"
#include "tests/gpu/device_fixture.h"

namespace sinew::test {
namespace {

class FollowMuscles : public DeviceTest {};

TEST_F(FollowMuscles, GivesThePictureOfAMakerMadeAnew) {
  SceneOptions options;
  options.scene = "builtin:woman";
  auto stage = open_stage(options);
  ASSERT_TRUE(stage) << stage.error().message;
  auto scene = spelled_out_scene(*stage);
  ASSERT_TRUE(scene);
  scene->characters[0].keys["leftLowerArm"] = Keyed<Vec3>::constant({0, -110, 0});
  ASSERT_TRUE(restage(*stage, *scene, options));
  LookOptions look;
  look.size = {320, 240};
  std::vector<std::string> problems;
  auto maker = FrameMaker::create(device(), *stage, options, look, problems);
  ASSERT_TRUE(maker);
  auto before = maker->picture(0);
  ASSERT_TRUE(before);
  const auto change = [&](const char* what, auto set) {
    SCOPED_TRACE(what);
    set(scene->characters[0].muscles[0]);
    ASSERT_TRUE(restage_muscles(*stage, *scene, options));
    ASSERT_TRUE(maker->follow_muscles());
    const auto after = maker->picture(0);
    ASSERT_TRUE(after);
    EXPECT_NE(after->rgba, before->rgba) << "the change is seen";
    auto anew = FrameMaker::create(device(), *stage, options, look, problems);
    ASSERT_TRUE(anew);
    EXPECT_EQ(after->rgba, anew->picture(0)->rgba);
    before = after;
  };
  change("peak", [](MuscleSpec& muscle) { muscle.peak = 2.0 * *muscle.peak; });
  change("region", [](MuscleSpec& muscle) { muscle.from = *muscle.from - 0.2, muscle.spread = 120.0; });
  change("off", [](MuscleSpec& muscle) { muscle.on = false; });
}

}  // namespace
}  // namespace sinew::test
