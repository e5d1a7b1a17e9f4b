#include "engine/face/target_face.h"

#include <algorithm>

#include "engine/core/text.h"
#include "engine/face/face_shapes.h"
#include "engine/face/head.h"

namespace sinew {
namespace {

/// An adult's regions without vertices: the amounts of presets are an adult's.
const FaceRig& adult_face() {
  static const FaceRig rig = face_sizes(HeadMaker(0).head(measures_of_age(0.0))->face);
  return rig;
}

/// How far each channel can go below and above 0, alone.
struct Reach {
  FaceChannels below, above;
};
const Reach& reach() {
  static const Reach all = [] {
    Reach out{};
    for (std::size_t i = 0; i < face_channels; ++i)
      for (const double far : {-1e3, 1e3}) {
        FaceChannels asked{};
        asked[i] = far;
        (far < 0 ? out.below : out.above)[i] = std::abs(hold_at_limits(adult_face(), asked).channels[i]);
      }
    return out;
  }();
  return all;
}

FaceChannels shares_of(const FaceChannels& channels) {
  FaceChannels out{};
  for (std::size_t i = 0; i < face_channels; ++i) {
    const double limit = (channels[i] < 0 ? reach().below : reach().above)[i];
    if (limit > 0.0) out[i] = channels[i] / limit;
  }
  return out;
}

/// "browDown_L" and "Face.BrowDownLeft" are "browdownleft".
std::string plain(std::string_view name) {
  std::string out(name);
  if (out.ends_with("_L")) out.replace(out.size() - 2, 2, "Left");
  if (out.ends_with("_R")) out.replace(out.size() - 2, 2, "Right");
  return lower(out);
}

std::string without_prefix(const std::string& name) {
  const std::size_t at = name.find_last_of(".:");
  return at == std::string::npos ? name : name.substr(at + 1);
}

/// Names of VRM 0's presets that VRM 1 calls otherwise.
const std::map<std::string, std::string>& old_names() {
  static const std::map<std::string, std::string> names = {{"joy", "happy"},
                                                           {"sorrow", "sad"},
                                                           {"fun", "relaxed"},
                                                           {"a", "aa"},
                                                           {"i", "ih"},
                                                           {"u", "ou"},
                                                           {"e", "ee"},
                                                           {"o", "oh"},
                                                           {"blink_l", "blinkLeft"},
                                                           {"blink_r", "blinkRight"},
                                                           {"lookup", "lookUp"},
                                                           {"lookdown", "lookDown"}};
  return names;
}

struct Known {
  std::string name;
  FaceChannels shares;
};

/// What is known under a plain name.
const std::map<std::string, Known>& known_targets() {
  static const std::map<std::string, Known> all = [] {
    std::map<std::string, Known> out;
    const auto add = [&](const std::string& name, const FaceChannels& shares) {
      out.try_emplace(plain(name), Known{name, shares});
    };
    for (std::size_t i = 0; i < face_channels; ++i)
      for (const bool positive : {true, false}) {
        FaceChannels shares{};
        shares[i] = positive ? 1.0 : -1.0;
        if ((positive ? reach().above : reach().below)[i] > 0.0) add(channel_shape_name(i, positive), shares);
      }
    for (const auto list : {expressions(), arkit_shapes()})
      for (const FacePreset& preset : list) {
        FaceChannels shares = shares_of(preset.channels(false));
        // Both halves of a shape make the whole.
        if (preset.half != FaceHalf::both)
          for (double& share : shares) share *= 0.5;
        add(preset.name, shares);
      }
    for (const auto& [old, now] : old_names()) out.try_emplace(old, out.at(plain(now)));
    return out;
  }();
  return all;
}

const Known* find_known(const std::string& name) {
  const auto& known = known_targets();
  for (const std::string& word : {plain(name), plain(without_prefix(name))})
    if (const auto found = known.find(word); found != known.end()) return &found->second;
  return nullptr;
}

/// VRM's word for what the thesis calls otherwise.
std::string vrm_word(const std::string& expression) {
  for (const auto& [ours, vrm] :
       {std::pair{"smile", "happy"}, {"anger", "angry"}, {"sadness", "sad"}, {"surprise", "surprised"}})
    if (expression == ours) return vrm;
  return expression;
}

}  // namespace

std::optional<TargetFace> TargetFace::find(const Model& model, const CharacterMesh& mesh) {
  TargetFace out;
  for (std::uint32_t slot = 0; slot < mesh.morph_slots.size(); ++slot) {
    const Mesh& drawn = model.meshes[model.nodes[mesh.morph_slots[slot].node].mesh];
    const Known* known = find_known(drawn.primitives.front().morph_targets[mesh.morph_slots[slot].target].name);
    if (known == nullptr || known->name == "neutral") continue;
    const auto at = out.named(known->name);
    if (!at) out.targets_.push_back({known->name, known->shares, {}});
    out.targets_[at.value_or(out.targets_.size() - 1)].slots.push_back(slot);
  }
  if (out.targets_.empty()) return std::nullopt;
  return out;
}

std::optional<std::size_t> TargetFace::named(const std::string& name) const {
  const auto found = std::ranges::find(targets_, name, &Target::name);
  if (found == targets_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - targets_.begin());
}

std::vector<std::string> TargetFace::names() const {
  std::vector<std::string> out;
  for (const Target& target : targets_) out.push_back(target.name);
  return out;
}

TargetFace::Mix TargetFace::mix_for(const FaceChannels& shares) const {
  // Coordinate descent on |wanted - sum|^2 + sparing sum: few targets rather than many that cancel.
  constexpr int rounds = 200;
  constexpr double sparing = 0.02, near = 0.7;
  Mix mix(targets_.size(), 0.0);
  FaceChannels rest = shares;
  const auto squared = [](const FaceChannels& x) {
    double sum = 0.0;
    for (const double number : x) sum += number * number;
    return sum;
  };
  for (int round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      const FaceChannels& column = targets_[k].shares;
      const double size = squared(column);
      if (size <= 0.0) continue;
      double along = 0.0;
      for (std::size_t i = 0; i < face_channels; ++i) along += column[i] * rest[i];
      const double weight = std::clamp(mix[k] + (along - 0.5 * sparing) / size, 0.0, 1.0);
      for (std::size_t i = 0; i < face_channels; ++i) rest[i] -= (weight - mix[k]) * column[i];
      mix[k] = weight;
    }
  if (squared(rest) > near * squared(shares)) return {};
  return mix;
}

const FaceRig& TargetFace::sizes() { return adult_face(); }

TargetFace::Mix TargetFace::expression_mix(const FacePreset& expression) const {
  auto at = named(expression.name);
  if (!at) at = named(vrm_word(expression.name));
  const FaceChannels channels = expression.channels(false);
  if (!at && channels != FaceChannels{}) return mix_for(shares_of(channels));
  Mix mix(targets_.size(), 0.0);
  if (at) mix[*at] = 1.0;
  return mix;
}

TargetFace::Mix TargetFace::channel_mix(std::size_t channel, bool up) const {
  FaceChannels shares{};
  shares[channel] = up ? 1.0 : -1.0;
  return mix_for(shares);
}

Result<void> TargetFace::prepare(const FaceTrack& track) {
  const auto expression = [&](const FacePreset* preset) -> Result<void> {
    Mix mix = expression_mix(*preset);
    if (mix.empty())
      return bad_input("/expressions: the model's morph targets cannot make \"{}\"{}; it has {}", preset->name,
                       did_you_mean(preset->name, names()), fmt::join(names(), ", "));
    of_expression_[preset] = std::move(mix);
    return {};
  };
  for (const FaceTrack::Keys& keys : track.keys)
    if (auto ok = expression(keys.expression); !ok) return ok;
  for (const FaceTrack::Cue& cue : track.cues)
    if (auto ok = expression(cue.expression); !ok) return ok;
  for (const FaceTrack::Region& region : track.regions)
    for (const auto& key : region.numbers.keys)
      for (std::size_t i = 0; i < key.value.size(); ++i) {
        const std::size_t channel = region.first_channel + i;
        if (key.value[i] == 0.0) continue;
        Mix mix = channel_mix(channel, key.value[i] > 0.0);
        if (mix.empty())
          return bad_input("/regions/{}: the model has no morph target that moves it so; it has {}",
                           face_channel_names()[channel].region, fmt::join(names(), ", "));
        of_channel_[{channel, key.value[i] > 0.0}] = std::move(mix);
      }
  return {};
}

void TargetFace::add_weights(const FaceTrack& track, double frame, std::span<double> weights) const {
  Mix sum(targets_.size(), 0.0);
  const auto add = [&](const Mix& mix, double amount) {
    for (std::size_t k = 0; k < mix.size(); ++k) sum[k] += amount * mix[k];
  };
  for (const auto& [expression, strength] : overridden(expressions_at(track, frame)))
    add(of_expression_.at(expression), strength);
  const FaceChannels shares = shares_of(regions_at(track, frame));
  for (std::size_t i = 0; i < face_channels; ++i)
    if (shares[i] != 0.0) add(of_channel_.at({i, shares[i] > 0.0}), std::abs(shares[i]));
  for (std::size_t k = 0; k < targets_.size(); ++k)
    for (const std::uint32_t slot : targets_[k].slots) weights[slot] += std::clamp(sum[k], 0.0, 1.0);
}

}  // namespace sinew
