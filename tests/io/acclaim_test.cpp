#include "engine/io/acclaim.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/core/euler.h"
#include "tests/support/assets.h"
#include "tests/support/motion_samples.h"

namespace sinew::test {
namespace {

Result<Motion> read(const std::string& asf, const std::string& amc) {
  const auto skeleton = parse_asf(bytes_of(asf), "man.asf");
  if (!skeleton) return tl::unexpected<Error>(skeleton.error());
  return parse_amc(bytes_of(amc), "walk.amc", *skeleton);
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(Acclaim, BonesTurnAboutTheirOwnAxes) {
  const auto motion = read(small_asf, small_amc);
  ASSERT_TRUE(motion) << motion.error().message;
  ASSERT_EQ(motion->skeleton.joints.size(), 3u);
  EXPECT_EQ(motion->name, "walk");
  EXPECT_EQ(motion->skeleton.joints[2].name, "tibia");
  // A bone's joint stands at the end of the bone before it.
  EXPECT_EQ(motion->skeleton.joints[1].offset, Vec3(0, 0, 0));
  EXPECT_EQ(motion->skeleton.joints[2].offset, Vec3(0, -2, 0));
  EXPECT_EQ(*motion->skeleton.joints[2].end, Vec3(0, -3, 0));
  EXPECT_DOUBLE_EQ(*motion->skeleton.metres_per_unit, 0.0508);
  EXPECT_EQ(motion->frames[0].root, Vec3(1, 3, 3));
  // The femur's axes are turned by 90 degrees about z: its x is the world's y, about which the bone only twists.
  EXPECT_LT(glm::length(motion->frames[0].rotations[1] * Vec3(1, 0, 0) -
                        axis_rotation(1, 30 * degrees_to_radians) * Vec3(1, 0, 0)),
            1e-12);
  // The tibia's x is the world's: 90 degrees take it from down to back.
  EXPECT_LT(glm::length(motion->frames[0].rotations[2] * Vec3(0, -1, 0) - Vec3(0, 0, -1)), 1e-12);
}

TEST(Acclaim, RadiansAreTakenWhereTheMotionSaysSo) {
  const auto degrees = read(small_asf, small_amc);
  const auto radians =
      read(small_asf, with(with(with(small_amc, ":DEGREES", ":RADIANS"), "30 0 0", "0.5235987755982988 0 0"),
                           "tibia 90", "tibia 1.5707963267948966"));
  ASSERT_TRUE(degrees && radians);
  for (std::size_t j = 0; j < 3; ++j)
    EXPECT_NEAR(std::abs(glm::dot(degrees->frames[0].rotations[j], radians->frames[0].rotations[j])), 1.0, 1e-12);
}

TEST(Acclaim, ABoneThatMissesKeepsItsValue) {
  const auto motion = read(small_asf, with(small_amc, "femur 0 0 0\n", ""));
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->frames[1].rotations[1], motion->frames[0].rotations[1]);
  EXPECT_NE(motion->problems[0].find("femur"), std::string::npos) << motion->problems[0];
}

TEST(Acclaim, ErrorsNamePlaceAndCure) {
  const auto expect = [](const std::string& asf, const std::string& amc, const std::string& part) {
    const auto motion = read(asf, amc);
    ASSERT_FALSE(motion) << part;
    EXPECT_EQ(motion.error().kind, ErrorKind::bad_input);
    EXPECT_NE(motion.error().message.find(part), std::string::npos) << motion.error().message << "\nexpected " << part;
  };
  expect(small_asf, with(small_amc, "tibia 90", "tibbia 90"),
         "walk.amc:7:1: the skeleton has no bone \"tibbia\" (did you mean \"tibia\"?)");
  expect(small_asf, with(small_amc, "tibia 90", "tibia"), "walk.amc:8:1: the line of \"tibia\" ends early");
  expect(small_asf, with(small_amc, "tibia 90", "tibia 90 1"), "walk.amc:7:10: expected the end of the line");
  expect(small_asf, with(small_amc, "tibia 90", "tibia inf"), "walk.amc:7:7: expected a number");
  expect(small_asf, with(small_amc, "\n1\n", "\n"), "before the number of the first frame");
  expect(small_asf, ":DEGREES\n", "expected the number of a frame");
  expect(with(small_asf, "femur tibia\n", "femur tibias\n"), small_amc, "no bone \"tibias\"");
  expect(with(small_asf, "root femur\n", "tibia femur\n"), small_amc, "runs in a circle");
  expect(with(small_asf, "femur tibia\n", "\n"), small_amc, "the hierarchy does not name it");
  expect(with(small_asf, "femur tibia\n", "femur tibia\n tibia femur\n"), small_amc, "has a parent already");
  expect(with(small_asf, "name tibia", "name femur"), small_amc, "a second bone \"femur\"");
  expect(with(small_asf, "dof rx\n", "dof rq\n"), small_amc, "expected a degree of freedom");
  expect(with(small_asf, "axis 0 0 90 XYZ", "axis 0 0 90 XXZ"), small_amc, "an order of axes such as XYZ");
  expect(small_asf.substr(0, 300), small_amc, "man.asf:");
  expect("", small_amc, "has no bones");
  expect(std::string("\x01\x02", 2), small_amc, "which is text");
}

TEST(Acclaim, DeepAndCountlessBonesAreRefused) {
  std::string asf = ":bonedata\n", hierarchy = ":hierarchy\nbegin\nroot b0\n";
  for (int i = 0; i < 4000; ++i) {
    asf += fmt::format("begin\nname b{}\ndirection 0 1 0\nlength 1\naxis 0 0 0 XYZ\nend\n", i);
    if (i > 0) hierarchy += fmt::format("b{} b{}\n", i - 1, i);
  }
  const auto deep = parse_asf(bytes_of(asf + hierarchy + "end\n"), "man.asf");
  ASSERT_FALSE(deep);
  EXPECT_NE(deep.error().message.find("hang from one another"), std::string::npos) << deep.error().message;
}

/// CMU's own capture and its conversion to BVH by others are of different clips; what they share is the body's plan.
TEST(Acclaim, TheCmuSkeletonStandsOnItsFeet) {
  SINEW_ASSETS_OR_SKIP(folder);
  const auto file = folder / "motions/cmu_asfamc/02_01.amc";
  const auto bytes = read_file(file);
  ASSERT_TRUE(bytes);
  const auto asf = find_asf(*bytes, file);
  ASSERT_TRUE(asf) << asf.error().message;
  EXPECT_EQ(asf->filename(), "02.asf");
  const auto asf_bytes = read_file(*asf);
  const auto skeleton = parse_asf(*asf_bytes, *asf);
  ASSERT_TRUE(skeleton) << skeleton.error().message;
  const auto motion = parse_amc(*bytes, file, *skeleton);
  ASSERT_TRUE(motion) << motion.error().message;
  EXPECT_EQ(motion->skeleton.joints.size(), 31u);
  EXPECT_EQ(motion->frames.size(), 343u);
  // Every joint's place at a frame: feet near the floor, the head a man's height over it.
  for (const std::size_t f : {std::size_t{0}, std::size_t{170}, std::size_t{342}}) {
    std::vector<Quat> rotations;
    std::vector<Vec3> places;
    double lowest = INFINITY, highest = -INFINITY;
    for (std::size_t j = 0; j < motion->skeleton.joints.size(); ++j) {
      const MotionJoint& joint = motion->skeleton.joints[j];
      const Quat above = joint.parent < 0 ? Quat(1, 0, 0, 0) : rotations[joint.parent];
      places.push_back(joint.parent < 0 ? motion->frames[f].root : places[joint.parent] + above * joint.offset);
      rotations.push_back(above * motion->frames[f].rotations[j]);
      const double y = places.back().y * *skeleton->skeleton.metres_per_unit;
      lowest = std::min(lowest, y);
      highest = std::max(highest, y);
    }
    EXPECT_NEAR(lowest, 0.0, 0.08);
    EXPECT_NEAR(highest, 1.6, 0.2);
  }
}

TEST(Acclaim, DamagedFilesEndWithAReason) {
  std::mt19937 random(2);
  const auto any = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::string words[] = {"begin",   "end",    ":root", ":hierarchy", "dof rx", "name femur", "nan",
                               "(",       "-1e308", "\n",    ":bonedata",  "root",   "3",          std::string(1, '\0'),
                               "\xff\xfe"};
  const auto damage = [&](std::string text) {
    for (std::size_t k = 0; k <= any(3); ++k) {
      const std::size_t at = any(text.size());
      if (any(3) == 0) text.resize(at + 1);
      if (any(2) == 0) text.insert(std::min(at, text.size()), words[any(std::size(words))]);
      if (any(2) == 0) text.erase(std::min(at, text.size() - 1), any(12) + 1);
      if (text.empty()) text = " ";
    }
    return text;
  };
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto motion = i % 2 == 0 ? read(damage(small_asf), small_amc) : read(small_asf, damage(small_amc));
    if (motion) continue;
    EXPECT_EQ(motion.error().kind, ErrorKind::bad_input);
    ++refused;
  }
  EXPECT_GT(refused, 800);
}

}  // namespace
}  // namespace sinew::test
