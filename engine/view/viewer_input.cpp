#include <algorithm>

#include <imgui.h>

#include "engine/view/viewer_session.h"

namespace sinew {

void ViewerSession::look_from(const OrbitCamera& camera) {
  document().move_camera(camera.camera());
  stale_ = true;
}

void ViewerSession::take_pointer() {
  const ImGuiIO& io = ImGui::GetIO();
  const bool used = tools_.work(document(), state_, maker().shot(state_.playback.shown()).viewpoint);
  // Over a handle the wheel still zooms; while one is dragged the camera stands still.
  if (used && (io.MouseWheel == 0.0f || ImGui::IsMouseDown(ImGuiMouseButton_Left))) return;
  if (io.WantCaptureMouse) return;
  const double height = std::max(1, state_.picture.bottom - state_.picture.top);
  OrbitCamera camera = OrbitCamera::of(maker(), state_.playback.shown(), aspect());
  const double across = io.MouseDelta.x / height, down = io.MouseDelta.y / height;
  bool moved = io.MouseWheel != 0.0f;
  if (moved) camera.zoom(io.MouseWheel);
  if (across != 0.0 || down != 0.0) {
    // What the pointer went in the frame of the press it went before it.
    const auto held = [&](ImGuiMouseButton button) {
      return io.MouseDown[button] && io.MouseDownDuration[button] > 0.0f;
    };
    const bool pans =
        held(ImGuiMouseButton_Right) || held(ImGuiMouseButton_Middle) || (held(ImGuiMouseButton_Left) && io.KeyShift);
    if (pans) {
      camera.pan(across, down);
      moved = true;
    } else if (held(ImGuiMouseButton_Left)) {
      camera.orbit(across, down);
      moved = true;
    }
  }
  if (moved) look_from(camera);
}

void ViewerSession::take_keys(Window& window) {
  for (const KeyPress& press : window.take_key_presses()) take_key(press, window);
}

void ViewerSession::take_key(const KeyPress& press, Window& window) {
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
    case KeyboardKey::m:
      state_.motion.shown = !state_.motion.shown;
      break;
    case KeyboardKey::p:
      state_.screenshot = true;
      break;
    case KeyboardKey::q:
      if (press.control) window.close();
      break;
    case KeyboardKey::r:
      state_.record = state_.record || press.control;
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
      state_.toggle_projection = true;
      break;
    case KeyboardKey::nine:
      state_.view = View::three_quarter;
      break;
    case KeyboardKey::seven:
      state_.view = View::top;
      break;
    case KeyboardKey::period:
      state_.frame_joint = true;
      break;
    case KeyboardKey::space:
      if (!playback.toggle()) say(nothing_to_play);
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

}  // namespace sinew
