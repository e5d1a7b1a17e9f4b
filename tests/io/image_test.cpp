#include "engine/io/image.h"

#include <gtest/gtest.h>

#include <string>

namespace sinew::test {
namespace {

std::vector<unsigned char> from_hexadecimal(const std::string& text) {
  std::vector<unsigned char> bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2)
    bytes.push_back(static_cast<unsigned char>(std::stoi(text.substr(i, 2), nullptr, 16)));
  return bytes;
}

// Each made with zlib by hand: signature, IHDR, IDAT, IEND.
const std::string rgb8 =
    "89504e470d0a1a0a0000000d49484452000000020000000108020000007b40e8dd0000000f49444154789c63f8cfc0c0f09f"
    "010007ff01ff017f89a70000000049454e44ae426082";  // 2 x 1: red, green
const std::string grey16 =
    "89504e470d0a1a0a0000000d49484452000000010000000110000000006aee47160000000b49444154789c6368f80f000202"
    "01806e568b130000000049454e44ae426082";  // 1 x 1: 0x80FF
const std::string huge =
    "89504e470d0a1a0a0000000d4948445200004e200000000108000000001edfc1520000000949444154789c63000000010001"
    "5eff7df90000000049454e44ae426082";  // 20000 x 1 as its header says

TEST(Image, EightBitColours) {
  const auto image = decode_image(from_hexadecimal(rgb8));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->width, 2);
  EXPECT_EQ(image->height, 1);
  EXPECT_EQ(image->rgba, (std::vector<unsigned char>{255, 0, 0, 255, 0, 255, 0, 255}));
}

TEST(Image, SixteenBitGreyIsReduced) {
  const auto image = decode_image(from_hexadecimal(grey16));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->rgba, (std::vector<unsigned char>{128, 128, 128, 255}));
}

TEST(Image, WhatIsNoPictureOrTooLargeIsRefused) {
  EXPECT_FALSE(decode_image({}));
  EXPECT_FALSE(decode_image(from_hexadecimal("00112233")));
  const auto too_large = decode_image(from_hexadecimal(huge));
  ASSERT_FALSE(too_large);
  EXPECT_NE(too_large.error().message.find("20000 x 1 pixels"), std::string::npos) << too_large.error().message;
  auto cut = from_hexadecimal(rgb8);
  cut.resize(cut.size() / 2);
  EXPECT_FALSE(decode_image(cut));
}

}  // namespace
}  // namespace sinew::test
