#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <spdlog/spdlog.h>

#include "engine/view/viewer_session.h"

namespace sinew {

bool is_scene_file(const std::string& file) { return std::filesystem::path(file).extension() == ".json"; }

void ViewerSession::go_on_from(const Preferences& preferences, const std::filesystem::path& file) {
  preferences_ = preferences;
  preferences_file_ = file;
  state_.panels = preferences.panels;
  state_.motion.shown = preferences.motion_panel;
  state_.folder = preferences.folder;
  state_.recent = preferences.recent;
}

void ViewerSession::keep_preferences(const Window& window) {
  if (preferences_file_.empty()) return;
  const PictureSize size = window.size();
  const auto units = [&](int pixels) { return static_cast<int>(std::lround(pixels / window.pixels_per_unit())); };
  if (size.width > 0 && size.height > 0) preferences_.window = {units(size.width), units(size.height)};
  preferences_.panels = state_.panels;
  preferences_.motion_panel = state_.motion.shown;
  if (auto ok = save_preferences(preferences_, preferences_file_); !ok) spdlog::warn("{}", ok.error().message);
}

void ViewerSession::remember(const std::string& file) {
  preferences_.remember(file);
  state_.recent = preferences_.recent;
  state_.folder = preferences_.folder;
}

void ViewerSession::open_beside(const std::string& file) {
  if (opening_.valid()) return say("still opening another file");
  reloading_ = false;
  opening_options_ = options_.scene;
  opening_options_.scene = file;
  opening_options_.poses.clear();
  opening_options_.clip.reset();
  opening_ = std::async(std::launch::async, [options = opening_options_] { return open_stage(options); });
  say("opening " + file + " ...");
}

void ViewerSession::take_opened() {
  if (!opening_.valid() || opening_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  auto stage = opening_.get();
  if (!stage) return say(stage.error());
  std::vector<std::string> problems = stage->problems;
  const double frame = state_.playback.frame;
  const std::string joint = state_.joint;
  const Camera seen_from = document().scene().camera, before = camera_in_file_;
  if (auto ok = show_stage(std::move(*stage), opening_options_, problems); !ok) return say(ok.error());
  if (reloading_) {
    // What the user was looking at stays, unless the file says otherwise now.
    state_.playback.go_to(frame);
    const auto& characters = document().stage().characters;
    const auto listed = characters.empty() ? std::vector<ListedJoint>{} : listed_joints(characters.front());
    if (std::ranges::find(listed, joint, &ListedJoint::name) != listed.end()) state_.joint = joint;
    if (camera_in_file_ == before) document().move_camera(seen_from);
  }
  const char* done = std::exchange(reloading_, false) ? " read again" : " opened";
  say(problems.empty() ? state_.file + done : problems.front(), false);
}

bool ViewerSession::follow_disk() {
  if (opening_.valid() || !disk_.has_changed()) return false;
  // Edits that are not saved are not dropped unasked.
  (document().is_changed() ? state_.changed_on_disk : state_.reload) = true;
  return true;
}

/// There, and neither opened nor saved by this window.
bool ViewerSession::is_others_file() const {
  std::error_code failed;
  return std::filesystem::exists(state_.save_as, failed) &&
         !std::filesystem::equivalent(state_.save_as, own_file_, failed);
}

void ViewerSession::save() {
  if (auto ok = document().save(state_.save_as); !ok) return say(ok.error());
  if (is_scene_file(state_.save_as)) {
    state_.file = state_.save_as;
    disk_.watch(state_.file);
    camera_in_file_ = document().scene().camera;
    state_.changed_on_disk = false;
  }
  own_file_ = state_.save_as;
  remember(state_.save_as);
  say(state_.save_as + " written");
}

void ViewerSession::rescue() {
  if (!shown_ || !document().is_changed()) return;
  const std::string file = std::filesystem::path(state_.save_as).replace_extension(".rescued.json").string();
  if (auto ok = document().save(file); ok)
    spdlog::warn("edits that were not saved are kept in {}", file);
  else
    spdlog::error("edits that were not saved are lost: {}", ok.error().message);
}

void ViewerSession::take_file_requests(Window& window) {
  for (const auto& file : window.take_dropped_files()) open_beside(file.string());
  if (const auto file = std::exchange(state_.open, std::nullopt); file && !file->empty()) open_beside(*file);
  take_opened();
  if (state_.reload && !opening_.valid()) {
    state_.reload = state_.changed_on_disk = false;
    open_beside(state_.file);
    reloading_ = true;
  }
  const bool asked = std::exchange(state_.save, false), replace = std::exchange(state_.replace, false);
  if (asked) state_.replacing = is_others_file();
  if (replace || (asked && !state_.replacing)) save();
}

}  // namespace sinew
