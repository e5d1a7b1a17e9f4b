#include "engine/view/panels.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

constexpr float side_width = 300.0f, bar_height = 92.0f, motion_height = 320.0f;

/// A panel at a fixed place that nobody can lose, opaque.
bool begin_panel(ViewState& state, const char* name, ImVec2 at, ImVec2 size) {
  at = {std::floor(at.x), std::floor(at.y)};
  size = {std::floor(size.x), std::floor(size.y)};
  const auto left = static_cast<int>(at.x), top = static_cast<int>(at.y);
  state.docked.push_back({name, {left, top, left + static_cast<int>(size.x), top + static_cast<int>(size.y)}});
  ImGui::SetNextWindowPos(at);
  ImGui::SetNextWindowSize(size);
  return ImGui::Begin(name, nullptr,
                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                          ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoBringToFrontOnFocus);
}

/// What moves the characters, a tab a subject.
void draw_acting(const Document& document, ViewState& state) {
  if (!ImGui::BeginTabBar("acting")) return;
  if (ImGui::BeginTabItem("Pose")) {
    draw_pose(document, state);
    ImGui::EndTabItem();
  }
  if (has_face(document) && ImGui::BeginTabItem("Face")) {
    draw_face(document, state);
    ImGui::EndTabItem();
  }
  ImGui::EndTabBar();
}

void draw_help(ViewState& state) {
  if (state.help && is_escaped()) state.help = false;
  if (!state.help) return;
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  if (ImGui::Begin("Keys", &state.help, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse)) {
    static constexpr const char* keys[][2] = {{"left drag", "turn the camera"},
                                              {"right, middle or Shift drag", "move it"},
                                              {"wheel", "nearer, farther"},
                                              {"click", "choose a joint, or the bone under the skin"},
                                              {"drag a ring", "turn the joint (Shift: steps of 5 degrees)"},
                                              {"drag a diamond", "pull a hand or foot (reach)"},
                                              {"drag the line", "divide the sides of a comparison"},
                                              {"double click", "in the drawn face: a region back to rest"},
                                              {"F", "frame everything"},
                                              {".", "frame the chosen joint"},
                                              {"1  3  7", "front, the character's left, top (Ctrl: opposite)"},
                                              {"9", "three-quarter"},
                                              {"5", "perspective or parallel rays"},
                                              {"Space", "play, pause"},
                                              {"Left, Right", "a frame back, on (Shift: ten)"},
                                              {"Home, End", "first, last frame"},
                                              {"K", "key for the chosen joint at this frame"},
                                              {"Ctrl+Z, Ctrl+Y", "undo, redo (or Ctrl+Shift+Z)"},
                                              {"Ctrl+S", "save the scene"},
                                              {"Ctrl+R", "record a film"},
                                              {"Ctrl+Q", "close the window"},
                                              {"P", "save the picture without the panels"},
                                              {"M", "motions: library and curves"},
                                              {"Tab", "hide or show the panels"},
                                              {"?  F1", "this list"},
                                              {"drop a file", "open a model, motion or scene"}};
    if (ImGui::BeginTable("keys", 2)) {
      for (const auto& [key, does] : keys) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(key);
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", does);
      }
      ImGui::EndTable();
    }
  }
  ImGui::End();
}

}  // namespace

void set_style() {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0.0f;
  style.PopupRounding = 4.0f;
  style.FrameRounding = style.GrabRounding = 3.0f;
  style.WindowBorderSize = 0.0f;
  style.GrabMinSize = 6.0f;  // beside the values, not over them
  style.ItemSpacing = {8.0f, 6.0f};
  style.Colors[ImGuiCol_WindowBg] = {0.11f, 0.12f, 0.14f, 1.0f};
  style.Colors[ImGuiCol_ModalWindowDimBg] = {0.0f, 0.0f, 0.0f, 0.45f};
  style.Colors[ImGuiCol_PopupBg] = {0.13f, 0.14f, 0.16f, 1.0f};
  style.Colors[ImGuiCol_FrameBg] = {0.20f, 0.22f, 0.25f, 1.0f};
  style.Colors[ImGuiCol_CheckMark] = {0.93f, 0.55f, 0.35f, 1.0f};
  // Values are written over the grabs, in white.
  style.Colors[ImGuiCol_SliderGrab] = {0.62f, 0.34f, 0.20f, 1.0f};
  style.Colors[ImGuiCol_SliderGrabActive] = {0.74f, 0.41f, 0.24f, 1.0f};
  style.Colors[ImGuiCol_TitleBg] = style.Colors[ImGuiCol_TitleBgActive] = {0.17f, 0.19f, 0.22f, 1.0f};
  style.Colors[ImGuiCol_HeaderActive] = style.Colors[ImGuiCol_HeaderHovered] = {0.31f, 0.35f, 0.41f, 1.0f};
  style.Colors[ImGuiCol_ButtonActive] = style.Colors[ImGuiCol_ButtonHovered] = {0.31f, 0.35f, 0.41f, 1.0f};
  style.Colors[ImGuiCol_FrameBgActive] = style.Colors[ImGuiCol_FrameBgHovered] = {0.25f, 0.28f, 0.32f, 1.0f};
  style.Colors[ImGuiCol_Header] = {0.24f, 0.27f, 0.32f, 1.0f};
  style.Colors[ImGuiCol_Button] = {0.24f, 0.27f, 0.32f, 1.0f};
}

bool is_escaped() { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false); }

void show_tip(const std::string& text) {
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", text.c_str());
}

void draw_panels(const Document& document, ViewState& state) {
  draw_help(state);
  draw_leaving(state);
  draw_replacing(state);
  state.docked.clear();
  state.extras.muscle = state.kept_muscle;
  if (!state.panels) return;
  const ImVec2 whole = ImGui::GetIO().DisplaySize;
  const float height = whole.y - bar_height;
  if (begin_panel(state, "scene", {0.0f, 0.0f}, {side_width, height})) {
    draw_file(document, state);
    // What can be done with a mesh that nothing moves stands first.
    const auto& characters = document.stage().characters;
    const bool bare = state.character < characters.size() && stands_still(characters[state.character]);
    if (bare) draw_skin(document, state);
    if (ImGui::CollapsingHeader("Look", ImGuiTreeNodeFlags_DefaultOpen)) draw_look(document, state);
    if (ImGui::CollapsingHeader("Deformer", ImGuiTreeNodeFlags_DefaultOpen)) draw_deformer(document, state);
    if (ImGui::CollapsingHeader("Muscles", ImGuiTreeNodeFlags_DefaultOpen)) draw_muscles(document, state);
    if (!bare) draw_skin(document, state);
  }
  ImGui::End();
  if (begin_panel(state, "act", {whole.x - side_width, 0.0f}, {side_width, height})) draw_acting(document, state);
  ImGui::End();
  if (begin_panel(state, "time", {0.0f, whole.y - bar_height}, {whole.x, bar_height})) draw_time(document, state);
  ImGui::End();
  if (!state.motion.shown) return;
  const float tall = std::min(motion_height, 0.5f * whole.y);
  if (begin_panel(state, "motion", {side_width, height - tall}, {whole.x - 2.0f * side_width, tall}))
    draw_motion(document, state);
  ImGui::End();
}

}  // namespace sinew
