#include "engine/view/picture_tools.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <imgui.h>

namespace sinew {
namespace {

constexpr double gizmo_pixels = 76.0, ring_reach = 7.0, joint_reach = 10.0, handle_reach = 11.0, divider_reach = 6.0;
/// A click may wander so far.
constexpr double click_pixels = 4.0;
constexpr std::array<ImU32, 3> ring_colours{IM_COL32(226, 84, 76, 255), IM_COL32(92, 176, 88, 255),
                                            IM_COL32(82, 136, 240, 255)};
constexpr ImU32 bright = IM_COL32(255, 226, 120, 255), ink = IM_COL32(26, 34, 43, 220),
                orange = IM_COL32(238, 140, 89, 255);
constexpr std::array ends{HumanoidBone::left_hand, HumanoidBone::right_hand, HumanoidBone::left_foot,
                          HumanoidBone::right_foot};

/// White on a dark plate.
void write_at(const ImVec2& corner, const std::string& text) {
  constexpr float pad = 6.0f;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  draw.AddRectFilled({corner.x - pad, corner.y - 0.5f * pad}, {corner.x + size.x + pad, corner.y + size.y + 0.5f * pad},
                     ink, 4.0f);
  draw.AddText(corner, IM_COL32_WHITE, text.c_str());
}

void write_beside(const ImVec2& at, const std::string& text) {
  write_at({at.x + 12.0f, at.y - ImGui::CalcTextSize(text.c_str()).y - 6.0f}, text);
}

std::optional<JointLimits> limits_of(const StagedCharacter& character, int node) {
  return joint_limits(*character.model, character.humanoid, character.rest.global, node);
}

}  // namespace

ImVec2 PictureTools::Sight::in_window(const Vec2& p) const {
  return {static_cast<float>(corner.x + p.x), static_cast<float>(corner.y + p.y)};
}

void PictureTools::Sight::stroke(const std::vector<Vec2>& line, unsigned colour, float width) const {
  std::vector<ImVec2> points;
  for (const Vec2& p : line) points.push_back(in_window(p));
  ImGui::GetBackgroundDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, width);
}

bool PictureTools::work(const Document& document, ViewState& state, const Viewpoint& viewpoint) {
  const ImGuiIO& io = ImGui::GetIO();
  const PixelBox& place = state.picture;
  if (place.empty()) return false;
  const int width = place.right - place.left, height = place.bottom - place.top;
  const Vec2 corner(place.left, place.top);
  Sight sight{viewpoint,
              Vec2(width, height),
              Screen(viewpoint, width, height),
              Vec2(io.MousePos.x, io.MousePos.y) - corner,
              !io.WantCaptureMouse,
              corner};
  // Before the first picture, and after characters came or went, there is nothing to touch yet.
  if (state.states.size() != document.stage().characters.size()) return false;
  // All are drawn; the one that the pointer is on keeps it from the others.
  bool used = divide(state, sight);
  sight.free = sight.free && !used;
  used = pull(document, state, sight) || used;
  sight.free = sight.free && !used;
  used = turn(document, state, sight) || used;
  if (used) {
    pressed_.reset();
    return true;
  }
  pick(document, state, sight);
  return false;
}

bool PictureTools::divide(ViewState& state, const Sight& sight) {
  if (state.compared[0].empty()) return dividing_ = false;
  const double x = state.extras.divider * sight.size.x;
  const bool near = sight.free && !turning_ && !pulling_ && std::abs(sight.pointer.x - x) < divider_reach;
  if (near && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) dividing_ = true;
  dividing_ = dividing_ && ImGui::IsMouseDown(ImGuiMouseButton_Left);
  if (dividing_) state.extras.divider = std::clamp(sight.pointer.x / sight.size.x, 0.02, 0.98);
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const ImVec2 top = sight.in_window({state.extras.divider * sight.size.x, 0.0});
  const ImVec2 bottom = sight.in_window({state.extras.divider * sight.size.x, sight.size.y});
  draw.AddLine(top, bottom, ink, 4.0f);
  draw.AddLine(top, bottom, near || dividing_ ? bright : IM_COL32_WHITE, 2.0f);
  constexpr float away = 14.0f;
  write_at({top.x - ImGui::CalcTextSize(state.compared[0].c_str()).x - away, top.y + away}, state.compared[0]);
  write_at({top.x + away, top.y + away}, state.compared[1]);
  return near || dividing_;
}

bool PictureTools::turn(const Document& document, ViewState& state, const Sight& sight) {
  if (state.joint.empty() || !state.gizmo || state.character >= state.states.size()) {
    turning_.reset();
    return false;
  }
  const Stage& stage = document.stage();
  const StagedCharacter& character = stage.characters[state.character];
  const auto node = find_joint(*character.model, character.humanoid, state.joint);
  if (!node) return false;
  const double frame = state.playback.shown();
  const JointStand stand =
      joint_stand(stage, state.character, state.states[state.character], *node, state.joint, frame);
  const auto centre = sight.screen.point(stand.joint.place);
  if (!centre) return false;
  const Gizmo gizmo = make_gizmo(stand, sight.viewpoint, sight.size.y, gizmo_pixels);
  int near = sight.free ? ring_near(gizmo, sight.screen, sight.pointer, ring_reach) : -1;
  if (!turning_ && near >= 0 && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    const auto limits = limits_of(character, *node);
    const DegreeRange range = limits ? number_range(*limits, stand.degrees, near) : DegreeRange{-360.0, 360.0};
    turning_ = {RingDrag(gizmo, near, sight.viewpoint, sight.size, sight.pointer), document.scene(), stand.degrees,
                range};
    state.playback.playing = false;
  }
  if (turning_) {
    near = turning_->drag.ring();
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
      turning_.reset();
      state.edit_ended = true;
    } else if (ImGui::GetIO().MouseDelta.x != 0.0f || ImGui::GetIO().MouseDelta.y != 0.0f) {
      Vec3 degrees = turning_->degrees;
      const double by = turning_->drag.follow(sight.pointer);
      // A tenth of a degree is finer than anyone drags, and reads well in a file.
      const double number = turned_number(degrees[near], by, turning_->range, ImGui::GetIO().KeyShift);
      degrees[near] = std::round(10.0 * number) / 10.0;
      Scene scene = turning_->scene;
      set_joint_degrees(scene.characters[state.character], state.joint, frame, degrees);
      state.ask(std::move(scene), "turn " + state.joint, "turn " + state.joint);
    }
  }
  for (int ring = 0; ring < 3; ++ring) {
    const RingLines lines = ring_lines(gizmo, ring, sight.screen);
    const ImU32 colour = ring_colours[static_cast<std::size_t>(ring)];
    sight.stroke(lines.whole, (colour & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 60), 1.5f);
    sight.stroke(lines.front, ring == near ? bright : colour, ring == near ? 4.0f : 2.5f);
  }
  ImGui::GetBackgroundDrawList()->AddCircleFilled(sight.in_window(centre->at), 4.0f, bright);
  if (turning_)
    write_beside(sight.in_window(sight.pointer), fmt::format("{} {:.1f}\u00b0", "xyz"[near], stand.degrees[near]));
  return turning_ || near >= 0;
}

std::vector<PictureTools::Handle> PictureTools::handles(const Document& document, const ViewState& state,
                                                        const Sight& sight) const {
  std::vector<Handle> out;
  const Stage& stage = document.stage();
  for (std::size_t c = 0; c < stage.characters.size(); ++c) {
    const StagedCharacter& character = stage.characters[c];
    const Mat4 placement = character_placement(stage, c, state.playback.shown());
    for (const HumanoidBone end : ends) {
      const auto limb = find_limb(*character.model, character.humanoid, character.rest.global, end);
      if (!limb) continue;
      const Vec3 place(placement * state.states[c].global[static_cast<std::size_t>(limb->end)][3]);
      if (const auto seen = sight.screen.point(place)) out.push_back({c, *limb, place, *seen});
    }
  }
  return out;
}

bool PictureTools::pull(const Document& document, ViewState& state, const Sight& sight) {
  if (!state.reach) {
    pulling_.reset();
    return false;
  }
  const std::vector<Handle> shown = handles(document, state, sight);
  const Handle* near = nullptr;
  double least = handle_reach;
  for (const Handle& handle : shown)
    if (const double away = glm::distance(handle.seen.at, sight.pointer); sight.free && !turning_ && away < least)
      least = away, near = &handle;
  if (!pulling_ && near && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    pulling_ = {*near, near->seen.at - sight.pointer};
    state.playback.playing = false;
  }
  if (pulling_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    pulling_.reset();
    state.edit_ended = true;
  }
  const bool moved = ImGui::GetIO().MouseDelta.x != 0.0f || ImGui::GetIO().MouseDelta.y != 0.0f;
  if (pulling_ && moved) {
    const Handle& handle = pulling_->handle;
    const PointerRay ray = pointer_ray(sight.viewpoint, sight.pointer + pulling_->off, sight.size);
    if (const auto target = meet_plane(ray, handle.place, sight.viewpoint.back)) {
      Scene scene = document.scene();
      const double frame = state.playback.shown();
      if (reach_with(document.stage(), handle.character, state.states[handle.character], handle.limb, *target, frame,
                     scene.characters[handle.character])) {
        const std::string name(humanoid_name(handle.limb.end_bone));
        state.ask(std::move(scene), "reach with " + name, "reach " + name);
      }
    }
  }
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  for (const Handle& handle : shown) {
    const bool chosen = pulling_ ? pulling_->handle.character == handle.character &&
                                       pulling_->handle.limb.end_bone == handle.limb.end_bone
                                 : &handle == near;
    const ImVec2 p = sight.in_window(handle.seen.at);
    const float r = chosen ? 8.0f : 6.5f;
    draw.AddQuadFilled({p.x - r, p.y}, {p.x, p.y - r}, {p.x + r, p.y}, {p.x, p.y + r}, chosen ? bright : orange);
    draw.AddQuad({p.x - r, p.y}, {p.x, p.y - r}, {p.x + r, p.y}, {p.x, p.y + r}, ink, 1.5f);
    if (chosen) write_beside(p, std::string(humanoid_name(handle.limb.end_bone)));
  }
  return pulling_ || near;
}

void PictureTools::pick(const Document& document, ViewState& state, const Sight& sight) {
  const Stage& stage = document.stage();
  const double frame = state.playback.shown();
  if (sight.free && !ImGui::IsMouseDown(ImGuiMouseButton_Left) && !ImGui::IsMouseReleased(ImGuiMouseButton_Left)) {
    if (const auto near = joint_near(stage, state.states, frame, sight.screen, sight.pointer, joint_reach)) {
      const StagedCharacter& character = stage.characters[near->character];
      const Vec3 place(character_placement(stage, near->character, frame) *
                       state.states[near->character].global[static_cast<std::size_t>(near->node)][3]);
      if (const auto seen = sight.screen.point(place)) {
        ImDrawList& draw = *ImGui::GetBackgroundDrawList();
        const ImVec2 at = sight.in_window(seen->at);
        draw.AddCircle(at, 6.0f, ink, 0, 4.0f);
        draw.AddCircle(at, 6.0f, bright, 0, 2.0f);
        write_beside(at, joint_name(character, near->node));
      }
    }
  }
  if (sight.free && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) pressed_ = sight.pointer;
  if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left) || !pressed_) return;
  const bool clicked = sight.free && glm::distance(*pressed_, sight.pointer) <= click_pixels;
  pressed_.reset();
  if (!clicked) return;
  auto picked = joint_near(stage, state.states, frame, sight.screen, sight.pointer, joint_reach);
  if (!picked)
    picked =
        joint_of_skin(stage, state.states, document.options(), pointer_ray(sight.viewpoint, sight.pointer, sight.size));
  state.joint = picked ? joint_name(stage.characters[picked->character], picked->node) : "";
  if (picked) state.character = picked->character;
  state.show_joint = true;
}

}  // namespace sinew
