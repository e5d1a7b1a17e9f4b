#pragma once
/// The motion library: clips, skeletons, curves, tags and edits in one SQLite file. Several programs may read while one
/// writes (write-ahead log); a change is a transaction, so that a killed program leaves the library as it was.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/motion/motion_fit.h"

namespace sinew {

/// What a list shows of a clip.
struct ClipEntry {
  std::string name;
  std::size_t frames = 0, joints = 0;
  double frame_time = 1.0 / 30.0;
  std::vector<std::string> tags;
  std::string emotion;          ///< one of expression_names(), or empty
  std::string source, licence;  ///< where it came from; under which terms
  std::optional<double> apex;   ///< seconds, as it was set; nothing: find_apex()
  bool fitted = false;          ///< has curves
  std::string parent;           ///< the clip that it was edited from, or empty
  std::string edit;             ///< the edits that made it from its parent, as JSON, or empty

  double duration() const { return frames == 0 ? 0.0 : frame_time * static_cast<double>(frames - 1); }
};

struct StoredClip {
  ClipEntry entry;
  Motion motion;  ///< its samples
  std::optional<CurveClip> curves;
};

/// What to search for; what is left out does not matter.
struct ClipQuery {
  std::string name;  ///< a part of it, letter case ignored
  std::string tag, emotion;
  std::optional<double> longest, shortest;  ///< seconds
};

/// $XDG_DATA_HOME/sinew/motions.db, else ~/.local/share/sinew/motions.db.
std::filesystem::path default_library();
/// The library of that name; the user's own where it is empty.
inline std::filesystem::path library_or_default(const std::filesystem::path& library) {
  return library.empty() ? default_library() : library;
}

class MotionLibrary {
 public:
  /// `write`: made, with its folder, where it is not there; brought to the present schema where it is older. Fails as
  /// bad_input where it is no library, newer than this program, damaged, or, for reading, absent; as cannot_write where
  /// it cannot be made.
  static Result<MotionLibrary> open(const std::filesystem::path& file, bool write);
  MotionLibrary(MotionLibrary&&) noexcept;
  MotionLibrary& operator=(MotionLibrary&&) noexcept;
  ~MotionLibrary();

  /// Clips by name.
  Result<std::vector<ClipEntry>> list(const ClipQuery& query = {}) const;
  /// Fails as bad_input with the nearest name where there is no such clip.
  Result<StoredClip> load(const std::string& name) const;

  /// Changes between begin() and commit() appear together or, where this object ends without commit(), not at all.
  Result<void> begin();
  Result<void> commit();

  /// Fails as bad_input where the name is taken, unless `replace`.
  Result<void> add(const StoredClip& clip, bool replace = false);
  Result<void> set_curves(const std::string& name, const CurveClip& curves);
  /// Tags, emotion, source, licence and apex of `entry`, which names the clip.
  Result<void> annotate(const ClipEntry& entry);
  Result<void> remove(const std::string& name);

  const std::filesystem::path& file() const;

 private:
  struct Impl;
  explicit MotionLibrary(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace sinew
