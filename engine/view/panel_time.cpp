#include <set>

#include <imgui.h>

#include "engine/view/fitted_text.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

/// Frames at which anything of the scene has a key.
std::set<double> key_frames(const Scene& scene) {
  std::set<double> frames;
  const auto add = [&](const auto& keyed) {
    if (!keyed.is_constant())
      for (const auto& key : keyed.keys) frames.insert(key.frame);
  };
  for (const Character& character : scene.characters) {
    add(character.position);
    add(character.turn);
    for (const auto& [joint, track] : character.keys) add(track);
    for (const auto& [region, track] : character.regions) add(track);
    if (character.expressions) add(*character.expressions);
  }
  return frames;
}

/// The wide bar: drag to go to a frame, ticks where keys are.
void draw_bar(const Document& document, Playback& playback) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, 26.0f);
  ImGui::InvisibleButton("bar", size);
  const double first = playback.range.first, length = std::max(1, playback.range.last - playback.range.first);
  if (ImGui::IsItemActive()) {
    playback.playing = false;
    playback.go_to(std::round(first + length * std::clamp((ImGui::GetIO().MousePos.x - at.x) / size.x, 0.0f, 1.0f)));
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto x_of = [&](double frame) { return at.x + size.x * static_cast<float>((frame - first) / length); };
  draw.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg), 3.0f);
  for (const double frame : key_frames(document.scene())) {
    if (frame < first || frame > first + length) continue;
    draw.AddRectFilled({x_of(frame) - 1.5f, at.y + 4.0f}, {x_of(frame) + 1.5f, at.y + size.y - 4.0f},
                       ImGui::GetColorU32(ImVec4(0.95f, 0.80f, 0.35f, 1.0f)));
  }
  const float now = x_of(playback.shown());
  draw.AddRectFilled({now - 2.0f, at.y}, {now + 2.0f, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_CheckMark), 2.0f);
}

}  // namespace

void draw_time(const Document& document, ViewState& state) {
  Playback& playback = state.playback;
  draw_bar(document, playback);
  if (ImGui::Button("|<")) playback.go_to(playback.range.first);
  ImGui::SameLine();
  if (ImGui::Button("<")) playback.go_to(playback.shown() - 1), playback.playing = false;
  ImGui::SameLine();
  if (ImGui::Button(playback.playing ? "Pause" : "Play", {70.0f, 0.0f}) && !playback.toggle()) {
    state.message = nothing_to_play;
    state.is_error = false;
  }
  ImGui::SameLine();
  if (ImGui::Button(">")) playback.go_to(playback.shown() + 1), playback.playing = false;
  ImGui::SameLine();
  if (ImGui::Button(">|")) playback.go_to(playback.range.last);
  ImGui::SameLine();
  ImGui::Text("frame %d of %d to %d", playback.shown(), playback.range.first, playback.range.last);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(110.0f);
  int repeat = static_cast<int>(playback.repeat);
  if (ImGui::Combo("##repeat", &repeat, "once\0loop\0ping-pong\0")) playback.repeat = static_cast<Repeat>(repeat);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(110.0f);
  float speed = static_cast<float>(playback.speed);
  if (ImGui::SliderFloat("speed", &speed, 0.1f, 4.0f, "%.2f x", ImGuiSliderFlags_Logarithmic)) playback.speed = speed;
  ImGui::SameLine();
  ImGui::Checkbox("motions", &state.motion.shown);
  show_tip("M: the motion library, and curves of joints' angles");

  const std::string device = fmt::format("{:.0f} frames/s   {}   ? for keys", state.frames_a_second, state.device);
  const float width = ImGui::CalcTextSize(device.c_str()).x;
  const ImVec4 ink =
      state.is_error ? ImVec4(1.0f, 0.55f, 0.45f, 1.0f) : ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
  ImGui::PushStyleColor(ImGuiCol_Text, ink);
  const float room = ImGui::GetContentRegionAvail().x - width - 2.0f * ImGui::GetStyle().ItemSpacing.x;
  draw_fitted_text(state.message, FittedEnd::first, room);
  ImGui::PopStyleColor();
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
  ImGui::TextDisabled("%s", device.c_str());
}

}  // namespace sinew
