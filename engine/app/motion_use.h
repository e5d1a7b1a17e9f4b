#pragma once
/// A scene's motion on a character: found, read, put onto the model, played.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/model/scene.h"
#include "engine/motion/library.h"
#include "engine/rig/pose.h"
#include "engine/rig/retarget.h"

namespace sinew {

/// A motion as an animation of the character's own model.
struct StagedMotion {
  MotionUse use;
  Clip clip;
  std::string file;          ///< that it was read from
  std::string content_hash;  ///< of the clip
};

/// True where the file holds a motion and nothing to draw: BVH, ASF, AMC, or a VRM animation.
bool is_motion_alone(const std::filesystem::path& file, std::span<const unsigned char> bytes);

/// The clip of that name in a motion library; an empty path is the user's own library. Fails as bad_input.
Result<Motion> library_motion(const std::filesystem::path& library, const std::string& clip);

/// A clip of the library as it is played: its fitted curves where it has some, else its samples.
Motion played_motion(StoredClip&& stored);

/// Puts a motion, called `name` in what it says to people, onto the model.
Result<StagedMotion> put_motion(const Motion& motion, const std::string& name, const MotionUse& use, const Model& model,
                                const Humanoid& humanoid, std::vector<std::string>& problems);

/// Reads the motion and puts it onto the model. What people should know of it goes to `problems`. Fails as bad_input
/// where it cannot be read or has nothing in common with the model.
Result<StagedMotion> stage_motion(const MotionUse& use, const std::filesystem::path& library, const Model& model,
                                  const Humanoid& humanoid, std::vector<std::string>& problems);

/// Puts the pose of a frame over the one that is there, by the motion's weight.
void play_motion(const StagedMotion& motion, double frame, double fps, Pose& pose);

/// The frame at which the motion ends.
double last_frame(const StagedMotion& motion, double fps);

}  // namespace sinew
