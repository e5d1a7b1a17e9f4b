#include <chrono>
#include <utility>

#include "engine/core/files.h"
#include "engine/io/png.h"
#include "engine/view/viewer_session.h"

namespace sinew {

void ViewerSession::choose_view(View view) {
  Camera camera;
  camera.view = view;
  document().move_camera(camera);
  stale_ = true;
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

void ViewerSession::open_beside(const std::string& file) {
  if (opening_.valid()) return say("still opening another file");
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
  if (auto ok = show_stage(std::move(*stage), opening_options_, problems); !ok) return say(ok.error());
  say(problems.empty() ? state_.file + " opened" : problems.front(), false);
}

void ViewerSession::take_requests(Window& window) {
  for (const auto& file : window.take_dropped_files()) open_beside(file.string());
  take_opened();
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
  if (std::exchange(state_.frame_all, false)) {
    OrbitCamera camera = OrbitCamera::of(maker(), state_.playback.shown(), aspect());
    camera.frame(maker().bounds(), aspect());
    look_from(camera);
  }
  if (std::exchange(state_.save, false)) {
    if (auto ok = document().save(state_.save_as); !ok)
      say(ok.error());
    else
      say(state_.save_as + " written");
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
