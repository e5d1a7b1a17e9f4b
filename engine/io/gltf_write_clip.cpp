#include "engine/io/gltf_write_parts.h"

namespace sinew {
namespace {

const char* interpolation_name(Interpolation interpolation) {
  switch (interpolation) {
    case Interpolation::step:
      return "STEP";
    case Interpolation::linear:
      return "LINEAR";
    case Interpolation::cubic_spline:
      return "CUBICSPLINE";
  }
  return "";
}

const char* path_name(ChannelPath path) {
  switch (path) {
    case ChannelPath::translation:
      return "translation";
    case ChannelPath::rotation:
      return "rotation";
    case ChannelPath::scale:
      return "scale";
    case ChannelPath::weights:
      return "weights";
  }
  return "";
}

AccessorShape output_shape(ChannelPath path) {
  if (path == ChannelPath::weights) return AccessorShape::scalar;
  return path == ChannelPath::rotation ? AccessorShape::vec4 : AccessorShape::vec3;
}

/// Writes one clip; key times that several channels share are stored once.
class ClipWriter {
 public:
  ClipWriter(const Model& model, const RigLayout& layout, std::map<std::vector<double>, int>& times, GlbBuilder& glb)
      : model_(model), layout_(layout), times_(times), glb_(glb) {}

  Json written(const std::string& place, const Clip& clip) {
    for (std::size_t i = 0; i < clip.channels.size(); ++i)
      if (const int node = target(clip.channels[i]); node >= 0)
        add(fmt::format("{}/samplers/{}", place, samplers_.size()), clip.channels[i], node);
    if (channels_.empty()) return {};
    Json out;
    if (!clip.name.empty()) out["name"] = clip.name;
    out["channels"] = std::move(channels_);
    out["samplers"] = std::move(samplers_);
    return out;
  }

 private:
  /// The written node that the channel animates, or -1 where it animates nothing that is there.
  int target(const Channel& channel) const {
    if (channel.times.empty()) return -1;
    if (channel.path == ChannelPath::weights) {
      const int node = layout_.drawing_node[channel.node];
      if (node < 0) return -1;
      const Mesh& mesh = model_.meshes[model_.nodes[channel.node].mesh];
      const std::size_t targets = mesh.primitives.front().morph_targets.size();
      return targets != 0 && targets == channel.width ? node : -1;
    }
    // A sheared node keeps its matrix's scale whatever the clip says.
    if (channel.path == ChannelPath::scale && model_.nodes[channel.node].matrix) return -1;
    return layout_.moved_node[channel.node];
  }

  void add(const std::string& place, const Channel& channel, int node) {
    Interpolation interpolation = channel.interpolation;
    std::vector<float> values(channel.values.begin(), channel.values.end());
    if (interpolation == Interpolation::cubic_spline && channel.times.size() == 1) {
      // glTF asks for two keys of a spline; one key holds its value for ever, as a step does.
      values = {values.begin() + channel.width, values.begin() + 2 * channel.width};
      interpolation = Interpolation::step;
    }
    Json sampler;
    sampler["input"] = input(place, channel.times);
    sampler["output"] = glb_.add_floats(place + "/output", values, output_shape(channel.path), ViewTarget::none);
    sampler["interpolation"] = interpolation_name(interpolation);
    channels_.push_back(
        {{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", path_name(channel.path)}}}});
    samplers_.push_back(std::move(sampler));
  }

  int input(const std::string& place, const std::vector<double>& seconds) {
    const auto [known, is_new] = times_.try_emplace(seconds, -1);
    if (is_new) known->second = add_times(place + "/input", seconds, glb_);
    return known->second;
  }

  const Model& model_;
  const RigLayout& layout_;
  std::map<std::vector<double>, int>& times_;
  GlbBuilder& glb_;
  Json channels_ = Json::array(), samplers_ = Json::array();
};

}  // namespace

int add_times(const std::string& place, std::span<const double> seconds, GlbBuilder& glb) {
  const std::vector<float> times(seconds.begin(), seconds.end());
  if (times.front() < 0)
    glb.fail(fmt::format("{}: the first key is at {} seconds; glTF's key times start at 0 or later", place, times[0]));
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1]))
      glb.fail(
          fmt::format("{}: key {} at {} seconds does not come after key {} at {} as a 32-bit float; key times rise",
                      place, i, times[i], i - 1, times[i - 1]));
  return glb.add_floats(place, times, AccessorShape::scalar, ViewTarget::none, AccessorBounds::written);
}

Json written_clips(const Model& model, const RigLayout& layout, GlbBuilder& glb) {
  Json clips = Json::array();
  std::map<std::vector<double>, int> times;
  for (const Clip& clip : model.clips) {
    Json written = ClipWriter(model, layout, times, glb).written(fmt::format("animations/{}", clips.size()), clip);
    if (!written.is_null()) clips.push_back(std::move(written));
  }
  return clips;
}

}  // namespace sinew
