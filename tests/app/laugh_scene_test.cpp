/// scenes/laugh.json: neck, shoulders and face laugh together.

#include <unistd.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/app/stage.h"
#include "engine/motion/library_import.h"
#include "engine/motion/motion_edit.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

class LaughScene : public testing::Test {
 protected:
  LaughScene() : folder_(fs::temp_directory_path() / fmt::format("sinew-laugh-{}", ::getpid())) {
    fs::create_directories(folder_);
    import();
    SceneOptions options;
    options.scene = (scenes() / "laugh.json").string();
    options.library = file();
    auto stage = open_stage(options);
    EXPECT_TRUE(stage) << stage.error().message;
    if (stage) stage_ = std::move(*stage);
  }
  ~LaughScene() override { fs::remove_all(folder_); }

  static fs::path scenes() { return fs::path(SINEW_SOURCE_DIR) / "scenes"; }
  fs::path file() const { return folder_ / "laugh.db"; }

  /// As scenes/README.md has it: the neck by the paper's three segments of degree 5.
  void import() const {
    auto library = MotionLibrary::open(file(), true);
    ASSERT_TRUE(library) << library.error().message;
    ImportOptions options;
    options.emotion = "laugh";
    options.progress = ProgressStyle::none;
    const auto report = import_motions(*library, {scenes() / "laugh.bvh"}, options);
    ASSERT_TRUE(report) << report.error().message;
    const auto clip = library->load("laugh");
    ASSERT_TRUE(clip) << clip.error().message;
    CurveFitOptions fit;
    fit.degree = 5;
    fit.segments = 3;
    const std::size_t joints = clip->motion.skeleton.joints.size();
    const auto neck = find_motion_joint(clip->motion.skeleton, "neck");
    ASSERT_TRUE(neck);
    KeptCurves others{fit_motion(clip->motion, {}).clip, std::vector<bool>(joints, true)};
    others.joints[static_cast<std::size_t>(*neck)] = false;
    const MotionFit found = fit_motion(clip->motion, fit, &others);
    EXPECT_EQ(found.clip.joints[static_cast<std::size_t>(*neck)].angles[0].segments(), 3u);
    ASSERT_TRUE(library->set_curves("laugh", found.clip));
  }

  CharacterState state(int frame) const { return character_state(*stage_, 0, frame); }
  /// A joint's turn in the world, [frames].
  Quat turn(const CharacterState& state, const std::string& joint) const {
    const StagedCharacter& character = stage_->characters[0];
    const auto node = find_joint(*character.model, character.humanoid, joint);
    EXPECT_TRUE(node) << joint;
    return glm::normalize(glm::quat_cast(Mat3(state.global[static_cast<std::size_t>(*node)])));
  }

  std::optional<Stage> stage_;

 private:
  fs::path folder_;
};

int frame_of_largest(const std::vector<double>& row) {
  return static_cast<int>(std::max_element(row.begin(), row.end()) - row.begin());
}

TEST_F(LaughScene, NeckAndFaceHaveTheirApexOnOneFrame) {
  ASSERT_TRUE(stage_);
  const int apex = static_cast<int>(stage_->scene.characters[0].emotion.front().frame);
  std::vector<double> head, jaw, corner;
  const Quat rest = turn(state(0), "head");
  for (int frame = 0; frame <= stage_->range.last; ++frame) {
    const CharacterState now = state(frame);
    const Quat between = turn(now, "head") * glm::conjugate(rest);
    head.push_back(2.0 * std::acos(std::min(std::abs(between.w), 1.0)) * radians_to_degrees);
    ASSERT_TRUE(now.face);
    jaw.push_back(now.face->jaw_angle);
  }
  EXPECT_EQ(frame_of_largest(head), apex);
  EXPECT_EQ(frame_of_largest(jaw), apex);
  // The head is thrown back, and the mouth is open, not just somewhat less closed.
  EXPECT_GT(head[static_cast<std::size_t>(apex)], 15.0);
  EXPECT_GT(jaw[static_cast<std::size_t>(apex)], 10.0 * degrees_to_radians);
  const Vec3 up = turn(state(apex), "head") * glm::conjugate(rest) * Vec3(0, 1, 0);
  EXPECT_LT(up.z, -0.25);
}

TEST_F(LaughScene, TheShouldersShake) {
  ASSERT_TRUE(stage_);
  std::vector<double> height;
  for (int frame = 0; frame <= stage_->range.last; ++frame) {
    const CharacterState now = state(frame);
    const Mat4& arm = now.global[static_cast<std::size_t>(
        *find_joint(*stage_->characters[0].model, stage_->characters[0].humanoid, "leftUpperArm"))];
    height.push_back(arm[3].y);
  }
  int turns = 0;
  for (std::size_t i = 2; i < height.size(); ++i)
    turns += (height[i] - height[i - 1]) * (height[i - 1] - height[i - 2]) < -1e-8 ? 1 : 0;
  EXPECT_GE(turns, 6) << "fewer than three shakes";
}

}  // namespace
}  // namespace sinew::test
