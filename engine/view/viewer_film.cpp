#include <utility>

#include "engine/view/panel_parts.h"
#include "engine/view/viewer_session.h"

namespace sinew {

void ViewerSession::start_recording() {
  if (recording_.running()) return;
  Recording recording;
  recording.scene = document().scene();
  recording.source = state_.file;
  recording.options = document().options();
  recording.options.frames.reset();
  recording.look = options_.look;
  // Films' encoders want even sizes.
  recording.look.size = {std::max(size_.width & ~1, 2), std::max(size_.height & ~1, 2)};
  recording.output = state_.film;
  recording.device = options_.device;
  if (std::filesystem::path(state_.film).extension() == ".png" && state_.film.find('#') == std::string::npos)
    recording.options.frames = std::vector{state_.playback.shown()};
  recorded_ = state_.film;
  const std::string name = std::filesystem::path(state_.film).filename().string();
  if (recording_.start("recording " + name, [recording](TaskWatch& watch) { return record(recording, watch); }))
    say("recording " + state_.film + " ...");
}

void ViewerSession::follow_recording() {
  if (std::exchange(state_.record, false)) start_recording();
  const auto done = recording_.take();
  state_.records = recording_.running();
  if (!done) return;
  if (*done)
    say(fmt::format("{} written: {} frames", recorded_, (*done)->frames.size()));
  else if (done->error().kind == ErrorKind::interrupted)
    say(recorded_ + ": stopped, nothing is written");
  else
    say(done->error());
}

void ViewerSession::follow_library() {
  MotionBrowser& browser = state_.motion.browser;
  browser.poll();
  const auto news = browser.take_news();
  if (!news) return;
  say(news->message, news->is_error);
  if (news->saved.empty()) return;
  state_.motion.save_as.clear();
  if (const auto edit = clip_edit(document(), state_, news->saved)) take_edit(*edit);
}

}  // namespace sinew
