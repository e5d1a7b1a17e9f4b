#include "engine/core/frame_range.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

using Frames = std::vector<int>;

TEST(FrameRange, ReadsFramesRangesAndSteps) {
  EXPECT_EQ(parse_frame_range("7").value(), (Frames{7}));
  EXPECT_EQ(parse_frame_range("0-3").value(), (Frames{0, 1, 2, 3}));
  EXPECT_EQ(parse_frame_range("0-12:5").value(), (Frames{0, 5, 10}));
  EXPECT_EQ(parse_frame_range("1,3,7-9").value(), (Frames{1, 3, 7, 8, 9}));
  EXPECT_EQ(parse_frame_range("4-4").value(), (Frames{4}));
  EXPECT_EQ(parse_frame_range("0-47")->size(), 48u);
  EXPECT_EQ(parse_frame_range(" 1 , 2-3 ").value(), (Frames{1, 2, 3}));
}

TEST(FrameRange, KeepsTheOrderWrittenAndDropsRepeats) {
  EXPECT_EQ(parse_frame_range("9,1,9,0-2").value(), (Frames{9, 1, 0, 2}));
}

TEST(FrameRange, ReachesItsLimits) {
  EXPECT_EQ(parse_frame_range("10000000").value(), (Frames{10'000'000}));
  EXPECT_EQ(parse_frame_range("0-10000000:10000000").value(), (Frames{0, 10'000'000}));
  EXPECT_EQ(parse_frame_range("0-999999,5")->size(), most_frames);
}

TEST(FrameRange, NamesThePartThatIsWrong) {
  struct Case {
    std::string text, part, hint;
  };
  for (const Case& bad : std::vector<Case>{{"", "\"\"", "such as 7"},
                                           {"1,,2", "\"\"", "such as 7"},
                                           {"1,x", "\"x\"", "a frame, an integer"},
                                           {"-5", "\"-5\"", "found \"\""},
                                           {"3-", "\"3-\"", "last frame"},
                                           {"1-2-3", "\"1-2-3\"", "found \"2-3\""},
                                           {"1.5", "\"1.5\"", "integer"},
                                           {"+1", "\"+1\"", "integer"},
                                           {"9-3", "\"9-3\"", "3-9"},
                                           {"0-9:0", "\"0-9:0\"", "from 1"},
                                           {"0-9:-1", "\"0-9:-1\"", "step"},
                                           {"5:2", "\"5:2\"", "a range before it"},
                                           {"10000001", "\"10000001\"", "10000000"},
                                           {"99999999999999999999", "\"99999999999999999999\"", "10000000"},
                                           {"0-1000000", "\"0-1000000\"", "at most 1000000 frames"}}) {
    const auto frames = parse_frame_range(bad.text);
    ASSERT_FALSE(frames) << bad.text;
    EXPECT_EQ(frames.error().kind, ErrorKind::usage) << bad.text;
    EXPECT_NE(frames.error().message.find("frames " + bad.part + ":"), std::string::npos) << frames.error().message;
    EXPECT_NE(frames.error().message.find(bad.hint), std::string::npos) << frames.error().message;
  }
}

TEST(FrameFileName, ReplacesTheLastRunOfTheFilesOwnName) {
  EXPECT_EQ(frame_file_name("out/x_####.png", 7), "out/x_0007.png");
  EXPECT_EQ(frame_file_name("x_##.png", 12345), "x_12345.png");
  EXPECT_EQ(frame_file_name("##_a_###.obj", 0), "##_a_000.obj");
  EXPECT_EQ(frame_file_name("####", 3), "0003");
  EXPECT_EQ(frame_file_name("take##2/x.png", 3), "take##2/x.png");
  EXPECT_EQ(frame_file_name("{}_##.png", 3), "{}_03.png");
}

TEST(FrameFileName, ASingleSignIsALetter) {
  EXPECT_EQ(frame_file_name("take #3.png", 7), "take #3.png");
  EXPECT_EQ(frame_file_name("x_###_#3.png", 7), "x_007_#3.png");
  EXPECT_EQ(frame_file_name("#.png", 7), "#.png");
}

TEST(FrameFileName, KnowsWhetherThereIsAPattern) {
  EXPECT_TRUE(has_frame_pattern("x_####.png"));
  EXPECT_TRUE(has_frame_pattern("##"));
  EXPECT_FALSE(has_frame_pattern("x_#.png"));
  EXPECT_FALSE(has_frame_pattern("#"));
  EXPECT_FALSE(has_frame_pattern("x.png"));
  EXPECT_FALSE(has_frame_pattern("####/x.png"));
  EXPECT_FALSE(has_frame_pattern(""));
}

TEST(FrameFileName, IsKnownAgain) {
  for (const int frame : {0, 7, 9999, 12345, last_possible_frame})
    EXPECT_TRUE(is_frame_file_name("x_####.png", frame_file_name("x_####.png", frame))) << frame;
  for (const char* other : {"x_007.png", "x_00007.png", "x_0007.jpg", "y_0007.png", "x_-007.png", "x_+007.png",
                            "x_.png", "x_0a07.png", "x_####.png", "x_99999999.png", ""})
    EXPECT_FALSE(is_frame_file_name("x_####.png", other)) << other;
  EXPECT_TRUE(is_frame_file_name("x.png", "x.png"));
  EXPECT_FALSE(is_frame_file_name("x.png", "y.png"));
}

}  // namespace
}  // namespace sinew
