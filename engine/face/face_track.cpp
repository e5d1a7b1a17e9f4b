#include "engine/face/face_track.h"

#include <algorithm>
#include <set>

#include "engine/model/scene_words.h"

namespace sinew {
namespace {

/// Every expression's own strength at every key: 0 where the key is another's, so that neighbours cross-fade.
std::vector<FaceTrack::Keys> strengths(const Keyed<ExpressionWeight>& keyed) {
  std::vector<FaceTrack::Keys> out;
  std::set<Expression> shown;
  for (const auto& key : keyed.keys)
    if (key.value.expression != Expression::neutral) shown.insert(key.value.expression);
  for (const Expression expression : shown) {
    FaceTrack::Keys& keys = out.emplace_back();
    keys.expression = *find_expression(expression_names()[static_cast<std::size_t>(expression)]);
    keys.strength.ease = keyed.ease;
    for (const auto& key : keyed.keys)
      keys.strength.keys.push_back({key.frame, key.value.expression == expression ? key.value.strength : 0.0});
  }
  return out;
}

double eased(Ease ease, double t) {
  switch (ease) {
    case Ease::linear:
      return t;
    case Ease::smooth:
    case Ease::cubic:
      return smoothstep01(t);
    case Ease::step:
      return t >= 1.0 ? 1.0 : 0.0;
  }
  return t;
}

std::size_t first_channel_of(const std::string& region) {
  const auto& names = face_channel_names();
  const auto found = std::ranges::find(names, region, &FaceChannelName::region);
  return static_cast<std::size_t>(found - names.begin());
}

double stop_of(const ExpressionCue& cue) { return cue.stop.value_or(cue.until + cue.fade); }

}  // namespace

Result<FaceTrack> face_track(const Character& character) {
  FaceTrack out;
  if (character.expressions) out.keys = strengths(*character.expressions);
  for (const ExpressionCue& cue : character.cues) {
    auto found = find_expression(cue.expression);
    if (!found) return bad_input("/expressions: {}", found.error().message);
    out.cues.push_back({*found, cue});
  }
  for (const auto& [region, numbers] : character.regions) out.regions.push_back({first_channel_of(region), numbers});
  return out;
}

double cue_strength(const ExpressionCue& cue, double frame) {
  const double stop = stop_of(cue);
  if (frame < cue.start || frame > stop) return 0.0;
  const double rise = std::min(cue.fade, cue.until - cue.start), fall = stop - cue.until;
  double share = 1.0;
  if (frame < cue.start + rise) share = eased(cue.ease, (frame - cue.start) / rise);
  if (frame > cue.until) share = 1.0 - eased(cue.ease, (frame - cue.until) / fall);
  return cue.strength * share;
}

std::vector<WeighedExpression> expressions_at(const FaceTrack& track, double frame) {
  std::vector<WeighedExpression> out;
  const auto add = [&](const FacePreset* expression, double strength) {
    if (strength > 0.0) out.push_back({expression, strength});
  };
  for (const FaceTrack::Keys& keys : track.keys) add(keys.expression, keys.strength.value_at(frame));
  for (const FaceTrack::Cue& cue : track.cues) add(cue.expression, cue_strength(cue.cue, frame));
  return out;
}

FaceChannels regions_at(const FaceTrack& track, double frame) {
  FaceChannels out{};
  for (const FaceTrack::Region& region : track.regions) {
    const std::vector<double> numbers = region.numbers.value_at(frame);
    for (std::size_t i = 0; i < numbers.size(); ++i) out[region.first_channel + i] += numbers[i];
  }
  return out;
}

FaceChannels channels_at(const FaceTrack& track, const FaceRig& face, double frame) {
  FaceChannels out = for_head(face, mix_expressions(expressions_at(track, frame), false));
  const FaceChannels regions = regions_at(track, frame);
  for (std::size_t i = 0; i < face_channels; ++i) out[i] += regions[i];
  return out;
}

std::pair<double, double> reach_of(const FaceTrack& track) {
  double first = 0.0, last = 0.0;
  const auto reach = [&](double from, double to) {
    first = std::min(first, from);
    last = std::max(last, to);
  };
  const auto reach_keys = [&](const auto& keyed) { reach(keyed.keys.front().frame, keyed.keys.back().frame); };
  for (const FaceTrack::Keys& keys : track.keys) reach_keys(keys.strength);
  for (const FaceTrack::Cue& cue : track.cues) reach(cue.cue.start, stop_of(cue.cue));
  for (const FaceTrack::Region& region : track.regions) reach_keys(region.numbers);
  return {first, last};
}

}  // namespace sinew
