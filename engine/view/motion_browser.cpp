#include "engine/view/motion_browser.h"

#include <set>

#include "engine/motion/library_edit.h"

namespace sinew {
namespace {

bool asks_for_all(const ClipQuery& query) {
  return query.name.empty() && query.tag.empty() && query.emotion.empty() && !query.longest && !query.shortest;
}

Result<StoredClip> load(const std::filesystem::path& file, const std::string& name) {
  const auto library = MotionLibrary::open(file, false);
  if (!library) return tl::unexpected<Error>(library.error());
  return library->load(name);
}

Result<StoredClip> fit_and_keep(const std::filesystem::path& file, StoredClip clip, double tolerance,
                                TaskWatch& watch) {
  CurveFitOptions options;
  options.tolerance = tolerance;
  auto fit = fit_motion(clip.motion, options, watch);
  if (!fit) return pass_on(std::move(fit));
  auto library = MotionLibrary::open(file, true);
  if (!library) return pass_on(std::move(library));
  if (auto ok = library->begin(); !ok) return pass_on(std::move(ok));
  if (auto ok = library->set_curves(clip.entry.name, fit->clip); !ok) return pass_on(std::move(ok));
  if (auto ok = library->commit(); !ok) return pass_on(std::move(ok));
  clip.curves = std::move(fit->clip);
  clip.entry.fitted = true;
  return clip;
}

}  // namespace

void MotionBrowser::use_library(const std::filesystem::path& library) {
  const std::filesystem::path wanted = library_or_default(library);
  if (listed_ && wanted == library_) return;
  library_ = wanted;
  tags_stale_ = true;
  task_.cancel();
  clip_.reset();
  editor_.reset();
  refresh();
}

void MotionBrowser::refresh() {
  listed_ = true;
  clips_.clear();
  trouble_.clear();
  const auto library = MotionLibrary::open(library_, false);
  if (!library) {
    trouble_ = library.error().message;
    return;
  }
  auto found = library->list(query);
  if (!found) {
    trouble_ = found.error().message;
    return;
  }
  if (tags_stale_) {
    const auto all = asks_for_all(query) ? found : library->list();
    if (!all) {
      trouble_ = all.error().message;
      return;
    }
    std::set<std::string> tags;
    for (const ClipEntry& clip : *all) tags.insert(clip.tags.begin(), clip.tags.end());
    tags_.assign(tags.begin(), tags.end());
    tags_stale_ = false;
  }
  clips_ = std::move(*found);
}

void MotionBrowser::open(const std::string& clip) {
  if (task_.start("reading " + clip, [file = library_, clip](TaskWatch&) { return load(file, clip); })) saving_ = false;
}

void MotionBrowser::fit(double tolerance) {
  if (!clip_ || task_.running()) return;
  saving_ = false;
  task_.start("fitting " + clip_->entry.name, [file = library_, clip = *clip_, tolerance](TaskWatch& watch) {
    return fit_and_keep(file, clip, tolerance, watch);
  });
}

void MotionBrowser::save_as(const std::string& name) {
  if (!editor_ || task_.running()) return;
  saving_ = true;
  task_.start(
      "saving " + name,
      [file = library_, parent = editor_->name(), name, edits = editor_->edits()](TaskWatch&) -> Result<StoredClip> {
        auto library = MotionLibrary::open(file, true);
        if (!library) return pass_on(std::move(library));
        return edit_clip(*library, parent, name, edits, false);
      });
}

bool MotionBrowser::poll() {
  auto outcome = task_.take();
  if (!outcome) return false;
  // Stopped at its end it may have been done all the same; and it may be of another library.
  if (*outcome && task_.is_cancelled()) {
    news_ = News{task_.what() + ": stopped", false, ""};
    refresh();
    return true;
  }
  if (!*outcome) {
    const Error& error = outcome->error();
    news_ = News{task_.what() + ": " + error.message, error.kind != ErrorKind::interrupted, ""};
    return true;
  }
  tags_stale_ = true;
  StoredClip& clip = **outcome;
  const std::string name = clip.entry.name;
  clip_ = std::make_unique<StoredClip>(clip);
  editor_ = clip.curves ? std::make_unique<ClipEditor>(std::move(clip)) : nullptr;
  news_ = News{task_.what() + ": done", false, saving_ ? name : ""};
  refresh();
  return true;
}

}  // namespace sinew
