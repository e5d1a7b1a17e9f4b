#include "engine/view/face_edit.h"

#include <algorithm>
#include <cmath>

#include "engine/model/scene_words.h"
#include "engine/view/track_edit.h"

namespace sinew {
namespace {

/// Beyond every limit.
constexpr double far = 1e6;

/// What a dragged channel is rounded to: drawing units, degrees and shares that read well in a file.
constexpr double step = 1e-4;

std::size_t index_of(FaceChannel channel) { return static_cast<std::size_t>(channel); }

/// The first channel of the region that a channel belongs to, and how many it has.
std::span<const FaceChannelName> region_of(FaceChannel channel) {
  const auto& names = face_channel_names();
  const auto same = [&](const FaceChannelName& name) {
    return std::string_view(name.region) == names[index_of(channel)].region;
  };
  const auto first = std::ranges::find_if(names, same);
  const auto last = std::find_if_not(first, names.end(), same);
  return {first, last};
}

/// What added to `base` makes `sum`, or in rounding a little less of it: never beyond it.
double added_to(double base, double sum) {
  double value = sum - base;
  while (std::abs(base + value) > std::abs(sum)) value = std::nextafter(value, value - sum);
  return value;
}

/// Writes all numbers of the channel's region.
void set_region(Character& character, double frame, FaceChannel channel, const FaceChannels& values) {
  const auto region = region_of(channel);
  const auto first = values.begin() + (region.data() - face_channel_names().data());
  std::vector<double> numbers(first, first + static_cast<std::ptrdiff_t>(region.size()));
  const auto [track, is_new] =
      character.regions.try_emplace(region.front().region, Keyed<std::vector<double>>::constant(numbers));
  if (!is_new) set_value(track->second, frame, std::move(numbers));
}

}  // namespace

std::optional<ShownFace> shown_face(const StagedCharacter& character, double frame) {
  ShownFace out;
  if (character.mesh.face)
    out.sizes = face_sizes_at(character.face, character.mesh, frame);
  else if (target_face(character))
    out.sizes = TargetFace::sizes();
  else
    return std::nullopt;
  const FaceTrack& track = character.face.track;
  const FaceChannels both = channels_at(track, out.sizes, frame);
  out.regions = regions_at(track, frame);
  out.expressions = for_head(out.sizes, mix_expressions(expressions_at(track, frame), false));
  out.shown = hold_at_limits(out.sizes, both).channels;
  out.strengths.assign(expression_names().size(), 0.0);
  for (const FaceTrack::Keys& keys : track.keys) {
    const auto name = std::ranges::find(expression_names(), keys.expression->name);
    out.strengths[static_cast<std::size_t>(name - expression_names().begin())] = keys.strength.value_at(frame);
  }
  return out;
}

ChannelRange channel_range(const ShownFace& face, FaceChannel channel) {
  const auto held_at = [&](double value) {
    FaceChannels asked = face.shown;
    asked[index_of(channel)] = value;
    return hold_at_limits(face.sizes, asked).channels[index_of(channel)];
  };
  return {held_at(-far), held_at(far)};
}

std::optional<TargetFace> target_face(const StagedCharacter& character) {
  if (character.mesh.face || character.mesh.morph_slots.empty()) return std::nullopt;
  return TargetFace::find(*character.model, character.mesh);
}

TargetAbilities target_abilities(const TargetFace& face) {
  TargetAbilities out;
  for (const std::string& name : expression_names()) {
    const auto preset = find_expression(name);
    out.expressions.push_back(preset && face.can_show(**preset));
  }
  ShownFace still;
  still.sizes = TargetFace::sizes();
  for (std::size_t c = 0; c < face_channels; ++c) {
    const ChannelRange range = channel_range(still, static_cast<FaceChannel>(c));
    out.channels[c] = {face.can_move(c, false) ? range.low : 0.0, face.can_move(c, true) ? range.high : 0.0};
  }
  return out;
}

void set_expression(Character& character, double frame, Expression expression, double strength) {
  const ExpressionWeight weight{expression, std::clamp(strength, 0.0, most_expression_strength)};
  if (!character.expressions)
    character.expressions = Keyed<ExpressionWeight>::constant(weight);
  else
    set_value(*character.expressions, frame, weight);
}

void move_channels(Character& character, const ShownFace& face, double frame, std::span<const ChannelGoal> goals) {
  FaceChannels asked = face.shown;
  for (const ChannelGoal& goal : goals) asked[index_of(goal.channel)] = std::round(goal.value / step) * step + 0.0;
  const FaceChannels held = hold_at_limits(face.sizes, asked).channels;
  // Where expressions alone go beyond a limit the region must not take that back.
  FaceChannels regions = face.regions;
  const auto is_goal = [&](FaceChannel channel) {
    return std::ranges::find(goals, channel, &ChannelGoal::channel) != goals.end();
  };
  for (std::size_t c = 0; c < face_channels; ++c)
    if (is_goal(static_cast<FaceChannel>(c)) || held[c] != face.shown[c])
      regions[c] = added_to(face.expressions[c], held[c]);
  for (std::size_t c = 0; c < face_channels; ++c)
    if (regions[c] != face.regions[c]) set_region(character, frame, static_cast<FaceChannel>(c), regions);
}

void set_channel(Character& character, const ShownFace& face, double frame, FaceChannel channel, double value) {
  FaceChannels regions = face.regions;
  regions[index_of(channel)] = value;
  set_region(character, frame, channel, regions);
}

void reset_region(Character& character, FaceChannel channel) {
  character.regions.erase(face_channel_names()[index_of(channel)].region);
}

void add_face_key(Character& character, const ShownFace& face, double frame) {
  const auto strongest = std::ranges::max_element(face.strengths);
  ExpressionWeight weight;
  if (*strongest > 0.0) weight = {static_cast<Expression>(strongest - face.strengths.begin()), *strongest};
  if (!character.expressions)
    character.expressions = {{{frame, weight}}, Ease::linear};
  else
    put_key(*character.expressions, frame, weight);
  for (auto& [region, track] : character.regions) put_key(track, frame, track.value_at(frame));
}

void remove_face_key(Character& character, double frame) {
  if (character.expressions && remove_key(*character.expressions, frame)) character.expressions.reset();
  for (auto region = character.regions.begin(); region != character.regions.end();)
    region = remove_key(region->second, frame) ? character.regions.erase(region) : std::next(region);
}

bool has_drawn_head(const Character& character) {
  return character.model == "builtin:head" || character.head.has_value();
}

void set_head_age(Character& character, double frame, double age) {
  if (!character.head) character.head.emplace();
  set_value(character.head->age, frame, std::clamp(age, 0.0, 1.0));
}

void set_skull(Character& character, const std::string& outline, double weight) {
  if (!character.head) character.head.emplace();
  if (weight > 0.0)
    character.head->skull[outline] = std::min(weight, 1.0);
  else
    character.head->skull.erase(outline);
}

}  // namespace sinew
