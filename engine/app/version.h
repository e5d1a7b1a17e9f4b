#pragma once
#include <string>

namespace sinew {

/// The program's version, "0.1.0".
std::string version();

}  // namespace sinew
