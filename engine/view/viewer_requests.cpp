#include <utility>

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
  if (auto ok = follow(*done); !ok) return say(ok.error());
  say(said);
}

void ViewerSession::take_photo() {
  const auto file = shown_->picture->save_photo(state_.playback.shown(), size_, state_.save_as);
  file ? say(*file + " written") : say(file.error());
}

void ViewerSession::take_requests(Window& window) {
  take_file_requests(window);
  follow_recording();
  follow_library();
  const auto edit = std::exchange(state_.edit, std::nullopt);
  if (edit && !heads_.take(document(), edit->scene, edit->label, edit->merge))
    take_edit(document().edit(edit->scene, edit->label, edit->merge), edit->label);
  if (const auto drawn = heads_.finish(document())) take_edit(*drawn, heads_.label());
  state_.wanted_head = heads_.wanted();
  const bool ended = std::exchange(state_.edit_ended, false);
  if (ended) heads_.is_busy() ? heads_.seal() : document().seal();
  if (state_.undo || state_.redo) heads_.drop();
  if (std::exchange(state_.undo, false) && document().can_undo()) {
    const std::string label = document().undo_label();
    take_edit(document().undo(), "undone: " + label);
  }
  if (std::exchange(state_.redo, false) && document().can_redo()) {
    const std::string label = document().redo_label();
    take_edit(document().redo(), "done again: " + label);
  }
  if (const auto options = std::exchange(state_.options, std::nullopt)) {
    document().set_options(options->deformer, options->bulge, options->strength);
    take_edit(Touched::all, "deformer");
  }
  // The box of all frames takes long to find: not while a slider is being dragged.
  if (bounds_stale_ && (ended || !document().is_merging())) {
    shown_->picture->follow_stage();
    bounds_stale_ = false;
    stale_ = true;
  }
  if (const auto view = std::exchange(state_.view, std::nullopt)) choose_view(*view);
  if (std::exchange(state_.toggle_projection, false)) toggle_projection();
  if (std::exchange(state_.frame_all, false)) {
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
