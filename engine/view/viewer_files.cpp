#include <algorithm>
#include <cmath>
#include <utility>

#include <spdlog/spdlog.h>

#include "engine/model/scene_words.h"
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
  opening_options_ = options_.scene;
  opening_options_.scene = file;
  opening_options_.poses.clear();
  opening_options_.clip.reset();
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
  reloaded_over_ = document().revision();
}

std::string ViewerSession::without_skin() {
  for (const StagedCharacter& character : document().stage().characters)
    if (!is_built_in_model(character.scene.model.string()) && character.model->skins.empty() &&
        character.model->clips.empty())
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
  if (opening_.is_cancelled()) return say(opening_.what() + ": stopped");
  if (!stage) return say(stage.error());
  if (reloads && document().revision() != reloaded_over_) {
    state_.changed_on_disk = true;
    return say("the file has changed on the disk, and so has what is shown");
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
  say(problems.empty() ? state_.file + done : problems.front(), false);
}

bool ViewerSession::follow_disk() {
  const bool compiles = shaders_.follow();
  if (opening_.running() || !disk_.has_changed()) return compiles;
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
    // What is being read is older than what was written just now.
    if (reloading_) opening_.cancel();
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
  take_shaders();
  if (state_.reload && !opening_.running()) {
    state_.reload = state_.changed_on_disk = false;
    reload();
  }
  const bool asked = std::exchange(state_.save, false), replace = std::exchange(state_.replace, false);
  if (asked) state_.replacing = is_others_file();
  if (replace || (asked && !state_.replacing)) save();
}

}  // namespace sinew
