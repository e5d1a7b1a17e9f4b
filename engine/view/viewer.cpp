#include "engine/view/viewer.h"

#include <chrono>
#include <cmath>
#include <future>

#include <imgui.h>

#include "engine/core/interrupt.h"
#include "engine/render/text.h"
#include "engine/view/head_work.h"
#include "engine/view/orbit_camera.h"
#include "engine/view/panels.h"
#include "engine/view/picture_tools.h"
#include "engine/view/window_picture.h"

namespace sinew {
namespace {

using Clock = std::chrono::steady_clock;

/// The interface needs some frames after the last event to come to rest.
constexpr int frames_to_rest = 3;
constexpr double capped_seconds = 1.0 / 60.0;

class Viewer {
 public:
  Viewer(Device& device, const ViewerOptions& options) : device_(device), options_(options) {
    state_.device = device.info().name + (device.info().cpu ? " (a CPU)" : "");
    state_.save_as = "scene.json";
  }

  Result<void> open(const SceneOptions& scene, std::vector<std::string>& problems);
  Result<ViewerReport> run(Window& window);

 private:
  Result<void> show_stage(Stage stage, const SceneOptions& scene, std::vector<std::string>& problems);

  /// Everything of one opened scene; the picture points into the document, so they stay and go together.
  struct Shown {
    Document document;
    std::optional<WindowPicture> picture;
    explicit Shown(Document opened) : document(std::move(opened)) {}
  };

  Document& document() { return shown_->document; }
  FrameMaker& maker() { return shown_->picture->maker(); }
  double aspect() const { return double(size_.width) / std::max(1, size_.height); }

  Result<void> make_pictures(Shown& shown, std::vector<std::string>& problems);
  Result<void> follow(Touched what);
  void take_pointer();
  void take_keys(Window& window);
  void take_key(const KeyPress& press, Window& window);
  void take_requests(Window& window);
  void take_edit(const Result<Touched>& done, const std::string& said);
  void look_from(const OrbitCamera& camera);
  void choose_view(View view);
  void take_photo();
  void open_beside(const std::string& file);
  void take_opened();
  void say(std::string message, bool is_error = false) {
    state_.message = std::move(message);
    state_.is_error = is_error;
    stale_ = true;
  }
  void say(const Error& error) { say(error.message, true); }
  Result<void> show_frame(Window& window);

  Device& device_;
  ViewerOptions options_;
  ViewState state_;
  PictureSize size_;
  std::unique_ptr<Shown> shown_;
  HeadWork heads_;
  PictureTools tools_;
  std::future<Result<Stage>> opening_;
  SceneOptions opening_options_;
  bool bounds_stale_ = false;  ///< the maker's bounds are those before the last poses
  bool stale_ = true;          ///< the picture is not that of the document any more
  int drawn_frame_ = -1;
  ViewExtras drawn_extras_;
};

Result<void> Viewer::make_pictures(Shown& shown, std::vector<std::string>& problems) {
  LookOptions look = options_.look;
  look.size = size_;
  // What the scene says is edited here; only what it cannot say comes from the command line.
  auto made = WindowPicture::create(device_, shown.document, look, problems);
  if (!made) return pass_on(std::move(made));
  shown.picture.emplace(std::move(*made));
  state_.compared = {shown.picture->left_label(), shown.picture->right_label()};
  return {};
}

Result<void> Viewer::open(const SceneOptions& scene, std::vector<std::string>& problems) {
  size_ = options_.look.size;
  auto stage = open_stage(scene);
  if (!stage) return pass_on(std::move(stage));
  problems.insert(problems.end(), stage->problems.begin(), stage->problems.end());
  return show_stage(std::move(*stage), scene, problems);
}

Result<void> Viewer::show_stage(Stage stage, const SceneOptions& scene, std::vector<std::string>& problems) {
  auto document = Document::create(std::move(stage), scene);
  if (!document) return pass_on(std::move(document));
  auto shown = std::make_unique<Shown>(std::move(*document));
  if (auto ok = make_pictures(*shown, problems); !ok) return ok;
  heads_.drop();
  shown_ = std::move(shown);
  state_.file = scene.scene.empty() ? "the embedded scene" : scene.scene;
  const bool is_scene_file = std::filesystem::path(scene.scene).extension() == ".json";
  state_.save_as = is_scene_file ? scene.scene : "scene.json";
  state_.joint.clear();
  state_.character = 0;
  state_.playback = {};
  state_.playback.set_range(this->document().stage().range);
  state_.playback.go_to(state_.playback.range.first);
  stale_ = true;
  return {};
}

Result<void> Viewer::follow(Touched what) {
  stale_ = true;
  state_.playback.set_range(document().stage().range);
  if (what == Touched::poses) bounds_stale_ = true;
  if (what != Touched::all) return {};
  bounds_stale_ = false;
  std::vector<std::string> problems;
  return make_pictures(*shown_, problems);
}

void Viewer::look_from(const OrbitCamera& camera) {
  document().move_camera(camera.camera());
  stale_ = true;
}

void Viewer::choose_view(View view) {
  Camera camera;
  camera.view = view;
  document().move_camera(camera);
  stale_ = true;
}

void Viewer::take_pointer() {
  const ImGuiIO& io = ImGui::GetIO();
  if (tools_.work(document(), state_, maker().shot(state_.playback.shown()).viewpoint) && io.MouseWheel == 0.0f) return;
  if (io.WantCaptureMouse) return;
  const double height = std::max(1.0f, io.DisplaySize.y);
  OrbitCamera camera = OrbitCamera::of(maker(), state_.playback.shown(), aspect());
  const double across = io.MouseDelta.x / height, down = io.MouseDelta.y / height;
  bool moved = io.MouseWheel != 0.0f;
  if (moved) camera.zoom(io.MouseWheel);
  if (across != 0.0 || down != 0.0) {
    const bool pans = ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                      (ImGui::IsMouseDown(ImGuiMouseButton_Left) && io.KeyShift);
    if (pans) {
      camera.pan(across, down);
      moved = true;
    } else if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
      camera.orbit(across, down);
      moved = true;
    }
  }
  if (moved) look_from(camera);
}

void Viewer::take_keys(Window& window) {
  for (const KeyPress& press : window.take_key_presses()) take_key(press, window);
}

void Viewer::take_key(const KeyPress& press, Window& window) {
  Playback& playback = state_.playback;
  const int steps = press.shift ? 10 : 1;
  const auto go_to = [&](int frame) {
    playback.go_to(frame);
    playback.playing = false;
  };
  // Held keys step; everything else happens once.
  if (press.key == KeyboardKey::left) return go_to(playback.shown() - steps);
  if (press.key == KeyboardKey::right) return go_to(playback.shown() + steps);
  if (press.again) return;
  switch (press.key) {
    case KeyboardKey::f:
      state_.frame_all = true;
      break;
    case KeyboardKey::k:
      if (state_.joint.empty()) break;
      {
        Scene scene = document().scene();
        add_joint_key(scene.characters[state_.character], state_.joint, playback.shown());
        state_.ask(scene, "key for " + state_.joint);
      }
      break;
    case KeyboardKey::p:
      state_.screenshot = true;
      break;
    case KeyboardKey::q:
      if (press.control) window.close();
      break;
    case KeyboardKey::s:
      state_.save = state_.save || press.control;
      break;
    case KeyboardKey::y:
      state_.redo = state_.redo || press.control;
      break;
    case KeyboardKey::z:
      if (press.control) (press.shift ? state_.redo : state_.undo) = true;
      break;
    case KeyboardKey::one:
      state_.view = press.control ? View::back : View::front;
      break;
    case KeyboardKey::three:
      state_.view = press.control ? View::right : View::left;
      break;
    case KeyboardKey::five:
      state_.view = View::three_quarter;
      break;
    case KeyboardKey::seven:
      state_.view = View::top;
      break;
    case KeyboardKey::space:
      playback.playing = !playback.playing;
      break;
    case KeyboardKey::tab:
      state_.panels = !state_.panels;
      break;
    case KeyboardKey::home:
      go_to(playback.range.first);
      break;
    case KeyboardKey::end:
      go_to(playback.range.last);
      break;
    case KeyboardKey::help:
      state_.help = !state_.help;
      break;
    case KeyboardKey::left:
    case KeyboardKey::right:
      break;
  }
}

void Viewer::take_edit(const Result<Touched>& done, const std::string& said) {
  if (!done) return say(done.error());
  if (auto ok = follow(*done); !ok) return say(ok.error());
  say(said);
}

void Viewer::take_photo() {
  const auto file = shown_->picture->save_photo(state_.playback.shown(), state_.save_as);
  file ? say(*file + " written") : say(file.error());
}

void Viewer::open_beside(const std::string& file) {
  if (opening_.valid()) return say("still opening another file");
  opening_options_ = options_.scene;
  opening_options_.scene = file;
  opening_options_.poses.clear();
  opening_options_.clip.reset();
  opening_ = std::async(std::launch::async, [options = opening_options_] { return open_stage(options); });
  say("opening " + file + " ...");
}

void Viewer::take_opened() {
  if (!opening_.valid() || opening_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  auto stage = opening_.get();
  if (!stage) return say(stage.error());
  std::vector<std::string> problems = stage->problems;
  if (auto ok = show_stage(std::move(*stage), opening_options_, problems); !ok) return say(ok.error());
  say(problems.empty() ? state_.file + " opened" : problems.front(), false);
}

void Viewer::take_requests(Window& window) {
  for (const auto& file : window.take_dropped_files()) open_beside(file.string());
  take_opened();
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

Result<void> Viewer::show_frame(Window& window) {
  const PictureSize size = window.size();
  if (size.width > 0 && size.height > 0 && (size.width != size_.width || size.height != size_.height)) {
    if (auto ok = shown_->picture->resize(size); !ok) return ok;
    size_ = size;
    stale_ = true;
  }
  window.begin_interface();
  take_pointer();
  take_keys(window);
  draw_panels(document(), state_);
  take_requests(window);
  const int frame = state_.playback.shown();
  if (stale_ || frame != drawn_frame_ || !(state_.extras == drawn_extras_)) {
    state_.states = maker().pose(frame);
    drawn_extras_ = state_.extras;
    if (auto ok = shown_->picture->draw(frame, state_.states, state_.extras); !ok) return ok;
    drawn_frame_ = frame;
    stale_ = false;
  }
  return window.show(maker().renderer());
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

Result<ViewerReport> Viewer::run(Window& window) {
  set_style();
  ViewerReport report;
  std::vector<double> times;
  const Clock::time_point begun = Clock::now();
  Clock::time_point last = begun;
  int to_rest = frames_to_rest;
  const bool measured = options_.frames > 0;
  if (measured) state_.playback.playing = true;
  while (!window.is_closing() && (!measured || report.frames < options_.frames)) {
    const bool moving = state_.playback.playing || opening_.valid() || heads_.is_busy() || measured;
    window.take_events(!moving && to_rest <= 0);
    if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
    if (window.had_events()) to_rest = frames_to_rest;
    if (!moving && to_rest-- <= 0) {
      last = Clock::now();
      continue;
    }
    const PictureSize size = window.size();
    if (size.width == 0 || size.height == 0) {
      window.take_events(true, 0.1);  // minimised: nothing is seen
      continue;
    }
    if (auto ok = show_frame(window); !ok) return pass_on(std::move(ok));
    if (!options_.uncapped) {
      const double took = std::chrono::duration<double>(Clock::now() - last).count();
      if (took < capped_seconds) window.take_events(true, capped_seconds - took);
    }
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - last).count();
    last = now;
    times.push_back(1e3 * seconds);
    if (seconds > 0.0) state_.frames_a_second += 0.1 * (1.0 / seconds - state_.frames_a_second);
    // A measured run shows every frame in its turn.
    state_.playback.advance(measured ? 1.0 / document().scene().fps : std::min(seconds, 0.25), document().scene().fps);
    ++report.frames;
  }
  report.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
  report.median_ms = percentile(times, 0.5);
  report.p95_ms = percentile(std::move(times), 0.95);
  report.size = size_;
  return report;
}

}  // namespace

Result<ViewerReport> view(WindowSystem& system, Device& device, const ViewerOptions& options) {
  Viewer viewer(device, options);
  std::vector<std::string> problems;
  if (auto ok = viewer.open(options.scene, problems); !ok) return pass_on(std::move(ok));
  WindowOptions wanted{.size = options.look.size, .uncapped = options.uncapped};
  if (const auto font = Font::find_file()) wanted.font = font->string();
  auto window = Window::create(system, device, wanted);
  if (!window) return pass_on(std::move(window));
  auto report = viewer.run(*window);
  if (report) report->problems = std::move(problems);
  return report;
}

}  // namespace sinew
