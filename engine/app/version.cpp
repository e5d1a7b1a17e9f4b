#include "engine/app/version.h"

namespace sinew {

std::string version() { return SINEW_VERSION; }

}  // namespace sinew
