#include <imgui.h>
#include <imgui_stdlib.h>

#include "engine/view/curve_plot_panel.h"
#include "engine/view/panel_parts.h"
#include "engine/view/track_edit.h"

namespace sinew {
namespace {

constexpr const char* axis_labels[] = {"x", "y", "z"};

void choose_axis(int& axis) {
  for (int i = 0; i < 3; ++i) {
    ImGui::SameLine();
    if (ImGui::RadioButton(axis_labels[i], axis == i)) axis = i;
  }
}

void draw_fit(MotionPanel& panel) {
  ImGui::SetNextItemWidth(92.0f);
  ImGui::DragFloat("##tolerance", &panel.tolerance, 0.01f, 0.01f, 20.0f, "%.2f deg", ImGuiSliderFlags_AlwaysClamp);
  show_tip("how far curves may be off their samples");
  ImGui::SameLine();
  if (ImGui::Button("Fit")) panel.browser.fit(panel.tolerance);
  show_tip("fits the clip's curves anew and keeps them in the library");
}

void draw_edits(MotionPanel& panel, ClipEditor& editor) {
  ImGui::SameLine();
  ImGui::BeginDisabled(!editor.is_edited());
  if (ImGui::Button("Take back")) editor.take_back();
  show_tip(fmt::format("{} edits of {} are not saved", editor.edits().size(), editor.name()));
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-52.0f);
  ImGui::InputTextWithHint("##as", "new clip's name", &panel.save_as);
  ImGui::SameLine();
  const bool named = !panel.save_as.empty();
  if (ImGui::Button("Save") && named) panel.browser.save_as(panel.save_as);
  show_tip(named ? "adds it to the library as a clip made from " + editor.name() + ", and plays it"
                 : std::string("name the new clip first"));
  ImGui::EndDisabled();
}

void choose_joint(const MotionSkeleton& skeleton, std::size_t& joint) {
  joint = std::min(joint, skeleton.joints.size() - 1);
  ImGui::SetNextItemWidth(150.0f);
  if (!ImGui::BeginCombo("##joint", skeleton.joints[joint].name.c_str())) return;
  for (std::size_t i = 0; i < skeleton.joints.size(); ++i)
    if (ImGui::Selectable((skeleton.joints[i].name + "##" + std::to_string(i)).c_str(), i == joint)) joint = i;
  ImGui::EndCombo();
}

void take_action(const PlotAction& action, ClipEditor& editor, const CurveChoice& choice, ViewState& state) {
  using Kind = PlotAction::Kind;
  const PiecewisePolynomial& curve = editor.curve(choice);
  state.motion.edited_last = state.motion.edited_last || (action.kind != Kind::none && action.kind != Kind::released);
  switch (action.kind) {
    case Kind::set_value:
      state.tell(editor.set_key(choice, action.key, action.value, {},
                                action.in_time ? std::optional(action.x) : std::nullopt));
      break;
    case Kind::set_slope:
      state.tell(editor.set_key(choice, action.key, curve_keys(curve)[action.key].value, action.slope));
      break;
    case Kind::add:
      if (action.x > curve.begin() && action.x < curve.end()) state.tell(editor.add_key(choice, action.x));
      break;
    case Kind::remove:
      if (action.key > 0 && action.key < curve.segments()) state.tell(editor.delete_key(choice, action.key));
      break;
    case Kind::released:
      editor.seal();
      break;
    case Kind::none:
      break;
  }
}

/// Seconds into the character's clip at the frame that is shown.
double clip_seconds(const Document& document, const ViewState& state) {
  const Scene& scene = document.scene();
  if (state.character >= scene.characters.size()) return 0.0;
  const MotionUse use = scene.characters[state.character].motion.value_or(MotionUse{});
  return motion_seconds(use, state.playback.shown(), scene.fps);
}

void draw_clip(const Document& document, ViewState& state) {
  MotionPanel& panel = state.motion;
  const StoredClip* clip = panel.browser.clip();
  if (panel.browser.task().running()) {
    ImGui::TextDisabled("%s ...", panel.browser.task().what().c_str());
    return;
  }
  if (clip == nullptr) {
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextDisabled("choose a clip to see its curves; double click it and the character plays it");
    ImGui::PopTextWrapPos();
    return;
  }
  ClipEditor* editor = panel.browser.editor();
  if (editor == nullptr) {
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%s has no curves yet", clip->entry.name.c_str());
    ImGui::SameLine();
    return draw_fit(panel);
  }
  choose_joint(clip->motion.skeleton, panel.choice.joint);
  choose_axis(panel.choice.axis);
  draw_fit(panel);
  draw_edits(panel, *editor);  // may take an edit, and its curve, back
  const PiecewisePolynomial& curve = editor->curve(panel.choice);
  PlottedCurve plotted;
  plotted.times = editor->times();
  plotted.samples = editor->samples(panel.choice);
  plotted.value = [&](double seconds) { return curve.value(seconds); };
  plotted.keys = curve_keys(curve);
  plotted.has_slopes = true;
  const ClipEditor::Residual& residual = editor->residual(panel.choice);
  plotted.residuals = residual.values;
  plotted.range = {curve.begin(), curve.end()};
  plotted.now = clip_seconds(document, state);
  plotted.caption = fmt::format("{} segments, degree {}, off by {:.2f} deg, {:.2f} at most", curve.segments(),
                                curve.degree(), residual.rms, residual.largest);
  take_action(draw_plot(plotted, panel), *editor, panel.choice, state);
}

/// An edit of the chosen joint's track.
template <class Change>
void ask_for_keys(const Document& document, ViewState& state, const char* label, const std::string& merge,
                  Change change) {
  Scene scene = document.scene();
  change(scene.characters[state.character]);
  state.ask(std::move(scene), label + state.joint, merge);
}

void draw_keys(const Document& document, ViewState& state) {
  MotionPanel& panel = state.motion;
  const Character& character = document.scene().characters[state.character];
  const auto track = character.keys.find(state.joint);
  if (state.joint.empty() || track == character.keys.end() || track->second.is_constant()) {
    ImGui::TextDisabled("%s", state.joint.empty() ? "choose a joint in the list on the right"
                                                  : "the joint has no keys yet: K sets one at the frame that is shown");
    return;
  }
  const Keyed<Vec3>& keyed = track->second;
  ImGui::AlignTextToFramePadding();
  ImGui::Text("%s", state.joint.c_str());
  choose_axis(panel.axis);
  PlottedCurve plotted;
  plotted.value = [&](double frame) { return keyed.value_at(frame)[panel.axis]; };
  for (const Key<Vec3>& key : keyed.keys) plotted.keys.push_back({key.frame, key.value[panel.axis], 0.0});
  plotted.range.add(state.playback.range.first);
  plotted.range.add(state.playback.range.last);
  for (const Key<Vec3>& key : keyed.keys) plotted.range.add(key.frame);
  plotted.now = state.playback.shown();
  plotted.unit = "frame";
  plotted.caption = "drag keys, with Shift along the time alone; double click adds one, right click takes one away";
  const PlotAction action = draw_plot(plotted, panel);
  const auto set_number = [&](double frame) {
    return [&, frame](Character& changed) {
      Vec3 degrees = joint_degrees(changed, state.joint, frame);
      degrees[panel.axis] = action.value;
      set_joint_degrees(changed, state.joint, frame, degrees);
    };
  };
  using Kind = PlotAction::Kind;
  if (action.kind == Kind::set_value)
    ask_for_keys(document, state, "turn ", fmt::format("key {} {} {}", state.joint, panel.axis, action.key),
                 [&](Character& changed) {
                   Keyed<Vec3>& moved = changed.keys.at(state.joint);
                   moved.keys[action.key].value[panel.axis] = action.value;
                   if (action.in_time) move_key(moved, action.key, std::round(action.x));
                 });
  if (action.kind == Kind::add) ask_for_keys(document, state, "key for ", "", set_number(std::round(action.x)));
  if (action.kind == Kind::remove)
    ask_for_keys(document, state, "no key for ", "",
                 [&](Character& changed) { remove_joint_key(changed, state.joint, keyed.keys[action.key].frame); });
  if (action.kind == Kind::released) state.edit_ended = true;
}

}  // namespace

void draw_curves(const Document& document, ViewState& state) {
  MotionPanel& panel = state.motion;
  const auto source = [&](const char* label, CurveSource wanted) {
    if (ImGui::RadioButton(label, panel.source == wanted)) {
      panel.source = wanted;
      panel.drag.reset();
      panel.zoom.reset();
    }
  };
  source("clip's curves", CurveSource::clip);
  ImGui::SameLine();
  source("scene's keys", CurveSource::keys);
  if (panel.source == CurveSource::clip)
    draw_clip(document, state);
  else if (state.character < document.scene().characters.size())
    draw_keys(document, state);
}

}  // namespace sinew
