#include <algorithm>
#include <array>
#include <cmath>

#include <imgui.h>

#include "engine/model/scene_words.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

constexpr ImU32 paper = IM_COL32(233, 222, 205, 255), line = IM_COL32(70, 52, 46, 255),
                lips = IM_COL32(196, 110, 104, 255), mouth = IM_COL32(92, 36, 40, 255), white = IM_COL32_WHITE,
                iris = IM_COL32(74, 104, 128, 255), hair = IM_COL32(92, 66, 52, 255),
                handle = IM_COL32(238, 140, 89, 255), handle_near = IM_COL32(255, 255, 255, 255),
                limit = IM_COL32(36, 110, 190, 255);
constexpr float handle_radius = 4.5f, handle_reach = 9.0f;

/// The character whose face is shown: the chosen one, else the first that has one.
std::optional<std::size_t> faced_character(const Document& document, const ViewState& state) {
  const std::vector<StagedCharacter>& characters = document.stage().characters;
  const auto has = [](const StagedCharacter& character) { return character.mesh.face.has_value(); };
  if (state.character < characters.size() && has(characters[state.character])) return state.character;
  const auto found = std::ranges::find_if(characters, has);
  if (found == characters.end()) return std::nullopt;
  return static_cast<std::size_t>(found - characters.begin());
}

/// From drawing units to pixels.
struct Sheet {
  ImVec2 corner;  ///< upper left
  float scale;

  ImVec2 at(const Vec2& p) const {
    return {corner.x + scale * static_cast<float>(p.x - face_picture_low.x),
            corner.y + scale * static_cast<float>(face_picture_high.y - p.y)};
  }
  std::vector<ImVec2> at(const std::vector<Vec2>& points) const {
    std::vector<ImVec2> out;
    for (const Vec2& p : points) out.push_back(at(p));
    return out;
  }
};

void stroke(ImDrawList& draw, const std::vector<ImVec2>& points, ImU32 colour, float width, bool closed = false) {
  draw.AddPolyline(points.data(), static_cast<int>(points.size()), colour,
                   closed ? ImDrawFlags_Closed : ImDrawFlags_None, width);
}

/// Fills the area between two lines that run the same way.
void fill_between(ImDrawList& draw, const std::vector<ImVec2>& upper, const std::vector<ImVec2>& lower, ImU32 colour) {
  for (std::size_t i = 0; i + 1 < std::min(upper.size(), lower.size()); ++i)
    draw.AddQuadFilled(upper[i], upper[i + 1], lower[i + 1], lower[i], colour);
}

void draw_eye(ImDrawList& draw, const Sheet& sheet, const FacePicture::Eye& eye) {
  const std::vector<ImVec2> upper = sheet.at(eye.upper), lower = sheet.at(eye.lower);
  fill_between(draw, upper, lower, white);
  // The iris between the lids.
  const ImVec2 centre = sheet.at(eye.iris);
  const float r = sheet.scale * static_cast<float>(eye.iris_radius);
  const auto lid_at = [](const std::vector<ImVec2>& lid, float x) {
    for (std::size_t i = 0; i + 1 < lid.size(); ++i)
      if (x <= lid[i + 1].x) {
        const float t = std::clamp((x - lid[i].x) / std::max(lid[i + 1].x - lid[i].x, 1e-3f), 0.0f, 1.0f);
        return lid[i].y + t * (lid[i + 1].y - lid[i].y);
      }
    return lid.back().y;
  };
  std::vector<ImVec2> top, bottom;
  for (int i = -8; i <= 8; ++i) {
    const float x = centre.x + r * static_cast<float>(i) / 8.0f,
                half = std::sqrt(std::max(0.0f, r * r - (x - centre.x) * (x - centre.x)));
    const float over = lid_at(upper, x), under = std::max(lid_at(lower, x), over);
    top.emplace_back(x, std::clamp(centre.y - half, over, under));
    bottom.emplace_back(x, std::clamp(centre.y + half, over, under));
  }
  fill_between(draw, top, bottom, iris);
  stroke(draw, lower, line, 1.2f);
  stroke(draw, upper, line, 2.2f);
}

void draw_lines(ImDrawList& draw, const Sheet& sheet, const FacePicture& picture) {
  const std::vector<ImVec2> outline = sheet.at(picture.outline);
  const ImVec2 high_left(outline.front().x, sheet.corner.y), high_right(outline.back().x, sheet.corner.y);
  // The outline is convex, with the open top closed above the picture's edge.
  std::vector<ImVec2> skin = outline;
  skin.push_back(high_right);
  skin.push_back(high_left);
  draw.AddConvexPolyFilled(skin.data(), static_cast<int>(skin.size()), paper);
  stroke(draw, outline, line, 1.5f);
  for (const FacePicture::Eye& eye : picture.eyes) draw_eye(draw, sheet, eye);
  for (const std::vector<Vec2>& brow : picture.brows) {
    // Outlines of brows run along one edge and back along the other.
    const std::vector<ImVec2> points = sheet.at(brow);
    for (std::size_t i = 0, n = points.size(); i + 1 < n / 2; ++i)
      draw.AddQuadFilled(points[i], points[i + 1], points[n - 2 - i], points[n - 1 - i], hair);
    stroke(draw, points, hair, 1.5f, true);
  }
  stroke(draw, sheet.at(picture.nose), line, 1.3f);
  const std::vector<ImVec2> outer = sheet.at(picture.lip_outer), inner = sheet.at(picture.lip_inner);
  const auto halves = [](const std::vector<ImVec2>& closed) {
    const auto half = static_cast<std::ptrdiff_t>(closed.size() / 2);
    std::pair<std::vector<ImVec2>, std::vector<ImVec2>> out{{closed.begin(), closed.begin() + half + 1},
                                                            {closed.begin() + half, closed.end()}};
    out.second.push_back(closed.front());
    std::ranges::reverse(out.second);
    return out;
  };
  const auto [outer_top, outer_bottom] = halves(outer);
  const auto [inner_top, inner_bottom] = halves(inner);
  fill_between(draw, outer_top, outer_bottom, lips);
  fill_between(draw, inner_top, inner_bottom, mouth);
  stroke(draw, outer, line, 1.0f, true);
  stroke(draw, inner, line, 1.2f, true);
}

/// The handle under the pointer, or -1.
int near_handle(const Sheet& sheet, const std::vector<FaceHandle>& handles) {
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

void draw_handles(ImDrawList& draw, const Sheet& sheet, const FacePicture& picture, const ShownFace& face, int near) {
  if (near >= 0) {
    std::vector<ImVec2> reach = sheet.at(picture.handles[static_cast<std::size_t>(near)].reach(face));
    stroke(draw, reach, limit, 1.5f, reach.size() > 2);
    for (const ImVec2& end : reach) draw.AddCircleFilled(end, 2.0f, limit);
  }
  for (std::size_t i = 0; i < picture.handles.size(); ++i) {
    const ImVec2 p = sheet.at(picture.handles[i].at);
    draw.AddCircleFilled(p, handle_radius, static_cast<int>(i) == near ? handle_near : handle);
    draw.AddCircle(p, handle_radius, line, 0, 1.2f);
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

void drag_handles(const Document& document, ViewState& state, std::size_t character, const Sheet& sheet,
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
  const float width = ImGui::GetContentRegionAvail().x;
  const float scale = width / static_cast<float>(face_picture_high.x - face_picture_low.x);
  const float height = scale * static_cast<float>(face_picture_high.y - face_picture_low.y);
  const Sheet sheet{corner, scale};
  ImGui::InvisibleButton("face picture", {width, height});
  int near = ImGui::IsItemHovered() ? near_handle(sheet, picture.handles) : -1;
  drag_handles(document, state, character, sheet, picture, face, near);
  if (state.face_drag)
    for (std::size_t i = 0; i < picture.handles.size(); ++i)
      if (picture.handles[i].name == state.face_drag->handle.name) near = static_cast<int>(i);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(corner, {corner.x + width, corner.y + height}, true);
  draw.AddRectFilled(corner, {corner.x + width, corner.y + height}, IM_COL32(52, 58, 66, 255), 4.0f);
  draw_lines(draw, sheet, picture);
  draw_handles(draw, sheet, picture, face, near);
  draw.PopClipRect();
  if (near >= 0) ImGui::SetTooltip("%s", handle_tip(picture.handles[static_cast<std::size_t>(near)], face).c_str());
}

/// Sliders in two columns: `draw(i)` makes the slider of each.
template <class Draw>
void in_columns(const char* id, std::size_t count, Draw draw) {
  if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingStretchSame)) return;
  for (std::size_t i = 0; i < count; ++i) {
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::PushID(static_cast<int>(i));
    draw(i);
    ImGui::PopID();
  }
  ImGui::EndTable();
}

/// A slider with its name inside; true while it is moved.
bool named_slider(const std::string& name, double& value, double low, double high, ViewState& state) {
  float shown = static_cast<float>(value);
  const std::string format = name + "  %.2f";
  const bool moved = ImGui::SliderFloat("##value", &shown, static_cast<float>(low), static_cast<float>(high),
                                        format.c_str(), ImGuiSliderFlags_AlwaysClamp);
  if (ImGui::IsItemDeactivatedAfterEdit()) state.edit_ended = true;
  // What a float shows as two decimals is meant so.
  if (moved) value = std::round(1000.0 * static_cast<double>(shown)) / 1000.0;
  return moved;
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

void draw_expressions(const Document& document, ViewState& state, std::size_t character, const ShownFace& face) {
  const auto names = expression_names();
  in_columns("expressions", names.size() - 1, [&](std::size_t i) {
    double strength = face.strengths[i + 1];
    if (!named_slider(names[i + 1], strength, 0.0, most_expression_strength, state)) return;
    Scene scene = document.scene();
    set_expression(scene.characters[character], state.playback.shown(), static_cast<Expression>(i + 1), strength);
    state.ask(std::move(scene), names[i + 1], "expression " + names[i + 1]);
  });
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
  if (named_slider("age  " + age_names()[stop], age, 0.0, 1.0, state))
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
  draw_picture(document, state, *character, *face);
  draw_lip_shares(document, state, *character, *face);
  ImGui::TextDisabled("Expressions: one at each key, 1 is whole");
  draw_expressions(document, state, *character, *face);
  if (has_drawn_head(staged.scene)) {
    ImGui::TextDisabled("%s", state.wanted_head ? "Head: drawing it ..." : "Head");
    draw_head(document, state, *character);
  }
  ImGui::EndChild();
}

}  // namespace sinew
