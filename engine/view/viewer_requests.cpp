#include <utility>

#include <imgui.h>
#include <spdlog/spdlog.h>

#include "engine/app/panel.h"
#include "engine/view/viewer_session.h"

namespace sinew {

void ViewerSession::choose_view(View view) {
  Camera camera;
  camera.view = view;
  camera.projection = document().scene().camera.projection;
  document().move_camera(camera);
  stale_ = true;
}

void ViewerSession::toggle_projection() {
  OrbitCamera camera = OrbitCamera::of(maker(), state_.playback.shown(), aspect());
  camera.rays = camera.rays == Rays::parallel ? Rays::from_eye : Rays::parallel;
  look_from(camera);
}

void ViewerSession::frame_joint() {
  if (state_.joint.empty()) return say("choose a joint first: it is framed");
  const int frame = state_.playback.shown();
  const auto joint = find_zoom(document().stage(), state_.joint, state_.character);
  if (!joint) return say(joint.error());
  OrbitCamera camera = OrbitCamera::of(maker(), frame, aspect());
  camera.frame(zoom_position(document().stage(), *joint, frame), joint->reach, aspect());
  look_from(camera);
}

void ViewerSession::take_edit(const Result<Touched>& done, const std::string& said) {
  if (!done) return say(done.error());
  if (auto ok = follow(*done); !ok) {
    say(ok.error());
    // Where the device is lost the edit is rescued with all others.
    if (ok.error().kind == ErrorKind::device_failed) return;
    // Window and document show the same: what cannot be drawn is not done.
    if (const auto back = document().take_back(); !back) spdlog::error("{}", back.error().message);
    return state_.playback.set_range(document().stage().range);
  }
  state_.motion.edited_last = false;
  say(said);
}

void ViewerSession::take_edit(const ViewState::Edit& edit) {
  if (edits_.take(document(), edit.scene, edit.label, edit.merge))
    say(edit.label + " ...");
  else
    take_edit(document().edit(edit.scene, edit.label, edit.merge), edit.label);
}

void ViewerSession::take_step(bool back) {
  if (ClipEditor* clip = state_.edited_clip(); clip != nullptr && back) {
    clip->take_back();
    state_.motion.drag.reset();
    return say("undone: edit of " + clip->name());
  }
  if (back)
    if (const auto label = edits_.withdraw(document())) return say("not done: " + *label);
  const std::string label = back ? document().undo_label() : document().redo_label();
  if (back ? edits_.take_undo(document()) : edits_.take_redo(document())) return say(label + " ...");
  if (!label.empty())
    take_edit(back ? document().undo() : document().redo(), (back ? "undone: " : "done again: ") + label);
}

void ViewerSession::take_edits() {
  if (const auto edit = std::exchange(state_.edit, std::nullopt)) take_edit(*edit);
  if (const auto done = edits_.finish(document())) {
    if (!done->touched && done->touched.error().kind == ErrorKind::interrupted)
      say("stopped: " + done->said);
    else
      take_edit(done->touched, done->said);
  }
  if (std::exchange(state_.undo, false)) take_step(true);
  if (std::exchange(state_.redo, false)) take_step(false);
  state_.wanted_head = edits_.wanted_head(state_.character);
}

/// The box of all frames takes long to find: beside the window, and not while a slider is being dragged.
void ViewerSession::follow_bounds(bool may_find) {
  Task<Bounds>& framing = shown_->framing;
  if (bounds_stale_) framing.cancel();
  if (const auto found = framing.take(); found && *found && !bounds_stale_) {
    document().set_bounds(**found);
    shown_->picture->follow_stage();
    stale_ = true;
  }
  if (!bounds_stale_ || !may_find || framing.running()) return;
  const Stage& stage = document().stage();
  auto seen = std::make_shared<Stage>();
  seen->scene = stage.scene;
  seen->characters = stage.characters;
  seen->range = stage.range;
  seen->strength = stage.strength;
  bounds_stale_ = false;
  framing.start("finding the box of all frames",
                [seen = std::move(seen)](TaskWatch& watch) { return stage_bounds(*seen, watch); });
}

void ViewerSession::take_photo() {
  if (!bounds_known()) {
    // The photo frames all of the scene as it is now.
    document().set_bounds(stage_bounds(document().stage()));
    shown_->picture->follow_stage();
    shown_->framing.cancel();
    bounds_stale_ = false;
  }
  const auto file = shown_->picture->save_photo(state_.playback.shown(), size_, state_.save_as);
  file ? say(*file + " written") : say(file.error());
}

void ViewerSession::take_requests(Window& window) {
  // Edits first: a file that is read meanwhile must not take their place.
  // A panel that was hidden in the middle of a drag does not say that it ended.
  const bool dropped = document().is_merging() && !ImGui::IsAnyItemActive() && !ImGui::IsAnyMouseDown();
  const bool ended = std::exchange(state_.edit_ended, false) || dropped;
  take_edits();
  if (ended) edits_.seal(document());
  take_file_requests(window);
  follow_recording();
  follow_library();
  follow_binding();
  if (const auto options = std::exchange(state_.options, std::nullopt)) {
    document().set_options(options->deformer, options->bulge, options->strength);
    take_edit(Touched::all, "deformer");
  }
  follow_bounds(ended || !document().is_merging());
  if (const auto view = std::exchange(state_.view, std::nullopt)) choose_view(*view);
  if (std::exchange(state_.toggle_projection, false)) toggle_projection();
  if (state_.frame_all && bounds_known()) {
    state_.frame_all = false;
    OrbitCamera camera = OrbitCamera::of(maker(), state_.playback.shown(), aspect());
    camera.frame(maker().bounds(), aspect());
    look_from(camera);
  }
  if (std::exchange(state_.frame_joint, false)) frame_joint();
  if (std::exchange(state_.screenshot, false)) take_photo();
  if (std::exchange(state_.copy_command, false)) {
    const std::string command =
        render_command(document(), state_.save_as, state_.playback.shown(), size_.width, size_.height);
    window.set_clipboard(command);
    say((document().is_changed() ? "save first, then: " : "copied: ") + command);
  }
}

}  // namespace sinew
