#include "engine/io/png.h"

#include <random>

#include <gtest/gtest.h>

namespace sinew {
namespace {

Bytes random_pixels(int width, int height) {
  std::mt19937 random(7);
  Bytes rgba(std::size_t{4} * width * height);
  for (unsigned char& byte : rgba) byte = static_cast<unsigned char>(random());
  return rgba;
}

/// Smooth, so that a cut-short file is cut inside long matches as well as inside literals.
Bytes smooth_pixels(int width, int height) {
  Bytes rgba;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < 4; ++channel)
        rgba.push_back(static_cast<unsigned char>(x * channel / 3 + y * y / 40));
  return rgba;
}

const std::vector<PngText> some_texts = {{"sinew:recipe", "0123456789abcdef"}, {"Comment", "Größe: 1 280 × 720"}};

TEST(Png, RandomPixelsComeBack) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{7, 3}, std::pair{64, 33}}) {
    const Bytes rgba = random_pixels(width, height);
    const auto file = encode_png(rgba, width, height);
    ASSERT_TRUE(file) << file.error().message;
    const auto decoded = decode_png(*file);
    ASSERT_TRUE(decoded) << decoded.error().message;
    EXPECT_EQ(decoded->width, width);
    EXPECT_EQ(decoded->height, height);
    EXPECT_EQ(decoded->rgba, rgba);
    EXPECT_TRUE(decoded->texts.empty());
  }
}

TEST(Png, TextsComeBackInOrder) {
  const auto file = encode_png(random_pixels(5, 5), 5, 5, some_texts);
  ASSERT_TRUE(file) << file.error().message;
  const auto decoded = decode_png(*file);
  ASSERT_TRUE(decoded) << decoded.error().message;
  EXPECT_EQ(decoded->texts, some_texts);
}

TEST(Png, WithoutAlphaColoursStayAndAlphaIsFull) {
  Bytes rgba = random_pixels(9, 4);
  const auto file = encode_png(rgba, 9, 4, {}, false);
  ASSERT_TRUE(file) << file.error().message;
  const auto decoded = decode_png(*file);
  ASSERT_TRUE(decoded) << decoded.error().message;
  for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 255;
  EXPECT_EQ(decoded->rgba, rgba);
}

TEST(Png, SamePictureGivesSameBytes) {
  const Bytes rgba = smooth_pixels(40, 30);
  EXPECT_EQ(*encode_png(rgba, 40, 30, some_texts), *encode_png(rgba, 40, 30, some_texts));
}

TEST(Png, SaysThatItIsSrgbAndNotWhenItWasMade) {
  const auto file = encode_png(random_pixels(2, 2), 2, 2);
  ASSERT_TRUE(file);
  const std::string text(file->begin(), file->end());
  EXPECT_NE(text.find("sRGB"), std::string::npos);
  EXPECT_EQ(text.find("tIME"), std::string::npos);
}

TEST(Png, RefusesWhatItCannotWrite) {
  const Bytes rgba = random_pixels(2, 2);
  const auto reason = [&](int width, int height, const PngText& text) {
    const auto file = encode_png(rgba, width, height, std::span(&text, 1));
    EXPECT_FALSE(file);
    EXPECT_TRUE(file || file.error().kind == ErrorKind::cannot_write);
    return file ? std::string() : file.error().message;
  };
  const PngText good{"key", "text"};
  EXPECT_NE(reason(0, 2, good).find("0 x 2"), std::string::npos);
  EXPECT_NE(reason(16385, 2, good).find("16384"), std::string::npos);
  EXPECT_NE(reason(3, 2, good).find("24 bytes, not 16"), std::string::npos);
  for (const std::string& keyword : {std::string(), std::string(80, 'k'), std::string(" k"), std::string("k  k")})
    EXPECT_NE(reason(2, 2, {keyword, "text"}).find("keyword"), std::string::npos);
  EXPECT_NE(reason(2, 2, {"key", std::string("a\0b", 3)}).find("NUL"), std::string::npos);
}

TEST(Png, EveryTruncationIsAnError) {
  for (const Bytes& rgba : {random_pixels(64, 64), smooth_pixels(64, 64)}) {
    const auto file = encode_png(rgba, 64, 64, some_texts);
    ASSERT_TRUE(file);
    for (std::size_t size = 0; size < file->size(); size += size + 97 < file->size() ? 97 : 1) {
      const auto decoded = decode_png(std::span(*file).first(size));
      ASSERT_FALSE(decoded) << "cut to " << size << " of " << file->size();
      EXPECT_EQ(decoded.error().kind, ErrorKind::bad_input);
      EXPECT_FALSE(decoded.error().message.empty());
    }
  }
}

TEST(Png, EveryDamagedByteIsAnError) {
  const Bytes rgba = smooth_pixels(12, 12);
  const auto file = encode_png(rgba, 12, 12, some_texts);
  ASSERT_TRUE(file);
  for (std::size_t i = 0; i < file->size(); ++i) {
    Bytes damaged = *file;
    damaged[i] ^= 0x55;
    EXPECT_FALSE(decode_png(damaged)) << "byte " << i;
  }
}

/// PNG Specification, annex D.
std::uint32_t checksum(std::span<const unsigned char> bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const unsigned char byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? 0xEDB88320 ^ crc >> 1 : crc >> 1;
  }
  return ~crc;
}

/// The file with another size in its header, and the header's checksum made right again.
Bytes with_claimed_size(Bytes file, std::uint32_t width, std::uint32_t height) {
  const auto put = [&file](std::size_t at, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) file[at + i] = static_cast<unsigned char>(value >> (24 - 8 * i));
  };
  put(16, width);
  put(20, height);
  put(29, checksum(std::span(file).subspan(12, 17)));
  return file;
}

TEST(Png, HugeClaimsInASmallFileAreRefusedBeforeMemoryIsTaken) {
  const Bytes file = *encode_png(smooth_pixels(16, 16), 16, 16);
  ASSERT_TRUE(decode_png(with_claimed_size(file, 16, 16)));
  const auto largest = decode_png(with_claimed_size(file, 16384, 16384));
  ASSERT_FALSE(largest);
  EXPECT_NE(largest.error().message.find("cut short"), std::string::npos);
  EXPECT_FALSE(decode_png(with_claimed_size(file, 16, 17)));
  EXPECT_FALSE(decode_png(with_claimed_size(file, 16385, 1)));
  EXPECT_FALSE(decode_png(with_claimed_size(file, 0, 16)));
}

TEST(Png, OtherFilesAreNamedAsSuch) {
  const std::string text = "solid cube";
  const auto decoded = decode_png(std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
  ASSERT_FALSE(decoded);
  EXPECT_NE(decoded.error().message.find("signature"), std::string::npos);
}

}  // namespace
}  // namespace sinew
