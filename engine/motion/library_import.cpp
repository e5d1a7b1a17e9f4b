#include "engine/motion/library_import.h"

#include "engine/core/interrupt.h"
#include "engine/rig/motion_file.h"

namespace sinew {

Result<ImportReport> import_motions(MotionLibrary& library, const std::vector<std::filesystem::path>& files,
                                    const ImportOptions& options) {
  ImportReport report;
  if (auto begun = library.begin(); !begun) return pass_on(std::move(begun));
  Progress progress("motions", files.size(), options.progress);
  for (const std::filesystem::path& file : files) {
    auto motions = read_motions(file);
    if (!motions) return pass_on(std::move(motions));
    if (!options.name.empty() && motions->size() != 1)
      return bad_input("{}: holds {} motions, and one name is given; import it without --name", file.string(),
                       motions->size());
    for (Motion& motion : *motions) {
      if (auto stop = check_interrupt(); !stop) return pass_on(std::move(stop));
      StoredClip clip;
      clip.entry.name = options.name.empty() ? motion.name : options.name;
      clip.entry.tags = options.tags;
      clip.entry.emotion = options.emotion;
      clip.entry.source = options.source.empty() ? file.filename().string() : options.source;
      clip.entry.licence = options.licence;
      for (const std::string& problem : motion.problems) report.problems.push_back(file.string() + ": " + problem);
      clip.motion = std::move(motion);
      if (auto added = library.add(clip, options.replace); !added)
        return tl::unexpected<Error>(Error{added.error().kind, file.string() + ": " + added.error().message});
      report.clips.push_back(clip.entry.name);
    }
    progress.advance();
  }
  if (auto done = library.commit(); !done) return pass_on(std::move(done));
  return report;
}

}  // namespace sinew
