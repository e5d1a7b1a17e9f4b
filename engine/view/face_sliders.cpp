#include "engine/view/face_sliders.h"

#include <cmath>

#include "engine/model/scene_words.h"
#include "engine/view/panel_parts.h"

namespace sinew {

bool named_slider(const std::string& name, double& value, double low, double high, ViewState& state) {
  float shown = static_cast<float>(value);
  const std::string format = name + " %.2f";
  const bool moved = ImGui::SliderFloat("##value", &shown, static_cast<float>(low), static_cast<float>(high),
                                        format.c_str(), ImGuiSliderFlags_AlwaysClamp);
  if (ImGui::IsItemDeactivatedAfterEdit()) state.edit_ended = true;
  // What a float shows as two decimals is meant so.
  if (moved) value = std::round(1000.0 * static_cast<double>(shown)) / 1000.0;
  return moved;
}

void draw_expressions(const Document& document, ViewState& state, std::size_t character, const ShownFace& face,
                      const TargetAbilities* abilities) {
  ImGui::TextDisabled("Expressions: one at each key, 1 is whole");
  const auto names = expression_names();
  in_columns("expressions", names.size() - 1, [&](std::size_t i) {
    const bool can = !abilities || abilities->expressions[i + 1];
    double strength = face.strengths[i + 1];
    ImGui::BeginDisabled(!can);
    const bool moved = named_slider(names[i + 1], strength, 0.0, most_expression_strength, state);
    ImGui::EndDisabled();
    if (!can) show_tip("the model's morph targets cannot make it");
    if (!moved) return;
    Scene scene = document.scene();
    set_expression(scene.characters[character], state.playback.shown(), static_cast<Expression>(i + 1), strength);
    state.ask(std::move(scene), names[i + 1], "expression " + names[i + 1]);
  });
}

void draw_target_face(const Document& document, ViewState& state, std::size_t character, const ShownFace& face) {
  const StagedCharacter& staged = document.stage().characters[character];
  const auto [known, is_new] = state.target_faces.try_emplace(staged.model_hash);
  if (is_new)
    if (const auto targets = target_face(staged)) known->second = target_abilities(*targets);
  const TargetAbilities& abilities = known->second;
  ImGui::TextDisabled("A face by the model's morph targets");
  draw_expressions(document, state, character, face, &abilities);
  std::vector<FaceChannel> moved;
  for (std::size_t c = 0; c < face_channels; ++c)
    if (abilities.channels[c].low < abilities.channels[c].high) moved.push_back(static_cast<FaceChannel>(c));
  if (moved.empty()) return;
  ImGui::TextDisabled("Regions: added to the expressions");
  const auto slider = [&](std::size_t i) {
    const FaceChannel region = moved[i];
    const ChannelRange& range = abilities.channels[static_cast<std::size_t>(region)];
    const std::string name = channel_word(region);
    double value = channel(face.regions, region);
    if (!named_slider(name, value, range.low, range.high, state)) return;
    Scene scene = document.scene();
    set_channel(scene.characters[character], face, state.playback.shown(), region, value);
    state.ask(std::move(scene), name, "region " + name);
  };
  in_columns("regions", moved.size(), slider, 1);
}

}  // namespace sinew
