#include "engine/io/bvh.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "engine/core/euler.h"
#include "tests/support/assets.h"
#include "tests/support/motion_samples.h"

namespace sinew::test {
namespace {

Motion parsed(const std::string& text) {
  auto motion = parse_bvh(bytes_of(text), "walk.bvh");
  EXPECT_TRUE(motion) << (motion ? "" : motion.error().message);
  return motion ? std::move(*motion) : Motion{};
}

std::string reason(const std::string& text) {
  const auto motion = parse_bvh(bytes_of(text), "walk.bvh");
  if (motion) return "it was read";
  EXPECT_EQ(motion.error().kind, ErrorKind::bad_input);
  return motion.error().message;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

double distance(const Quat& a, const Quat& b) { return 2.0 * std::acos(std::min(std::abs(glm::dot(a, b)), 1.0)); }

void expect_same(const Motion& a, const Motion& b, double angle, double length) {
  ASSERT_EQ(a.skeleton.joints.size(), b.skeleton.joints.size());
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (std::size_t j = 0; j < a.skeleton.joints.size(); ++j) {
    EXPECT_EQ(a.skeleton.joints[j].name, b.skeleton.joints[j].name);
    EXPECT_EQ(a.skeleton.joints[j].parent, b.skeleton.joints[j].parent);
    EXPECT_EQ(a.skeleton.joints[j].channels, b.skeleton.joints[j].channels);
    EXPECT_LE(glm::length(a.skeleton.joints[j].offset - b.skeleton.joints[j].offset), length);
  }
  for (std::size_t f = 0; f < a.frames.size(); ++f) {
    EXPECT_LE(glm::length(a.frames[f].root - b.frames[f].root), length);
    for (std::size_t j = 0; j < a.skeleton.joints.size(); ++j)
      EXPECT_LE(distance(a.frames[f].rotations[j], b.frames[f].rotations[j]), angle) << f << " " << j;
  }
}

TEST(Bvh, ChannelsTurnInTheirOwnOrder) {
  const Motion motion = parsed(small_bvh);
  ASSERT_EQ(motion.skeleton.joints.size(), 2u);
  EXPECT_EQ(motion.name, "walk");
  EXPECT_EQ(motion.skeleton.joints[1].parent, 0);
  EXPECT_EQ(*motion.skeleton.joints[1].end, Vec3(0, 2, 0));
  EXPECT_EQ(motion.frame_time, 0.04);
  EXPECT_EQ(motion.frames[1].root, Vec3(1, 2, 4));
  EXPECT_EQ(rotation_order(motion.skeleton.joints[1]), (std::vector<int>{1, 2, 0}));
  EXPECT_LT(distance(motion.frames[1].rotations[1], from_euler(Vec3(40, 50, 60) * degrees_to_radians, {1, 2, 0})),
            1e-7);
  // 90 degrees about z takes the spine from +y to -x.
  EXPECT_LT(glm::length(motion.frames[0].rotations[0] * Vec3(0, 1, 0) - Vec3(-1, 0, 0)), 1e-12);
  EXPECT_TRUE(motion.problems.empty());
}

TEST(Bvh, OddSpellingIsRead) {
  std::string text = small_bvh;
  text = with(text, "Frames: 2", "frames :2");
  text = with(text, "Frame Time: 0.04", "Frame Time:\t4e-2");
  text = with(text, "JOINT Spine\n  {", "joint  Spine {");
  text = with(text, "OFFSET 0 1 0", "OFFSET\t+0.0 1.0E+0\n  -0");
  text = with(text, "1 2 4 10", "\n  1.0e0\t2  4 10");
  std::string crlf;
  for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_same(parsed(small_bvh), parsed(crlf), 0.0 + 1e-7, 0.0);
}

TEST(Bvh, RowsBrokenOverLinesAreRead) {
  std::string text = with(small_bvh, "1 2 3 90 0", "1 2 3\n90 0");
  text = with(text, "1 2 4 10 20", "1 2 4\n10 20");
  expect_same(parsed(small_bvh), parsed(text), 1e-7, 0.0);
}

TEST(Bvh, RowsAreRightWhereTheCountIsNot) {
  for (const char* count : {"Frames: 1", "Frames: 7", "Frames: 0"}) {
    const Motion motion = parsed(with(small_bvh, "Frames: 2", count));
    EXPECT_EQ(motion.frames.size(), 2u);
    ASSERT_EQ(motion.problems.size(), 1u);
    EXPECT_NE(motion.problems[0].find("2 rows"), std::string::npos) << motion.problems[0];
  }
}

TEST(Bvh, PositionsBelowTheRootStandForTheOffsetOrAreAddedToIt) {
  const std::string six = with(small_bvh, "CHANNELS 3 Yrotation Zrotation Xrotation",
                               "CHANNELS 6 Xposition Yposition Zposition Yrotation Zrotation Xrotation");
  std::string places = with(with(six, "90 0 0 0 0 0", "90 0 0 0 1.5 0 0 0 0"), "40 50 60", "0 1 0 40 50 60");
  Motion motion = parsed(places);
  EXPECT_EQ(motion.frames[0].offsets.at(1), Vec3(0, 1.5, 0));
  EXPECT_TRUE(motion.problems.empty());
  places = with(with(six, "90 0 0 0 0 0", "90 0 0 0 0.5 0 0 0 0"), "40 50 60", "0 0 0 40 50 60");
  motion = parsed(places);
  EXPECT_EQ(motion.frames[0].offsets.at(1), Vec3(0, 1.5, 0));
  EXPECT_EQ(motion.problems.size(), 1u);
}

TEST(Bvh, ErrorsNamePlaceAndCure) {
  const auto expect = [](const std::string& text, const std::string& part) {
    const std::string message = reason(text);
    EXPECT_NE(message.find(part), std::string::npos) << message << "\nexpected: " << part;
  };
  expect("", "walk.bvh:1:1: expected \"HIERARCHY\"");
  expect(with(small_bvh, "OFFSET 0 1 0", "OFFSET 0 nan 0"), "walk.bvh:8:14: expected a number");
  expect(with(small_bvh, "1 2 3 90", "1 2 3 nan"), "walk.bvh:19:7: expected a finite number, found \"nan\"");
  expect(with(small_bvh, "1 2 3 90", "1 2 3 1e999"), "walk.bvh:19:7: expected a finite number");
  expect(with(small_bvh, "Zrotation", "Wrotation"), "expected a channel such as Xposition");
  expect(with(small_bvh, "Zrotation", "Xrotation"), "twice");
  expect(with(small_bvh, "CHANNELS 6", "CHANNELS 7"), "channels from 0 to 6");
  expect(with(small_bvh, "Frame Time: 0.04", "Frame Time: 0"), "walk.bvh:18:13: a frame time of 0 seconds");
  expect(with(small_bvh, "Frame Time: 0.04", "Frame Time: -1"), "a frame time of -1 seconds");
  expect(with(small_bvh, "Frame Time: 0.04", "Frame Time: 1e9"), "expected 1e-05 to 60");
  expect(with(small_bvh, "1 2 4 10 20", "1 2 4 20"), "the row of frame 1 has 8 numbers, expected 9");
  expect(with(small_bvh, "40 50 60", "40 50 60 70"), "walk.bvh:20:25: the row of frame 1 goes on");
  expect(small_bvh.substr(0, 60), "the end of the file: it is cut off");
  expect(small_bvh.substr(0, small_bvh.find("MOTION")), "expected MOTION");
  expect(small_bvh.substr(0, small_bvh.find("1 2 3 90")), "expected rows of 9 numbers");
  expect(with(small_bvh, "MOTION", "ROOT b"), "a second ROOT");
  expect(with(small_bvh, "    OFFSET 0 1 0\n", ""), "has no OFFSET");
  expect(std::string("\x7f"
                     "ELF\x02\x01",
                     6),
         "walk.bvh:1:5: expected a BVH file, which is text; found the byte 0x02");
}

TEST(Bvh, HierarchiesThatNoBodyHasAreRefusedAtOnce) {
  std::string deep = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n", wide = deep;
  for (int i = 0; i < 10000; ++i) deep += "JOINT b\n{\nOFFSET 0 1 0\n";
  for (int i = 0; i < 100000; ++i) wide += "JOINT b\n{\nOFFSET 0 1 0\n}\n";
  const auto start = std::chrono::steady_clock::now();
  EXPECT_NE(reason(deep).find("hang from one another"), std::string::npos);
  EXPECT_NE(reason(wide).find("more than 4096 joints"), std::string::npos);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(Bvh, AFewBytesCannotAskForMuchMemory) {
  // 4096 joints that cost nothing a row, one number a row: a row of 2 bytes would be 128 KiB.
  std::string text = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n";
  for (int i = 0; i < 4000; ++i) text += "JOINT b\n{\nOFFSET 0 1 0\n}\n";
  text += "}\nMOTION\nFrames: 9\nFrame Time: .1\n";
  for (int i = 0; i < 20000; ++i) text += "0\n";
  EXPECT_NE(reason(text).find("rows of 4001 joints"), std::string::npos);
}

TEST(Bvh, WhatIsWrittenIsReadBackAlike) {
  const Motion motion = parsed(small_bvh);
  // Nine digits of a degree.
  expect_same(motion, parsed(bvh_text(motion)), 1e-7, 1e-8);
}

TEST(Bvh, RestRotationsAreWorkedIn) {
  Motion motion = parsed(small_bvh);
  motion.skeleton.joints[0].rest_rotation = axis_rotation(2, 0.5);
  motion.skeleton.joints[1].rest_rotation = axis_rotation(0, -0.7);
  const Motion back = parsed(bvh_text(motion));
  for (std::size_t f = 0; f < 2; ++f) {
    const auto tip = [&](const Motion& m, const Vec3& end) {
      const MotionFrame& frame = m.frames[f];
      return frame.root + frame.rotations[0] * (m.skeleton.joints[1].offset + frame.rotations[1] * end);
    };
    EXPECT_LT(glm::length(tip(motion, *motion.skeleton.joints[1].end) - tip(back, *back.skeleton.joints[1].end)), 1e-7);
  }
}

TEST(Bvh, RealFilesComeBackAlike) {
  SINEW_ASSETS_OR_SKIP(folder);
  int files = 0;
  for (const char* top : {"motions", "makehuman"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / top)) {
      if (entry.path().extension() != ".bvh") continue;
      const auto bytes = read_file(entry.path());
      ASSERT_TRUE(bytes);
      const auto motion = parse_bvh(*bytes, entry.path());
      ASSERT_TRUE(motion) << motion.error().message;
      const auto back = parse_bvh(bytes_of(bvh_text(*motion)), entry.path());
      ASSERT_TRUE(back) << back.error().message;
      expect_same(*motion, *back, 1e-6, 1e-6);
      ++files;
    }
  EXPECT_GE(files, 20);
}

/// Whatever is done to a file, reading ends, and with a motion or a reason.
TEST(Bvh, DamagedFilesEndWithAReason) {
  std::mt19937 random(1);
  const auto any = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::string words[] = {"{",
                               "}",
                               "JOINT",
                               "ROOT x",
                               "End Site",
                               "OFFSET",
                               "CHANNELS 3",
                               "nan",
                               "-1e308",
                               "\n",
                               "MOTION",
                               "Frames:",
                               "99999999999999999999",
                               std::string(1, '\0'),
                               "\xff\xfe"};
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = small_bvh;
    for (std::size_t k = 0; k <= any(3); ++k) {
      const std::size_t at = any(text.size());
      switch (any(4)) {
        case 0:
          text.resize(at + 1);
          break;
        case 1:
          text.erase(at, any(12) + 1);
          break;
        case 2:
          text.insert(at, words[any(std::size(words))]);
          break;
        default:
          text[at] = static_cast<char>(any(256));
      }
      if (text.empty()) text = " ";
    }
    const auto motion = parse_bvh(bytes_of(text), "walk.bvh");
    if (motion) {
      for (const MotionFrame& frame : motion->frames) EXPECT_EQ(frame.rotations.size(), motion->skeleton.joints.size());
      continue;
    }
    EXPECT_TRUE(motion.error().message.starts_with("walk.bvh:")) << motion.error().message;
    ++refused;
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace sinew::test
