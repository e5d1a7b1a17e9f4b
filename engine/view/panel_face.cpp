#include <algorithm>
#include <array>
#include <cmath>

#include <imgui.h>

#include "engine/model/scene_words.h"
#include "engine/view/face_canvas.h"
#include "engine/view/face_sliders.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

constexpr ImU32 handle = IM_COL32(238, 140, 89, 255), handle_near = IM_COL32(255, 255, 255, 255),
                handle_edge = IM_COL32(70, 52, 46, 255), limit = IM_COL32(36, 110, 190, 255);
constexpr float handle_radius = 4.5f, handle_reach = 9.0f;

/// The character whose face is shown: the chosen one, else the first that has one.
std::optional<std::size_t> faced_character(const Document& document, const ViewState& state) {
  const std::vector<StagedCharacter>& characters = document.stage().characters;
  const auto has = [](const StagedCharacter& character) { return character.mesh.face || target_face(character); };
  if (state.character < characters.size() && has(characters[state.character])) return state.character;
  const auto found = std::ranges::find_if(characters, has);
  if (found == characters.end()) return std::nullopt;
  return static_cast<std::size_t>(found - characters.begin());
}

/// The handle under the pointer, or -1.
int near_handle(const FaceSheet& sheet, const std::vector<FaceHandle>& handles) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  int nearest = -1;
  float least = handle_reach * handle_reach;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const ImVec2 p = sheet.at(handles[i].at);
    const float squared = (p.x - mouse.x) * (p.x - mouse.x) + (p.y - mouse.y) * (p.y - mouse.y);
    if (squared < least) least = squared, nearest = static_cast<int>(i);
  }
  return nearest;
}

void draw_handles(ImDrawList& draw, const FaceSheet& sheet, const FacePicture& picture, const ShownFace& face,
                  int near) {
  if (near >= 0) {
    std::vector<ImVec2> reach = sheet.at(picture.handles[static_cast<std::size_t>(near)].reach(face));
    draw.AddPolyline(reach.data(), static_cast<int>(reach.size()), limit,
                     reach.size() > 2 ? ImDrawFlags_Closed : ImDrawFlags_None, 1.5f);
    for (const ImVec2& end : reach) draw.AddCircleFilled(end, 2.0f, limit);
  }
  for (std::size_t i = 0; i < picture.handles.size(); ++i) {
    const ImVec2 p = sheet.at(picture.handles[i].at);
    draw.AddCircleFilled(p, handle_radius, static_cast<int>(i) == near ? handle_near : handle);
    draw.AddCircle(p, handle_radius, handle_edge, 0, 1.2f);
  }
}

std::string handle_tip(const FaceHandle& handle, const ShownFace& face) {
  std::string text = handle.name;
  for (const FaceHandle::Lead& lead : handle.leads) {
    const ChannelRange range = channel_range(face, lead.channel);
    text += fmt::format("\n{}  {:.3g}  ({:.3g} to {:.3g})", channel_word(lead.channel),
                        channel(face.shown, lead.channel), range.low, range.high);
  }
  return text + "\ndouble click: back to rest";
}

void drag_handles(const Document& document, ViewState& state, std::size_t character, const FaceSheet& sheet,
                  const FacePicture& picture, const ShownFace& face, int near) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (near >= 0 && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    Scene scene = document.scene();
    for (const FaceHandle::Lead& lead : picture.handles[static_cast<std::size_t>(near)].leads)
      reset_region(scene.characters[character], lead.channel);
    state.ask(std::move(scene), std::string("rest ") + picture.handles[static_cast<std::size_t>(near)].name);
    state.face_drag.reset();
    return;
  }
  if (near >= 0 && ImGui::IsItemActivated()) {
    state.playback.playing = false;
    state.face_drag = {picture.handles[static_cast<std::size_t>(near)], face, document.scene(), {mouse.x, mouse.y}};
  }
  if (!state.face_drag) return;
  if (!ImGui::IsItemActive()) {
    state.face_drag.reset();
    state.edit_ended = true;
    return;
  }
  const ViewState::FaceDrag& drag = *state.face_drag;
  const Vec2 by = Vec2(mouse.x - drag.from.x, drag.from.y - mouse.y) / double(sheet.scale);
  if (ImGui::GetIO().MouseDelta.x == 0.0f && ImGui::GetIO().MouseDelta.y == 0.0f) return;
  Scene scene = drag.scene;
  move_channels(scene.characters[character], drag.face, state.playback.shown(), drag.handle.pulled(drag.face, by));
  state.ask(std::move(scene), std::string("move ") + drag.handle.name, std::string("face ") + drag.handle.name);
}

void draw_picture(const Document& document, ViewState& state, std::size_t character, const ShownFace& face) {
  const StagedCharacter& staged = document.stage().characters[character];
  const FacePicture picture = face_picture(face, staged.mesh.face->guides);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  // On low windows the picture leaves more than half of the panel to the sliders.
  const float width = ImGui::GetContentRegionAvail().x, most = 0.45f * ImGui::GetWindowHeight();
  const float across = static_cast<float>(face_picture_high.x - face_picture_low.x),
              down = static_cast<float>(face_picture_high.y - face_picture_low.y);
  const float scale = std::min(width / across, most / down), height = scale * down;
  const FaceSheet sheet{{corner.x + 0.5f * (width - scale * across), corner.y}, scale};
  ImGui::InvisibleButton("face picture", {width, height});
  int near = ImGui::IsItemHovered() ? near_handle(sheet, picture.handles) : -1;
  drag_handles(document, state, character, sheet, picture, face, near);
  if (state.face_drag)
    for (std::size_t i = 0; i < picture.handles.size(); ++i)
      if (picture.handles[i].name == state.face_drag->handle.name) near = static_cast<int>(i);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(corner, {corner.x + width, corner.y + height}, true);
  draw.AddRectFilled(corner, {corner.x + width, corner.y + height}, IM_COL32(52, 58, 66, 255), 4.0f);
  draw_face_lines(draw, sheet, picture);
  draw_handles(draw, sheet, picture, face, near);
  draw.PopClipRect();
  if (near >= 0) ImGui::SetTooltip("%s", handle_tip(picture.handles[static_cast<std::size_t>(near)], face).c_str());
}

void draw_lip_shares(const Document& document, ViewState& state, std::size_t character, const ShownFace& face) {
  static constexpr std::array shares{std::pair{FaceChannel::lip_pucker, "pucker"},
                                     std::pair{FaceChannel::lip_press, "press"},
                                     std::pair{FaceChannel::lip_seal, "seal"}};
  if (!ImGui::BeginTable("shares", 3, ImGuiTableFlags_SizingStretchSame)) return;
  for (const auto& [share, name] : shares) {
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::PushID(name);
    double value = channel(face.shown, share);
    if (named_slider(name, value, 0.0, 1.0, state)) {
      Scene scene = document.scene();
      move_channels(scene.characters[character], face, state.playback.shown(), std::array{ChannelGoal{share, value}});
      state.ask(std::move(scene), std::string("lips: ") + name, std::string("lips ") + name);
    }
    ImGui::PopID();
  }
  ImGui::EndTable();
}

void draw_head(const Document& document, ViewState& state, std::size_t character) {
  const Character& shown = document.scene().characters[character];
  const double frame = state.playback.shown();
  HeadSpec head = shown.head.value_or(HeadSpec{});
  if (state.wanted_head) head = *state.wanted_head;
  const auto ask = [&](const std::string& label, auto change) {
    Scene scene = document.scene();
    scene.characters[character].head = head;
    change(scene.characters[character]);
    state.ask(std::move(scene), label, label);
  };
  ImGui::BeginDisabled(!head.file.empty());
  double age = head.age.value_at(frame);
  const auto stop = static_cast<std::size_t>(std::lround(age * double(age_names().size() - 1)));
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::PushID("age");
  if (named_slider("age: " + age_names()[stop], age, 0.0, 1.0, state))
    ask("age", [&](Character& changed) { set_head_age(changed, frame, age); });
  ImGui::PopID();
  ImGui::EndDisabled();
  show_tip("0: adult, 1: infant");
  in_columns("skull", skull_names().size(), [&](std::size_t i) {
    const std::string& outline = skull_names()[i];
    const auto found = head.skull.find(outline);
    double weight = found == head.skull.end() ? 0.0 : found->second;
    if (named_slider(outline, weight, 0.0, 1.0, state))
      ask("skull " + outline, [&](Character& changed) { set_skull(changed, outline, weight); });
  });
}

}  // namespace

bool has_face(const Document& document) {
  return has_face_regions(document) ||
         std::ranges::any_of(document.stage().characters,
                             [](const StagedCharacter& character) { return target_face(character).has_value(); });
}

bool has_face_regions(const Document& document) {
  return std::ranges::any_of(document.stage().characters,
                             [](const StagedCharacter& character) { return character.mesh.face.has_value(); });
}

void draw_face(const Document& document, ViewState& state) {
  const auto character = faced_character(document, state);
  if (!character) return;
  const StagedCharacter& staged = document.stage().characters[*character];
  const double frame = state.playback.shown();
  const auto face = shown_face(staged, frame);
  if (!face) return;
  const auto ask = [&](const char* label, auto change) {
    Scene scene = document.scene();
    change(scene.characters[*character]);
    state.ask(std::move(scene), label);
  };
  if (ImGui::Button("Key here")) ask("key of the face", [&](Character& c) { add_face_key(c, *face, frame); });
  show_tip("keeps this face at this frame; change it at another frame to move it");
  ImGui::SameLine();
  if (ImGui::Button("Remove key")) ask("remove a key of the face", [&](Character& c) { remove_face_key(c, frame); });
  ImGui::SameLine();
  if (ImGui::Button("Rest")) {
    ask("rest face", [&](Character& c) {
      c.regions.clear();
      c.expressions.reset();
    });
  }
  show_tip("takes all expressions and regions away, at all frames");
  ImGui::BeginChild("face");
  if (staged.mesh.face) {
    draw_picture(document, state, *character, *face);
    draw_lip_shares(document, state, *character, *face);
    draw_expressions(document, state, *character, *face, nullptr);
  } else {
    draw_target_face(document, state, *character, *face);
  }
  if (has_drawn_head(staged.scene)) {
    ImGui::TextDisabled("%s", state.wanted_head ? "Head: drawing it ..." : "Head");
    draw_head(document, state, *character);
  }
  ImGui::EndChild();
}

}  // namespace sinew
