#pragma once
/// Biovision hierarchies (BVH) in and out.

#include <filesystem>
#include <string>

#include "engine/core/files.h"
#include "engine/core/result.h"
#include "engine/model/motion.h"

namespace sinew {

/// Reads BVH text; `file` is its name, for messages and for the motion's name. Channels may come in any number and
/// order; position channels stand for the joint's place in its parent's frame, in place of its offset, but for joints
/// below the root whose positions lie nearer to zero than to the offset: there they are added to it. Numbers may stand
/// anywhere on their lines. Where the count of frames disagrees with the rows, the rows are right, and
/// Motion::problems says so. Fails as bad_input with line and column: what is missing, cut off or no number, a row of
/// the wrong length, a frame time outside 1e-5..60 s, more than 4096 joints or 256 above one another.
Result<Motion> parse_bvh(const Bytes& bytes, const std::filesystem::path& file);

/// The motion as BVH text. Joints keep their channels; the root always has six, rotations without a known order get
/// Zrotation Xrotation Yrotation, and joints whose offsets change get positions. A skeleton with rest rotations is
/// written in the frames that BVH has, all parallel to the world's in the rest pose. Numbers have nine significant
/// digits.
std::string bvh_text(const Motion& motion);

/// The same motion on the same skeleton with rest rotations of identity: joint frames parallel to the world's in rest.
/// Channels that meant other frames are forgotten.
Motion without_rest_rotations(const Motion& motion);

}  // namespace sinew
