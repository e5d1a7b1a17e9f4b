#pragma once
/// PNG in and out, with text chunks. Pictures are 8 bits a channel, RGBA, rows from the top, sRGB.

#include <span>
#include <string>
#include <vector>

#include "engine/core/files.h"
#include "engine/core/result.h"

namespace sinew {

/// Pictures larger than this, either way, are refused in both directions.
constexpr int largest_png_side = 16384;

/// A text chunk. Written as tEXt where the text is ASCII and as iTXt otherwise.
struct PngText {
  std::string keyword;  ///< 1 to 79 printable ASCII characters, no space at either end, no two in a row
  std::string text;     ///< UTF-8 without NUL

  bool operator==(const PngText&) const = default;
};

struct DecodedPng {
  int width = 0, height = 0;
  std::vector<unsigned char> rgba;  ///< [width * height * 4]
  std::vector<PngText> texts;       ///< in the file's order
};

/// The picture as a PNG file. Fast rather than small; the same picture gives the same bytes. Where `keep_alpha` is
/// false the file is RGB and alpha is dropped, not blended.
/// Fails as cannot_write where the size is out of range or not that of `rgba`, or a text cannot be stored.
Result<Bytes> encode_png(std::span<const unsigned char> rgba, int width, int height,
                         std::span<const PngText> texts = {}, bool keep_alpha = true);

/// Any PNG as 8-bit RGBA: palettes, grey, 16 bits and interlacing are converted, gamma and colour profiles ignored.
/// Fails as bad_input on a file that is no PNG, is damaged or cut short, or is too large.
Result<DecodedPng> decode_png(std::span<const unsigned char> file);

}  // namespace sinew
