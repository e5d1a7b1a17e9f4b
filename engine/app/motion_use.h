#pragma once
/// A scene's motion on a character: found, read, put onto the model, played.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/task_watch.h"
#include "engine/model/scene.h"
#include "engine/motion/library.h"
#include "engine/rig/pose.h"
#include "engine/rig/retarget.h"

namespace sinew {

/// What a body does over an emotion's clip, in the scene's frames: it begins, comes near the pose of its apex, leaves
/// it for the last time, and ends.
struct EmotionSpan {
  double begin = 0.0, near = 0.0, leaving = 0.0, end = 0.0;
};

/// What a staged motion follows from: what is the same makes the same motion.
struct MotionOrigin {
  std::variant<MotionChoice, EmotionCue> asked;
  double fps = 0.0;          ///< the scene's, for an emotion, whose clip is laid by its apex
  std::string file;          ///< that it is read from, as file_state() has it
  std::string model_hash{};  ///< of the model that it is put onto
  bool operator==(const MotionOrigin&) const = default;
};

/// A motion as an animation of the character's own model.
struct StagedMotion {
  MotionUse use;
  std::shared_ptr<const Clip> clip;
  std::string file;                ///< that it was read from
  std::string content_hash;        ///< of the clip
  std::vector<std::string> notes;  ///< what people should know of it
  EmotionSpan span{};              ///< of an emotion's
  MotionOrigin origin{};
};

/// True where the file holds a motion and nothing to draw: BVH, ASF, AMC, or a VRM animation.
bool is_motion_alone(const std::filesystem::path& file, std::span<const unsigned char> bytes);

/// The clip of that name in a motion library; an empty path is the user's own library. Fails as bad_input.
Result<Motion> library_motion(const std::filesystem::path& library, const std::string& clip);

/// A clip of the library as it is played: its fitted curves where it has some, else its samples.
Motion played_motion(StoredClip&& stored);

/// A file as it is now, its write-ahead log with it: name, sizes, times of change.
std::string file_state(const std::filesystem::path& file);

/// Puts a motion, called `name` in what it says to people, onto the model.
Result<StagedMotion> put_motion(const Motion& motion, const std::string& name, const MotionUse& use, const Model& model,
                                const Humanoid& humanoid);

/// Reads the motion and puts it onto the model. Fails as bad_input where it cannot be read or has nothing in common
/// with the model; as interrupted.
Result<StagedMotion> stage_motion(const MotionUse& use, const std::filesystem::path& library, const Model& model,
                                  const Humanoid& humanoid, const TaskWatch& watch);

/// How far into the motion a frame of the scene is, seconds.
double motion_seconds(const MotionUse& use, double frame, double fps);

/// Puts the pose of a frame over the one that is there, by the motion's weight.
void play_motion(const StagedMotion& motion, double frame, double fps, Pose& pose);

/// The frame at which the motion ends.
double last_frame(const StagedMotion& motion, double fps);

}  // namespace sinew
