#include "engine/rig/clip_sampling.h"

#include <algorithm>

#include "engine/core/text.h"

namespace sinew {
namespace {

/// A channel at one time: the keys around it and how far between them it stands.
class Sampler {
 public:
  Sampler(const Channel& channel, double seconds) : channel_(channel) {
    const std::vector<double>& times = channel.times;
    const auto after = std::upper_bound(times.begin(), times.end(), seconds);
    if (after == times.begin() || after == times.end()) {
      key_ = after == times.begin() ? 0 : times.size() - 1;
      return;
    }
    key_ = static_cast<std::size_t>(after - times.begin()) - 1;
    if (channel.interpolation == Interpolation::step) return;
    span_ = times[key_ + 1] - times[key_];
    u_ = (seconds - times[key_]) / span_;
    between_ = true;
  }

  std::vector<double> numbers() const {
    std::vector<double> result(channel_.width);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = number(i);
    return result;
  }

  Quat rotation() const {
    if (between_ && channel_.interpolation == Interpolation::linear)
      return glm::normalize(glm::slerp(key_rotation(key_), key_rotation(key_ + 1), u_));
    return glm::normalize(Quat(number(3), number(0), number(1), number(2)));
  }

 private:
  double at(std::size_t key, std::size_t row, std::size_t component) const {
    const bool cubic = channel_.interpolation == Interpolation::cubic_spline;
    return channel_.values[(cubic ? key * 3 + row : key) * channel_.width + component];
  }

  double value(std::size_t key, std::size_t component) const { return at(key, 1, component); }

  double number(std::size_t component) const {
    const double p0 = value(key_, component);
    if (!between_) return p0;
    const double p1 = value(key_ + 1, component);
    if (channel_.interpolation == Interpolation::linear) return p0 + u_ * (p1 - p0);
    const double out0 = span_ * at(key_, 2, component), in1 = span_ * at(key_ + 1, 0, component);
    const double u2 = u_ * u_, u3 = u2 * u_;
    return (2 * u3 - 3 * u2 + 1) * p0 + (u3 - 2 * u2 + u_) * out0 + (3 * u2 - 2 * u3) * p1 + (u3 - u2) * in1;
  }

  Quat key_rotation(std::size_t key) const {
    return glm::normalize(Quat(value(key, 3), value(key, 0), value(key, 1), value(key, 2)));
  }

  const Channel& channel_;
  std::size_t key_ = 0;
  double u_ = 0.0, span_ = 0.0;
  bool between_ = false;
};

std::vector<std::string> clip_names(const Model& model) {
  std::vector<std::string> names;
  for (const Clip& clip : model.clips) names.push_back(clip.name);
  return names;
}

}  // namespace

Result<int> find_clip(const Model& model, const ClipChoice& choice) {
  if (std::holds_alternative<NoClip>(choice)) return -1;
  const std::vector<std::string> names = clip_names(model);
  if (const int* index = std::get_if<int>(&choice)) {
    if (*index < static_cast<int>(names.size())) return *index;
    return bad_input("{}: has no clip {}; it has {} ({})", model.file, *index, names.size(), fmt::join(names, ", "));
  }
  const std::string& name = std::get<std::string>(choice);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<int>(i);
  if (names.empty()) return bad_input("{}: has no clip \"{}\"; it has none at all", model.file, name);
  return bad_input("{}: has no clip \"{}\"{}; it has {} ({})", model.file, name, did_you_mean(name, names),
                   names.size(), fmt::join(names, ", "));
}

void sample_clip(const Clip& clip, double seconds, Pose& pose) {
  for (const Channel& channel : clip.channels) {
    const Sampler sampler(channel, seconds);
    Transform& local = pose.local[channel.node];
    if (channel.path == ChannelPath::rotation) {
      local.rotation = sampler.rotation();
      continue;
    }
    const std::vector<double> numbers = sampler.numbers();
    switch (channel.path) {
      case ChannelPath::translation:
        local.translation = {numbers[0], numbers[1], numbers[2]};
        break;
      case ChannelPath::scale:
        local.scale = {numbers[0], numbers[1], numbers[2]};
        break;
      default:
        pose.morph_weights[channel.node] = numbers;
    }
  }
}

}  // namespace sinew
