#include "engine/motion/library_edit.h"

#include <set>

namespace sinew {
namespace {

EditedMotion editable(const StoredClip& clip) {
  if (clip.curves) return {clip.motion.skeleton, *clip.curves};
  CurveFitOptions options;
  options.tolerance = refit_tolerance;
  return {clip.motion.skeleton, fit_motion(clip.motion, options).clip};
}

}  // namespace

Result<StoredClip> edit_clip(MotionLibrary& library, const std::string& parent, const std::string& name,
                             const nlohmann::json& edits, bool replace) {
  const auto from = library.load(parent);
  if (!from) return tl::unexpected<Error>(from.error());
  EditedMotion motion = editable(*from);
  const ClipSource clips = [&](const std::string& other) -> Result<EditedMotion> {
    auto clip = library.load(other);
    if (!clip) return pass_on(std::move(clip));
    return editable(*clip);
  };
  if (auto done = apply_edits(motion, edits, clips); !done)
    return bad_input("clip \"{}\": {}", parent, done.error().message);
  StoredClip made;
  made.entry = from->entry;
  made.entry.name = name;
  made.entry.parent = parent;
  made.entry.edit = edits.dump();
  made.entry.apex = std::nullopt;
  made.entry.fitted = true;
  made.motion = sampled_motion(motion.curves, motion.skeleton, name);
  made.entry.frames = made.motion.frames.size();
  made.curves = std::move(motion.curves);
  if (auto ok = library.begin(); !ok) return pass_on(std::move(ok));
  if (auto ok = library.add(made, replace); !ok) return pass_on(std::move(ok));
  if (auto ok = library.commit(); !ok) return pass_on(std::move(ok));
  return made;
}

Result<nlohmann::json> edits_of(const MotionLibrary& library, const std::string& name) {
  std::vector<nlohmann::json> steps;
  std::set<std::string> seen;
  for (std::string at = name; !at.empty() && seen.insert(at).second;) {
    const auto clip = library.load(at);
    // A parent may have gone since; what its child kept is enough.
    if (!clip && at != name) break;
    if (!clip) return tl::unexpected<Error>(clip.error());
    if (clip->entry.edit.empty()) break;
    auto step = nlohmann::json::parse(clip->entry.edit, nullptr, false);
    if (!step.is_array()) return bad_input("clip \"{}\": its edit is no list", at);
    steps.push_back(std::move(step));
    at = clip->entry.parent;
  }
  if (steps.empty()) return bad_input("clip \"{}\" was not made by edits; there is nothing to replay", name);
  nlohmann::json edits = nlohmann::json::array();
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) edits.insert(edits.end(), step->begin(), step->end());
  return edits;
}

}  // namespace sinew
