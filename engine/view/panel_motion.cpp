#include <imgui.h>
#include <imgui_stdlib.h>

#include "engine/model/scene_words.h"
#include "engine/view/fitted_text.h"
#include "engine/view/panel_parts.h"

namespace sinew {
namespace {

constexpr float list_width = 260.0f, settings_height = 92.0f;

/// One of some words, or any; true where another was chosen.
bool choose_or_any(const char* label, const char* any, std::span<const std::string> words, std::string& chosen) {
  bool changed = false;
  if (!ImGui::BeginCombo(label, chosen.empty() ? any : chosen.c_str())) return false;
  if (ImGui::Selectable(any, chosen.empty())) {
    changed = !chosen.empty();
    chosen.clear();
  }
  for (const std::string& word : words)
    if (ImGui::Selectable(word.c_str(), word == chosen)) {
      changed = word != chosen;
      chosen = word;
    }
  ImGui::EndCombo();
  return changed;
}

void draw_query(MotionBrowser& browser) {
  bool changed = false;
  ImGui::SetNextItemWidth(-1.0f);
  changed |= ImGui::InputTextWithHint("##clip", "find a clip", &browser.query.name);
  const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  ImGui::SetNextItemWidth(half);
  changed |= choose_or_any("##tag", "any tag", browser.tags(), browser.query.tag);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(half);
  changed |= choose_or_any("##emotion", "any emotion", expression_names(), browser.query.emotion);
  if (changed) browser.refresh();
}

std::string told(const ClipEntry& clip) {
  std::string text = fmt::format("{}\n{} frames, {} joints, {}", clip.name, clip.frames, clip.joints,
                                 clip.fitted ? "fitted" : "samples only");
  if (!clip.tags.empty()) text += fmt::format("\ntags: {}", fmt::join(clip.tags, ", "));
  if (!clip.emotion.empty()) text += "\nemotion: " + clip.emotion;
  if (!clip.parent.empty()) text += "\nmade from: " + clip.parent;
  if (!clip.licence.empty()) text += "\nlicence: " + clip.licence;
  return text + "\ndouble click: the character plays it";
}

void draw_list(const Document& document, ViewState& state) {
  MotionBrowser& browser = state.motion.browser;
  if (!browser.trouble().empty()) {
    ImGui::TextWrapped("%s", browser.trouble().c_str());
    ImGui::TextDisabled("sinew motion import fills a library");
    return;
  }
  if (browser.clips().empty()) ImGui::TextDisabled("no such clip");
  // What is done with a clip may list them anew.
  std::string opened, played;
  for (const ClipEntry& clip : browser.clips()) {
    const bool chosen = browser.clip() != nullptr && browser.clip()->entry.name == clip.name;
    const std::string length = fmt::format("{:.1f} s", clip.duration());
    const float length_width = ImGui::CalcTextSize(length.c_str()).x;
    const float room = ImGui::GetContentRegionAvail().x - length_width - ImGui::GetStyle().ItemSpacing.x;
    const std::string name = fitted_text(clip.name, room) + "##" + clip.name;
    if (ImGui::Selectable(name.c_str(), chosen, ImGuiSelectableFlags_AllowDoubleClick)) {
      if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        played = clip.name;
      else if (!chosen)
        opened = clip.name;
    }
    show_tip(told(clip));
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - length_width);
    ImGui::TextDisabled("%s", length.c_str());
  }
  if (!opened.empty()) browser.open(opened);
  if (!played.empty()) state.edit = clip_edit(document, state, played);
}

/// Start, speed and weight of the motion that the character plays.
void draw_settings(const Document& document, ViewState& state) {
  const Scene& scene = document.scene();
  if (state.character >= scene.characters.size()) return;
  const std::optional<MotionUse>& use = scene.characters[state.character].motion;
  if (!use) {
    ImGui::TextDisabled("the character plays no motion");
    return;
  }
  const auto* clip = std::get_if<LibraryClip>(&use->source);
  constexpr float remove_width = 64.0f;
  draw_fitted_text("plays " + (clip ? clip->name : std::get<MotionFile>(use->source).path.filename().string()),
                   FittedEnd::first, ImGui::GetContentRegionAvail().x - remove_width - ImGui::GetStyle().ItemSpacing.x);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - remove_width);
  if (ImGui::SmallButton("remove")) {
    Scene changed = scene;
    changed.characters[state.character].motion.reset();
    state.ask(std::move(changed), "no motion");
  }
  const auto number = [&](const char* label, double value, float speed, float low, float high, const char* format,
                          auto set) {
    float shown = static_cast<float>(value);
    ImGui::SetNextItemWidth(86.0f);
    if (ImGui::DragFloat(label, &shown, speed, low, high, format, ImGuiSliderFlags_AlwaysClamp)) {
      Scene changed = scene;
      set(*changed.characters[state.character].motion, static_cast<double>(shown));
      state.ask(std::move(changed), std::string("motion's ") + label, std::string("motion ") + label);
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) state.edit_ended = true;
  };
  number("start", use->start, 0.2f, -100000.0f, 100000.0f, "frame %.0f",
         [](MotionUse& motion, double value) { motion.start = std::round(value); });
  ImGui::SameLine();
  number("speed", use->speed, 0.01f, 0.01f, 100.0f, "%.2f x",
         [](MotionUse& motion, double value) { motion.speed = value; });
  if (use->weight.is_constant())
    number("weight", use->weight.value_at(0), 0.005f, 0.0f, 1.0f, "%.2f",
           [](MotionUse& motion, double value) { motion.weight = Keyed<double>::constant(value); });
  else
    ImGui::TextDisabled("its weight has keys");
}

}  // namespace

std::optional<ViewState::Edit> clip_edit(const Document& document, const ViewState& state, const std::string& clip) {
  Scene scene = document.scene();
  if (state.character >= scene.characters.size()) return {};
  std::optional<MotionUse>& motion = scene.characters[state.character].motion;
  MotionUse use = motion.value_or(MotionUse{});
  use.source = LibraryClip{clip};
  motion = std::move(use);
  return ViewState::Edit{std::move(scene), "motion " + clip, ""};
}

void draw_motion(const Document& document, ViewState& state) {
  const Scene& scene = document.scene();
  state.motion.browser.use_library(scene.library.value_or(document.options().library));
  ImGui::BeginChild("library", {list_width, 0.0f});
  draw_query(state.motion.browser);
  ImGui::BeginChild("clips", {0.0f, -settings_height});
  draw_list(document, state);
  ImGui::EndChild();
  ImGui::Separator();
  draw_settings(document, state);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("curves");
  draw_curves(document, state);
  ImGui::EndChild();
}

}  // namespace sinew
