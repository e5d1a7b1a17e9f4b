#include "engine/face/head_measures.h"

#include <gtest/gtest.h>

#include "engine/face/head.h"
#include "engine/face/head_loft.h"

namespace sinew::test {
namespace {

TEST(HeadMeasures, AgesMeetTheirStopsAndLieBetweenThem) {
  EXPECT_DOUBLE_EQ(parse_age("child").value(), 0.75);
  EXPECT_DOUBLE_EQ(parse_age("0.75").value(), 0.75);
  const HeadMeasures child = measures_of_age(0.75), infant = measures_of_age(1.0), between = measures_of_age(0.875);
  for (const HeadMeasureField& field : head_measure_fields())
    EXPECT_NEAR(between.*field.member, 0.5 * (child.*field.member + infant.*field.member), 1e-12) << field.name;
}

TEST(HeadMeasures, EveryAgeWithEveryMixOfSkullsIsAHead) {
  // All that may be typed lies between these: the measures are linear between stops of age and in every weight.
  const HeadMaker maker(0);
  for (int age = 0; age <= 16; ++age)
    for (int mix = 0; mix < 81; ++mix) {
      SkullWeights skull;
      int rest = mix;
      for (const std::string& name : skull_names()) {
        skull[name] = 0.5 * (rest % 3);
        rest /= 3;
      }
      HeadMeasures m = measures_of_age(age / 16.0);
      apply_skull(skull, m);
      const auto ok = check_measures(m);
      ASSERT_TRUE(ok) << age << " " << mix << ": " << ok.error().message;
      if (age % 16 != 0 || mix % 8 != 0) continue;  // to draw a head takes longer
      const auto head = maker.head(m);
      ASSERT_TRUE(head) << age << " " << mix << ": " << head.error().message;
    }
}

TEST(HeadMeasures, WordsThatAreWrongAreNamed) {
  EXPECT_EQ(parse_age("adlut").error().kind, ErrorKind::usage);
  EXPECT_NE(parse_age("adlut").error().message.find("adult"), std::string::npos);
  EXPECT_EQ(parse_age("1.5").error().kind, ErrorKind::usage);
  EXPECT_EQ(parse_skull("rond").error().kind, ErrorKind::usage);
  EXPECT_EQ(parse_skull("round=2").error().kind, ErrorKind::usage);
  HeadMeasures m = measures_of_age(0.0);
  EXPECT_EQ(apply_measure("brow_height", m).error().kind, ErrorKind::usage);
  const Error unknown = apply_measure("brow_hight=2", m).error();
  EXPECT_EQ(unknown.kind, ErrorKind::bad_input);
  EXPECT_NE(unknown.message.find("brow_height"), std::string::npos);
  EXPECT_EQ(apply_measure("brow_height=9", m).error().kind, ErrorKind::bad_input);
}

TEST(HeadMeasures, MeasuresThatCrossAreRefused) {
  HeadMeasures m = measures_of_age(0.0);
  ASSERT_TRUE(apply_measure("eye_height=2.2", m));
  const Error crossed = check_measures(m).error();
  EXPECT_EQ(crossed.kind, ErrorKind::bad_input);
  EXPECT_NE(crossed.message.find("eye_height"), std::string::npos);
  EXPECT_NE(crossed.message.find("brow_height"), std::string::npos);
}

TEST(HeadMeasures, AFileGivesTheSameMeasuresBack) {
  HeadMeasures m = measures_of_age(0.6);
  apply_skull(parse_skull("narrow=0.7").value(), m);
  const HeadMeasures back = parse_measures(measures_text(m), "head.json").value();
  for (const HeadMeasureField& field : head_measure_fields()) EXPECT_EQ(back.*field.member, m.*field.member);
  EXPECT_EQ(parse_measures(R"({"sinew_head": 1, "measures": {"nose_widht": 0.3}})", "h").error().kind,
            ErrorKind::bad_input);
  EXPECT_EQ(parse_measures(R"({"measures": {}})", "h").error().kind, ErrorKind::bad_input);
}

TEST(HeadLoft, InversesReturnWhatTheSurfaceWasAskedFor) {
  const HeadLoft loft(measures_of_age(0.0));
  for (const double y : {0.5, 1.2, 2.2, 2.9})
    for (const double theta : {20.0, 45.0, 70.0}) {
      const Vec3 p = loft.at(theta, y);
      EXPECT_NEAR(loft.depth(p.x, y), p.z, 1e-6);
      EXPECT_NEAR(loft.theta_of_depth(p.z, y), theta, 1e-6);
    }
  const Vec3 crown = loft.at(60.0, 3.2);
  EXPECT_NEAR(loft.height_of(60.0, std::hypot(crown.x, crown.z), 2.7), 3.2, 1e-6);
}

TEST(HeadLoft, MidFaceIsAsDeepAsWhatWasMeasured) {
  // Loomis' square from the side: 3.5 with the nose; the bare skull is measured as 3.1 to 3.2 (glabella to occiput)
  // and smoothed, which takes the occiput's tip.
  const HeadLoft loft(measures_of_age(0.0));
  EXPECT_NEAR(loft.at(0.0, 2.05).z - loft.at(180.0, 2.2).z, 3.15, 0.15);
}

}  // namespace
}  // namespace sinew::test
