#include "engine/io/gltf_clip.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "engine/io/gltf_access.h"
#include "engine/io/gltf_schema.h"

namespace sinew::gltf {
namespace {

constexpr double unit_tolerance = 1e-3;
constexpr double integer_unit_tolerance = 2e-2;  ///< what normalized bytes can hold

constexpr int float_only[] = {TINYGLTF_COMPONENT_TYPE_FLOAT};
constexpr int any_component[] = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
                                 TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT,
                                 TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};

std::optional<ChannelPath> path_of(const std::string& name) {
  if (name == "translation") return ChannelPath::translation;
  if (name == "rotation") return ChannelPath::rotation;
  if (name == "scale") return ChannelPath::scale;
  if (name == "weights") return ChannelPath::weights;
  return std::nullopt;
}

Interpolation interpolation_of(const std::string& name) {
  if (name == "STEP") return Interpolation::step;
  return name == "CUBICSPLINE" ? Interpolation::cubic_spline : Interpolation::linear;
}

AccessorFormat output_format(ChannelPath path) {
  switch (path) {
    case ChannelPath::rotation:
      return {TINYGLTF_TYPE_VEC4, any_component, "VEC4 of floats, or of normalized bytes or shorts"};
    case ChannelPath::weights:
      return {TINYGLTF_TYPE_SCALAR, any_component, "SCALAR of floats, or of normalized bytes or shorts"};
    default:
      return {TINYGLTF_TYPE_VEC3, float_only, "VEC3 of floats"};
  }
}

/// What was wrong with a channel's keys.
struct KeyFaults {
  std::size_t time = 0, value = 0, zero_rotation = 0, not_unit = 0;
};

/// One channel on its way from the file into the model.
class ChannelReader {
 public:
  ChannelReader(Document& document, const tinygltf::AnimationSampler& sampler, Channel channel, std::string place)
      : document_(document), sampler_(sampler), channel_(std::move(channel)), place_(std::move(place)) {}

  /// Without keys where none was usable.
  Result<Channel> read() {
    auto times = read_accessor(document_, sampler_.input, place_ + " input",
                               {TINYGLTF_TYPE_SCALAR, float_only, "SCALAR of floats"});
    if (!times) return pass_on(std::move(times));
    auto values = read_accessor(document_, sampler_.output, place_ + " output", output_format(channel_.path));
    if (!values) return pass_on(std::move(values));
    channel_.interpolation = interpolation_of(sampler_.interpolation);
    parts_ = channel_.interpolation == Interpolation::cubic_spline ? 3 : 1;
    const std::size_t needed = times->count() * parts_ * channel_.width;
    if (values->values.size() != needed)
      return bad_input("{}: {} keys need {} output numbers, but there are {}", place_, times->count(), needed,
                       values->values.size());
    unit_tolerance_ = values->integer ? integer_unit_tolerance : unit_tolerance;
    for (std::size_t k = 0; k < times->count(); ++k)
      add_key(times->values[k],
              std::span(values->values).subspan(k * parts_ * channel_.width, parts_ * channel_.width));
    report();
    return std::move(channel_);
  }

 private:
  void add_key(double time, std::span<double> values) {
    if (!std::isfinite(time) || (!channel_.times.empty() && time <= channel_.times.back())) {
      ++faults_.time;
    } else if (!std::ranges::all_of(values, [](double x) { return std::isfinite(x); })) {
      ++faults_.value;
    } else if (channel_.path == ChannelPath::rotation && !normalise(values)) {
      ++faults_.zero_rotation;
    } else {
      channel_.times.push_back(time);
      channel_.values.insert(channel_.values.end(), values.begin(), values.end());
    }
  }

  /// Brings the key's quaternion to length 1, its tangents by the same factor; false where it has no direction.
  bool normalise(std::span<double> values) {
    const auto q = parts_ == 3 ? values.subspan(4, 4) : values;
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(length > 1e-12)) return false;
    faults_.not_unit += std::abs(length - 1.0) > unit_tolerance_ ? 1 : 0;
    for (double& x : values) x /= length;
    return true;
  }

  void report() {
    if (faults_.time > 0) document_.problem("{}: {} keys whose times do not rise; dropped", place_, faults_.time);
    if (faults_.value > 0) document_.problem("{}: {} keys are not finite; dropped", place_, faults_.value);
    if (faults_.zero_rotation > 0)
      document_.problem("{}: {} keys with a quaternion of length 0; dropped", place_, faults_.zero_rotation);
    if (faults_.not_unit > 0)
      document_.problem("{}: {} keys with a quaternion not of length 1; normalised", place_, faults_.not_unit);
    if (!channel_.times.empty() && channel_.times[0] < 0.0)
      document_.problem("{}: begins at {:.3g} s, before the clip does", place_, channel_.times[0]);
  }

  Document& document_;
  const tinygltf::AnimationSampler& sampler_;
  Channel channel_;
  std::string place_;
  std::size_t parts_ = 1;  ///< per key: a value, or for splines in-tangent, value, out-tangent
  double unit_tolerance_ = unit_tolerance;
  KeyFaults faults_;
};

/// tinygltf leaves out channels that name no node, as those of KHR_animation_pointer do.
void note_channels_without_node(Document& document, std::size_t animation, const std::string& place) {
  std::size_t without = 0;
  for (const auto& channel : document.source["animations"][animation]["channels"])
    without += find(channel, {"target", "node"}) == nullptr ? 1 : 0;
  if (without > 0) document.problem("{}: {} channels name no node; left out", place, without);
}

class ClipReader {
 public:
  ClipReader(Document& document, const std::vector<Node>& nodes, const std::vector<Mesh>& meshes, std::size_t animation)
      : document_(document),
        nodes_(nodes),
        meshes_(meshes),
        from_(document.gltf.animations[animation]),
        place_(fmt::format("animations/{}", animation)) {}

  Result<Clip> read() {
    Clip clip;
    clip.name = from_.name;
    std::set<std::pair<int, ChannelPath>> driven;
    for (const tinygltf::AnimationChannel& from : from_.channels) {
      auto channel = begin(from);
      if (!channel) continue;
      const std::string place = fmt::format("{}, {} of node {}", place_, from.target_path, from.target_node);
      if (static_cast<std::size_t>(from.sampler) >= from_.samplers.size())
        return bad_input("{}: refers to sampler {}, but there are {}", place, from.sampler, from_.samplers.size());
      if (!driven.insert({channel->node, channel->path}).second) {
        document_.problem("{}: has two channels; the first stands", place);
        continue;
      }
      auto read =
          ChannelReader(document_, from_.samplers[static_cast<std::size_t>(from.sampler)], std::move(*channel), place)
              .read();
      if (!read) return pass_on(std::move(read));
      add(clip, std::move(*read), place);
    }
    return clip;
  }

 private:
  /// The channel without its keys; nothing where it drives what no model has.
  std::optional<Channel> begin(const tinygltf::AnimationChannel& from) {
    const auto path = path_of(from.target_path);
    if (!path) {
      document_.problem(
          "{}: a channel on \"{:.40}\" of node {}; only translation, rotation, scale and weights are read", place_,
          from.target_path, from.target_node);
      return std::nullopt;
    }
    Channel channel;
    channel.node = from.target_node;
    channel.path = *path;
    channel.width = *path == ChannelPath::rotation ? 4 : 3;
    const Node& node = nodes_[static_cast<std::size_t>(from.target_node)];
    if (*path == ChannelPath::weights) {
      channel.width = node.mesh < 0 ? 0 : meshes_[static_cast<std::size_t>(node.mesh)].morph_weights.size();
      if (channel.width == 0) {
        document_.problem("{}: a channel on the weights of node {}, which has no morph targets; left out", place_,
                          from.target_node);
        return std::nullopt;
      }
    } else if (!document_.gltf.nodes[static_cast<std::size_t>(from.target_node)].matrix.empty()) {
      document_.problem("{}: moves node {}, whose rest is a matrix; glTF does not allow both", place_,
                        from.target_node);
    }
    return channel;
  }

  void add(Clip& clip, Channel channel, const std::string& place) {
    if (channel.times.empty()) {
      document_.problem("{}: no key is usable; left out", place);
      return;
    }
    clip.duration = std::max(clip.duration, channel.times.back());
    clip.channels.push_back(std::move(channel));
  }

  Document& document_;
  const std::vector<Node>& nodes_;
  const std::vector<Mesh>& meshes_;
  const tinygltf::Animation& from_;
  std::string place_;
};

}  // namespace

Result<std::vector<Clip>> read_clips(Document& document, const std::vector<Node>& nodes,
                                     const std::vector<Mesh>& meshes) {
  std::vector<Clip> clips;
  for (std::size_t i = 0; i < document.gltf.animations.size(); ++i) {
    note_channels_without_node(document, i, fmt::format("animations/{}", i));
    auto clip = ClipReader(document, nodes, meshes, i).read();
    if (!clip) return pass_on(std::move(clip));
    clips.push_back(std::move(*clip));
  }
  return clips;
}

}  // namespace sinew::gltf
