#include "engine/view/viewer.h"

#include <chrono>
#include <cmath>

#include <spdlog/spdlog.h>

#include "engine/core/interrupt.h"
#include "engine/model/scene_words.h"
#include "engine/render/text.h"
#include "engine/view/display_loss.h"
#include "engine/view/viewer_session.h"

namespace sinew {
namespace {

using Clock = std::chrono::steady_clock;

/// The interface needs some frames after the last event to come to rest: what fades takes a sixth of a second.
constexpr int frames_to_rest = 12;
constexpr double capped_seconds = 1.0 / 60.0;
/// Before a measured run: devices make shaders ready when they first draw.
constexpr int warming_frames = 3;
/// Between two looks at what runs beside the window; and, where nothing does, at the file that is shown.
constexpr double progress_seconds = 0.05, idle_seconds = 0.5;

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

Result<void> ViewerSession::make_pictures(Shown& shown, std::vector<std::string>& problems) {
  LookOptions look = options_.look;
  look.size = seen_;
  look.for_window = true;
  // What the scene says is edited here; only what it cannot say comes from the command line.
  auto made = WindowPicture::create(device_, shown.document, look, problems);
  if (!made) return pass_on(std::move(made));
  shown.picture.emplace(std::move(*made));
  state_.compared = {shown.picture->left_label(), shown.picture->right_label()};
  return {};
}

Result<void> ViewerSession::open(const SceneOptions& scene, std::vector<std::string>& problems) {
  size_ = seen_ = options_.look.size;
  auto stage = open_stage(scene);
  if (!stage) return pass_on(std::move(stage));
  problems.insert(problems.end(), stage->problems.begin(), stage->problems.end());
  stage->bounds = stage_bounds(*stage);
  if (auto ok = show_stage(std::move(*stage), scene, problems); !ok) return ok;
  if (const std::string unbound = without_skin(); !unbound.empty()) say(unbound);
  return {};
}

Result<void> ViewerSession::show_stage(Stage stage, const SceneOptions& scene, std::vector<std::string>& problems) {
  auto document = Document::create(std::move(stage), scene);
  if (!document) return pass_on(std::move(document));
  auto shown = std::make_unique<Shown>(std::move(*document));
  if (auto ok = make_pictures(*shown, problems); !ok) return ok;
  edits_.drop();
  shown_ = std::move(shown);
  // What was being dragged, asked for or singled out belongs to what was shown before.
  tools_ = {};
  state_.face_drag.reset();
  state_.wanted_head.reset();
  state_.kept_muscle.reset();
  state_.edit.reset();
  state_.motion.drag.reset();
  state_.file = scene.scene.empty() ? "the embedded scene" : scene.scene;
  const bool of_file = is_scene_file(scene.scene);
  state_.save_as = of_file ? scene.scene : "scene.json";
  own_file_ = of_file ? scene.scene : "";
  state_.film = std::filesystem::path(state_.save_as).replace_extension(".mp4").string();
  disk_.watch(of_file ? scene.scene : "");
  state_.changed_on_disk = bounds_stale_ = false;
  camera_in_file_ = this->document().scene().camera;
  if (!scene.scene.empty() && !is_built_in_model(scene.scene)) remember(scene.scene);
  state_.joint.clear();
  state_.character = 0;
  state_.playback = {};
  state_.playback.set_range(this->document().stage().range);
  state_.playback.go_to(state_.playback.range.first);
  stale_ = true;
  return {};
}

Result<void> ViewerSession::follow(Touched what) {
  stale_ = true;
  state_.playback.set_range(document().stage().range);
  if (what == Touched::muscles) return shown_->picture->follow_muscles();
  bounds_stale_ = bounds_stale_ || what != Touched::look;
  if (what != Touched::all) return {};
  std::vector<std::string> problems;
  return make_pictures(*shown_, problems);
}

Result<void> ViewerSession::show_frame(Window& window) {
  size_ = window.size();
  window.begin_interface();
  take_pointer();
  take_keys(window);
  draw_panels(document(), state_);
  draw_works(works(), state_);
  take_requests(window);
  const PixelBox place = picture_place(window.pixels_per_unit());
  if (auto ok = fit_picture({place.right - place.left, place.bottom - place.top}); !ok) return ok;
  const int frame = state_.playback.shown();
  // A measured run draws what it shows, every time.
  if (stale_ || frame != drawn_frame_ || !(state_.extras == drawn_extras_) || options_.frames > 0) {
    state_.states = maker().pose(frame);
    if (auto ok = shown_->picture->draw(frame, state_.states, state_.extras); !ok) return ok;
    drawn_frame_ = frame;
    drawn_extras_ = state_.extras;
    stale_ = false;
  }
  return window.show(maker().renderer(), place.left, place.top, state_.docked);
}

PixelBox ViewerSession::picture_place(double pixels_per_unit) {
  const auto units = [&](int pixels) { return static_cast<int>(std::lround(pixels / pixels_per_unit)); };
  state_.picture = uncovered(units(size_.width), units(size_.height), state_.docked);
  // Panels lie over whatever part of a pixel they have.
  const auto low = [&](int unit) { return static_cast<int>(std::floor(unit * pixels_per_unit)); };
  const auto high = [&](int unit) { return static_cast<int>(std::ceil(unit * pixels_per_unit)); };
  return {low(state_.picture.left), low(state_.picture.top), std::min(high(state_.picture.right), size_.width),
          std::min(high(state_.picture.bottom), size_.height)};
}

Result<void> ViewerSession::fit_picture(const PictureSize& size) {
  if (size.width <= 0 || size.height <= 0 || size == seen_) return {};
  if (auto ok = shown_->picture->resize(size); !ok) return ok;
  seen_ = size;
  stale_ = true;
  return {};
}

Result<ViewerReport> ViewerSession::run(Window& window) {
  set_style();
  ViewerReport report;
  std::vector<double> times;
  Clock::time_point begun = Clock::now(), last = begun;
  int to_rest = frames_to_rest;
  const bool measured = options_.frames > 0;
  if (measured) state_.playback.playing = true;
  for (int i = 0; measured && i < warming_frames; ++i)
    if (auto ok = show_frame(window); !ok) return pass_on(std::move(ok));
  begun = last = Clock::now();
  while ((!window.is_closing() || !may_close(window)) && (!measured || report.frames < options_.frames)) {
    const bool moving = state_.playback.playing || measured, works = works_beside();
    window.take_events(!moving && to_rest <= 0, works ? progress_seconds : idle_seconds);
    if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
    if (window.had_events()) to_rest = frames_to_rest;
    if (works || follow_disk()) to_rest = frames_to_rest;
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
  if (!measured) keep_preferences(window);
  report.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
  report.median_ms = percentile(times, 0.5);
  report.p95_ms = percentile(std::move(times), 0.95);
  report.size = size_;
  return report;
}

Result<ViewerReport> view(WindowSystem& system, Device& device, const ViewerOptions& asked) {
  ViewerOptions options = asked;
  std::vector<std::string> problems;
  Preferences preferences;
  std::filesystem::path file;
  // A measured run is the same on every machine.
  if (options.frames == 0) {
    auto kept = load_preferences(preferences_file());
    if (kept) {
      preferences = std::move(*kept);
      file = preferences_file();
    } else {
      problems.push_back(kept.error().message + "; it is left as it is, and the usual settings are used");
    }
    if (!options.size_given) options.look.size = preferences.window;
  }
  ViewerSession session(device, options);
  session.go_on_from(preferences, file);
  if (auto ok = session.open(options.scene, problems); !ok) return pass_on(std::move(ok));
  if (!problems.empty()) session.tell(problems.front());
  WindowOptions wanted{.size = options.look.size, .in_units = options.frames == 0, .uncapped = options.uncapped};
  if (const auto font = Font::find_file()) wanted.font = font->string();
  auto window = Window::create(system, device, wanted);
  if (!window) return pass_on(std::move(window));
  const DisplayLoss display_loss([&] {
    spdlog::error("the connection to the display broke");
    session.rescue();
  });
  auto report = session.run(*window);
  if (report)
    report->problems = std::move(problems);
  else
    session.rescue();
  return report;
}

}  // namespace sinew
