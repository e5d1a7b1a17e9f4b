#pragma once
/// Acclaim skeletons and motions (ASF and AMC), as the CMU motion capture database has them, in.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/files.h"
#include "engine/core/result.h"
#include "engine/model/motion.h"

namespace sinew {

/// One number that an AMC file has of a bone.
enum class AcclaimDof : unsigned char { tx, ty, tz, rx, ry, rz, length };

/// What an ASF file holds: joints in the order of its hierarchy, one a bone, at the bone's beginning, their frames
/// parallel to the world's; the root is joint 0.
struct AcclaimSkeleton {
  MotionSkeleton skeleton;                   ///< metres_per_unit from `length`: a unit is 1 / length inches
  std::vector<std::vector<AcclaimDof>> dof;  ///< [joints] in the file's order; empty: fixed
  std::vector<Quat> axis;                    ///< [joints] C of the local rotation C M C^-1
  bool degrees = true;                       ///< of the motion's angles, where its own file does not say
  std::vector<std::string> problems;
};

/// Reads ASF text; `file` is its name, for messages. Fails as bad_input with line and column: sections that are missing
/// or wrong, a bone twice, a hierarchy that names an unknown bone, gives one two parents, does not reach one or runs in
/// a circle, more than 4096 bones or 256 above one another.
Result<AcclaimSkeleton> parse_asf(const Bytes& bytes, const std::filesystem::path& file);

/// Reads AMC text for a skeleton. Angles become degrees of M = Rz Ry Rx, each in its bone's axes. The format does not
/// say its rate: 120 frames a second, CMU's, unless `frame_time` is given; that, and bones that miss in a frame and
/// keep their last values, are noted. Fails as bad_input with line and column.
Result<Motion> parse_amc(const Bytes& bytes, const std::filesystem::path& file, const AcclaimSkeleton& skeleton,
                         double frame_time = 1.0 / 120.0);

/// The ASF file that an AMC file belongs to, among the files beside it: the one that its first lines name, that of its
/// own stem, that of the stem's first part ("02" of "02_01"), or the only one there is. Fails as bad_input where none
/// of these is there.
Result<std::filesystem::path> find_asf(const Bytes& amc, const std::filesystem::path& file);

}  // namespace sinew
