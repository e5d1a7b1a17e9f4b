#include <utility>

#include "engine/core/files.h"
#include "engine/io/png.h"
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

void ViewerSession::take_edit(const Result<Touched>& done, const std::string& said) {
  if (!done) return say(done.error());
  if (auto ok = follow(*done); !ok) return say(ok.error());
  say(said);
}

void ViewerSession::take_photo() {
  const int frame = state_.playback.shown();
  auto picture = maker().picture(frame);
  if (!picture) return say(picture.error());
  const std::filesystem::path scene = state_.save_as;
  const std::filesystem::path file = scene.parent_path() / fmt::format("{}_{:04}.png", scene.stem().string(), frame);
  const auto png = encode_png(picture->rgba, picture->width, picture->height, {}, false);
  if (!png) return say(png.error());
  if (auto ok = write_file(file, *png); !ok) return say(ok.error());
  say(file.string() + " written");
}

void ViewerSession::take_requests(Window& window) {
  take_file_requests(window);
  follow_recording();
  follow_library();
  if (const auto edit = std::exchange(state_.edit, std::nullopt)) {
    auto done = document().edit(edit->scene, edit->label, edit->merge);
    take_edit(done, edit->label);
  }
  const bool ended = std::exchange(state_.edit_ended, false);
  if (ended) document().seal();
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
    maker().follow_stage();
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
  if (std::exchange(state_.screenshot, false)) take_photo();
  if (std::exchange(state_.copy_command, false)) {
    const std::string command =
        render_command(document(), state_.save_as, state_.playback.shown(), size_.width, size_.height);
    window.set_clipboard(command);
    say((document().is_changed() ? "save first, then: " : "copied: ") + command);
  }
}

}  // namespace sinew
