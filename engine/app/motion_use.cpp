#include "engine/app/motion_use.h"

#include "engine/core/files.h"
#include "engine/core/text.h"
#include "engine/rig/clip_sampling.h"
#include "engine/rig/motion_file.h"

namespace sinew {
namespace {

/// A sinking foot that nobody sees is not worth a word: 1 % of a body's hip height is about a centimetre.
constexpr double told_sinking = 0.01;

std::string clip_hash(const Clip& clip) {
  Sha256 hash;
  for (const Channel& channel : clip.channels) {
    hash.add_all(std::vector<int>{channel.node, static_cast<int>(channel.path)});
    hash.add_all(channel.times);
    hash.add_all(channel.values);
  }
  return hash.finish();
}

}  // namespace

bool is_motion_alone(const std::filesystem::path& file, std::span<const unsigned char> bytes) {
  const auto format = motion_format(file, bytes);
  if (!format) return false;
  return *format != MotionFormat::gltf || lower(file.extension().string()) == ".vrma";
}

Result<Motion> library_motion(const std::filesystem::path& library, const std::string& clip) {
  const auto opened = MotionLibrary::open(library_or_default(library), false);
  if (!opened) return tl::unexpected<Error>(opened.error());
  auto stored = opened->load(clip);
  if (!stored) return pass_on(std::move(stored));
  return played_motion(std::move(*stored));
}

Motion played_motion(StoredClip&& stored) {
  if (!stored.curves) return std::move(stored.motion);
  return sampled_motion(*stored.curves, stored.motion.skeleton, stored.entry.name);
}

std::string file_state(const std::filesystem::path& file) {
  std::string state = file.string();
  for (const char* end : {"", "-wal"}) {
    std::error_code none;
    const auto size = std::filesystem::file_size(file.string() + end, none);
    // An empty log comes and goes with whoever reads.
    if (none || (size == 0 && *end != 0)) continue;
    const auto time = std::filesystem::last_write_time(file.string() + end, none);
    state += fmt::format(" {} {}", size, time.time_since_epoch().count());
  }
  return state;
}

Result<StagedMotion> put_motion(const Motion& motion, const std::string& name, const MotionUse& use, const Model& model,
                                const Humanoid& humanoid) {
  auto retargeted = retarget(motion, model, humanoid);
  if (!retargeted) return pass_on(std::move(retargeted));
  std::vector<std::string> notes;
  for (const std::string& problem : motion.problems) notes.push_back(fmt::format("{}: {}", name, problem));
  for (const std::string& note : retargeted->notes) notes.push_back(fmt::format("{}: {}", name, note));
  if (retargeted->deepest_sinking > told_sinking)
    notes.push_back(fmt::format("{}: a foot sank {:.3f} below the floor at its frame {}; the body is raised there",
                                name, retargeted->deepest_sinking, retargeted->deepest_frame));
  std::string hash = clip_hash(retargeted->clip);
  return StagedMotion{use, std::make_shared<Clip>(std::move(retargeted->clip)), "", std::move(hash), std::move(notes)};
}

Result<StagedMotion> stage_motion(const MotionUse& use, const std::filesystem::path& library, const Model& model,
                                  const Humanoid& humanoid, const TaskWatch& watch) {
  const MotionFile* file = std::get_if<MotionFile>(&use.source);
  auto motion = file != nullptr ? read_motion(file->path, file->clip)
                                : library_motion(library, std::get<LibraryClip>(use.source).name);
  if (!motion) return pass_on(std::move(motion));
  if (auto ok = watch.check(); !ok) return pass_on(std::move(ok));
  const std::string name = file != nullptr ? file->path.string() : fmt::format("clip {}", motion->name);
  auto staged = put_motion(*motion, name, use, model, humanoid);
  if (staged) staged->file = file != nullptr ? file->path.string() : library.string();
  return staged;
}

double motion_seconds(const MotionUse& use, double frame, double fps) { return (frame - use.start) / fps * use.speed; }

void play_motion(const StagedMotion& motion, double frame, double fps, Pose& pose) {
  const double weight = motion.use.weight.value_at(frame);
  if (weight <= 0.0) return;
  const double seconds = motion_seconds(motion.use, frame, fps);
  Pose played = pose;
  sample_clip(*motion.clip, seconds, played);
  if (weight >= 1.0) {
    pose = std::move(played);
  } else {
    blend_pose(played, weight, pose);
  }
}

double last_frame(const StagedMotion& motion, double fps) {
  return motion.use.start + motion.clip->duration * fps / motion.use.speed;
}

}  // namespace sinew
