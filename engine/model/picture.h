#pragma once
#include <cstdint>
#include <vector>

namespace sinew {

/// Eight-bit RGBA, sRGB colours, alpha not multiplied in; rows from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  ///< [height * width * 4]
};

}  // namespace sinew
