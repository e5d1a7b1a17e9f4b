#pragma once
/// Motion files into a library, all or none.

#include "engine/core/progress.h"
#include "engine/motion/library.h"

namespace sinew {

struct ImportOptions {
  std::string name;  ///< of the clip, where one file holds one motion; empty: as the motion is called
  std::vector<std::string> tags;
  std::string emotion, source, licence;  ///< `source` empty: the file's name
  bool replace = false;                  ///< clips of the same name
  ProgressStyle progress = ProgressStyle::automatic;
};

struct ImportReport {
  std::vector<std::string> clips;
  std::vector<std::string> problems;
};

/// Reads every motion of every file and adds it, in one transaction: where one fails, or the program is interrupted or
/// killed, the library is as it was. Fails as bad_input, cannot_write or interrupted.
Result<ImportReport> import_motions(MotionLibrary& library, const std::vector<std::filesystem::path>& files,
                                    const ImportOptions& options);

}  // namespace sinew
