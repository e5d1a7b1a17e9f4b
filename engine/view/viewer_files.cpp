#include <algorithm>
#include <cmath>
#include <utility>

#include <spdlog/spdlog.h>

#include "engine/model/scene_words.h"
#include "engine/view/panel_parts.h"
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
  if (opening_.running()) return say("still opening another file");
  reloading_ = false;
  // Deformer, bulge and strength stay as they were chosen in the window.
  opening_options_ = document().options();
  opening_options_.scene = file;
  opened_over_ = document().revision();
  opened_told_.clear();
  const std::string name = std::filesystem::path(file).filename().string();
  opening_.start("opening " + name, [options = opening_options_](TaskWatch& watch) -> Result<Stage> {
    auto stage = open_stage(options, watch);
    if (!stage) return stage;
    auto bounds = stage_bounds(*stage, watch);
    if (!bounds) return pass_on(std::move(bounds));
    stage->bounds = *bounds;
    return stage;
  });
  say("opening " + file + " ...");
}

void ViewerSession::reload() {
  open_beside(state_.file);
  reloading_ = true;
}

std::string ViewerSession::without_skin() {
  for (const StagedCharacter& character : document().stage().characters)
    if (stands_still(character))
      return character.scene.model.filename().string() +
             ": no skin weights and no animation; Skin, on the left, binds it";
  return "";
}

void ViewerSession::take_opened() {
  auto opened = opening_.take();
  if (!opened) return;
  Result<Stage>& stage = *opened;
  const bool reloads = std::exchange(reloading_, false);
  // Stopped at its end it may have been done all the same.
  if (opening_.is_cancelled()) return reloads ? void() : say(opening_.what() + ": stopped");
  if (!stage) return say(stage.error());
  if (document().revision() != opened_over_ || edits_.is_busy()) {
    if (reloads) {
      state_.changed_on_disk = true;
      return say("the file has changed on the disk, and so has what is shown");
    }
    // Edited since it was asked for: that is not dropped unasked.
    state_.leaving = ViewState::Leaving{opening_options_.scene};
    return;
  }
  std::vector<std::string> problems = stage->problems;
  const double frame = state_.playback.frame;
  const std::string joint = state_.joint;
  const Camera seen_from = document().scene().camera, before = camera_in_file_;
  if (auto ok = show_stage(std::move(*stage), opening_options_, problems); !ok) return say(ok.error());
  if (reloads) {
    // What the user was looking at stays, unless the file says otherwise now.
    state_.playback.go_to(frame);
    const auto& characters = document().stage().characters;
    const auto listed = characters.empty() ? std::vector<ListedJoint>{} : listed_joints(characters.front());
    if (std::ranges::find(listed, joint, &ListedJoint::name) != listed.end()) state_.joint = joint;
    if (camera_in_file_ == before) document().move_camera(seen_from);
  }
  const char* done = reloads ? " read again" : " opened";
  if (const std::string unbound = without_skin(); !unbound.empty()) return say(unbound);
  if (!opened_told_.empty()) return say(opened_told_);
  say(problems.empty() ? state_.file + done : problems.front(), false);
}

bool ViewerSession::follow_disk() {
  const bool compiles = shaders_.follow();
  if (opening_.running() || !disk_.has_changed()) return compiles;
  // Edits that are not saved are not dropped unasked.
  (document().is_changed() || edits_.is_busy() ? state_.changed_on_disk : state_.reload) = true;
  return true;
}

/// There, and neither opened nor saved by this window.
bool ViewerSession::is_others_file() const {
  std::error_code failed;
  return std::filesystem::exists(state_.save_as, failed) &&
         !std::filesystem::equivalent(state_.save_as, own_file_, failed);
}

bool ViewerSession::save() {
  if (auto ok = document().save(state_.save_as); !ok) {
    say(ok.error());
    return false;
  }
  if (is_scene_file(state_.save_as)) {
    state_.file = state_.save_as;
    disk_.watch(state_.file);
    camera_in_file_ = document().scene().camera;
    state_.changed_on_disk = false;
    // What is being read is older than what was written just now.
    if (reloading_) opening_.cancel();
  }
  own_file_ = state_.save_as;
  remember(state_.save_as);
  say(state_.save_as + " written");
  return true;
}

bool ViewerSession::has_unsaved() {
  const ClipEditor* clip = state_.motion.browser.editor();
  return document().is_changed() || edits_.is_busy() || (clip != nullptr && clip->is_edited());
}

bool ViewerSession::may_close(Window& window) {
  if (closes_ || options_.frames > 0 || !has_unsaved()) return true;
  // Closed again while it asks, it is meant.
  if (state_.leaving && state_.leaving->file.empty() && state_.leaving->shown && !state_.replacing) return true;
  window.keep_open();
  state_.replacing = leaves_once_saved_ = false;
  state_.leaving = ViewState::Leaving{};
  return false;
}

void ViewerSession::leave(Window& window) {
  const ViewState::Leaving leaving = *std::exchange(state_.leaving, std::nullopt);
  leaves_once_saved_ = false;
  if (!leaving.file.empty()) {
    edits_.drop();
    return open_beside(leaving.file);
  }
  closes_ = true;
  window.close();
}

void ViewerSession::take_leave_answer(Window& window) {
  using Answer = ViewState::LeaveAnswer;
  const Answer answer = std::exchange(state_.leave_answer, Answer::none);
  if (!state_.leaving) return;
  if (answer == Answer::save) state_.save = leaves_once_saved_ = true;
  if (answer == Answer::stay) state_.leaving.reset();
  if (answer == Answer::drop) leave(window);
}

void ViewerSession::rescue() {
  if (!shown_ || !document().is_changed()) return;
  std::string file;
  std::error_code failed;
  // Those of other windows stay.
  for (int number = 1; file.empty() || std::filesystem::exists(file, failed); ++number)
    file = std::filesystem::path(state_.save_as)
               .replace_extension(number == 1 ? ".rescued.json" : fmt::format(".rescued{}.json", number))
               .string();
  if (auto ok = document().save(file); ok)
    spdlog::warn("edits that were not saved are kept in {}", file);
  else
    spdlog::error("edits that were not saved are lost: {}", ok.error().message);
}

void ViewerSession::take_file_requests(Window& window) {
  std::optional<std::string> wanted = std::exchange(state_.open, std::nullopt);
  for (const auto& file : window.take_dropped_files()) wanted = file.string();
  if (wanted && !wanted->empty()) {
    state_.leaving = ViewState::Leaving{*wanted};
    if (!has_unsaved()) leave(window);
  }
  take_leave_answer(window);
  take_opened();
  take_shaders();
  if (state_.reload && !opening_.running()) {
    state_.reload = state_.changed_on_disk = false;
    reload();
  }
  // What waits to be made ready is saved with all else.
  const bool asked = !edits_.is_busy() && std::exchange(state_.save, false),
             replace = std::exchange(state_.replace, false);
  if (asked) state_.replacing = is_others_file();
  if (replace || (asked && !state_.replacing)) {
    const ClipEditor* clip = state_.motion.browser.editor();
    const bool saved = save();
    if (saved && leaves_once_saved_ && clip != nullptr && clip->is_edited())
      say("the edits of clip " + clip->name() + " need a name: Motions saves them", true);
    else if (saved && leaves_once_saved_)
      leave(window);
  }
  // Not saved after all, nothing is left.
  if (leaves_once_saved_ && !state_.replacing && !state_.save) {
    leaves_once_saved_ = false;
    state_.leaving.reset();
  }
}

}  // namespace sinew
