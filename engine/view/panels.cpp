#include "engine/view/panels.h"

#include <algorithm>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "engine/model/scene_words.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

constexpr float side_width = 300.0f, bar_height = 92.0f, gap = 8.0f;

/// A panel at a fixed place that nobody can lose.
bool begin_panel(const char* name, ImVec2 at, ImVec2 size) {
  ImGui::SetNextWindowPos(at);
  ImGui::SetNextWindowSize(size);
  return ImGui::Begin(name, nullptr,
                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                          ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoBringToFrontOnFocus);
}

void draw_file_section(const Document& document, ViewState& state) {
  ImGui::TextWrapped("%s%s", state.file.c_str(), document.is_changed() ? " *" : "");
  const Stage& stage = document.stage();
  ImGui::TextDisabled("%zu vertices, %zu triangles", stage.vertices(), stage.triangles());
  ImGui::BeginDisabled(!document.can_undo());
  if (ImGui::Button("Undo")) state.undo = true;
  ImGui::EndDisabled();
  show_tip(document.can_undo() ? "Ctrl+Z: " + document.undo_label() : "nothing to undo");
  ImGui::SameLine();
  ImGui::BeginDisabled(!document.can_redo());
  if (ImGui::Button("Redo")) state.redo = true;
  ImGui::EndDisabled();
  show_tip(document.can_redo() ? "Ctrl+Y: " + document.redo_label() : "nothing to redo");
  ImGui::SameLine();
  if (ImGui::Button("Copy command")) state.copy_command = true;
  show_tip("the sinew render command that makes this picture");
  ImGui::SetNextItemWidth(-110.0f);
  ImGui::InputText("##save_as", &state.save_as);
  ImGui::SameLine();
  if (ImGui::Button("Save")) state.save = true;
  show_tip("Ctrl+S: writes the scene file");
  ImGui::SameLine();
  if (ImGui::Button("Photo")) state.screenshot = true;
  show_tip("P: the picture without the panels, as PNG beside the scene");
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
  if (!state.help) return;
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  if (ImGui::Begin("Keys", &state.help, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse)) {
    static constexpr const char* keys[][2] = {{"left drag", "turn the camera"},
                                              {"right or middle drag", "move it"},
                                              {"wheel", "nearer, farther"},
                                              {"click", "choose a joint, or the bone under the skin"},
                                              {"drag a ring", "turn the joint (Shift: steps of 5 degrees)"},
                                              {"drag a diamond", "pull a hand or foot (reach)"},
                                              {"F", "frame everything"},
                                              {"1  3  7", "front, the character's left, top (Ctrl: opposite)"},
                                              {"5", "three-quarter"},
                                              {"Space", "play, pause"},
                                              {"Left, Right", "a frame back, on (Shift: ten)"},
                                              {"Home, End", "first, last frame"},
                                              {"K", "key for the chosen joint at this frame"},
                                              {"Ctrl+Z, Ctrl+Y", "undo, redo"},
                                              {"Ctrl+S", "save the scene"},
                                              {"P", "save the picture"},
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
  style.WindowRounding = 6.0f;
  style.FrameRounding = style.GrabRounding = 3.0f;
  style.WindowBorderSize = 0.0f;
  style.GrabMinSize = 6.0f;  // beside the values, not over them
  style.ItemSpacing = {8.0f, 6.0f};
  style.Colors[ImGuiCol_WindowBg] = {0.11f, 0.12f, 0.14f, 0.90f};
  style.Colors[ImGuiCol_FrameBg] = {0.20f, 0.22f, 0.25f, 1.0f};
  style.Colors[ImGuiCol_SliderGrab] = style.Colors[ImGuiCol_CheckMark] = {0.93f, 0.55f, 0.35f, 1.0f};
  style.Colors[ImGuiCol_SliderGrabActive] = {1.0f, 0.65f, 0.45f, 1.0f};
  style.Colors[ImGuiCol_Header] = {0.24f, 0.27f, 0.32f, 1.0f};
  style.Colors[ImGuiCol_Button] = {0.24f, 0.27f, 0.32f, 1.0f};
}

void show_tip(const std::string& text) {
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", text.c_str());
}

void draw_panels(const Document& document, ViewState& state) {
  draw_help(state);
  state.extras.muscle = state.kept_muscle;
  if (!state.panels) return;
  const ImVec2 whole = ImGui::GetIO().DisplaySize;
  const float height = whole.y - bar_height - 3.0f * gap;
  if (begin_panel("scene", {gap, gap}, {side_width, height})) {
    draw_file_section(document, state);
    if (ImGui::CollapsingHeader("Look", ImGuiTreeNodeFlags_DefaultOpen)) draw_look(document, state);
    if (ImGui::CollapsingHeader("Deformer", ImGuiTreeNodeFlags_DefaultOpen)) draw_deformer(document, state);
    if (ImGui::CollapsingHeader("Muscles", ImGuiTreeNodeFlags_DefaultOpen)) draw_muscles(document, state);
  }
  ImGui::End();
  if (begin_panel("act", {whole.x - side_width - gap, gap}, {side_width, height})) draw_acting(document, state);
  ImGui::End();
  if (begin_panel("time", {gap, whole.y - bar_height - gap}, {whole.x - 2.0f * gap, bar_height}))
    draw_time(document, state);
  ImGui::End();
}

}  // namespace sinew
