#include "engine/fit/found_bones.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "engine/fit/weight_run.h"

namespace sinew {
namespace {

std::vector<Vec3> middles(const RigidBones& found, std::span<const Vec3> rest) {
  std::vector<Vec3> middle(found.bones.bones, Vec3(0.0));
  std::vector<double> weight(found.bones.bones);
  for (std::size_t v = 0; v < rest.size(); ++v)
    for (const Influence& influence : influences_of(found.influences, v)) {
      middle[influence.joint] += influence.weight * rest[v];
      weight[influence.joint] += influence.weight;
    }
  for (std::size_t b = 0; b < middle.size(); ++b)
    if (weight[b] > 0.0) middle[b] /= weight[b];
  return middle;
}

void add_keys(const BonePoses& bones, std::size_t bone, const Vec3& middle, std::span<const double> seconds, int node,
              Clip& clip) {
  Channel move{node, ChannelPath::translation, Interpolation::linear, 3, {seconds.begin(), seconds.end()}, {}};
  Channel turn{node, ChannelPath::rotation, Interpolation::linear, 4, move.times, {}};
  Quat last(1, 0, 0, 0);
  for (std::size_t k = 0; k < bones.poses; ++k) {
    const Mat34& f = bones.at(bone, k);
    const Vec3 at = f.transform_point(middle);
    Quat q = glm::normalize(glm::quat_cast(f.linear()));
    if (glm::dot(q, last) < 0.0) q = -q;
    last = q;
    move.values.insert(move.values.end(), {at.x, at.y, at.z});
    turn.values.insert(turn.values.end(), {q.x, q.y, q.z, q.w});
  }
  clip.channels.push_back(std::move(move));
  clip.channels.push_back(std::move(turn));
}

}  // namespace

Model found_skeleton(const RigidBones& found, std::span<const Vec3> rest, std::span<const double> seconds) {
  Model model;
  model.nodes.emplace_back().name = "root";
  model.roots = {0};
  Clip clip;
  clip.name = "found";
  clip.duration = seconds.empty() ? 0.0 : seconds.back();
  Skin skin;
  skin.name = "found";
  const std::vector<Vec3> middle = middles(found, rest);
  for (std::size_t b = 0; b < middle.size(); ++b) {
    const int node = static_cast<int>(model.nodes.size());
    Node& joint = model.nodes.emplace_back();
    joint.name = fmt::format("bone_{:02}", b);
    joint.parent = 0;
    joint.rest.translation = middle[b];
    model.nodes[0].children.push_back(node);
    skin.joints.push_back(node);
    skin.inverse_bind.push_back(glm::translate(Mat4(1.0), -middle[b]));
    add_keys(found.bones, b, middle[b], seconds, node, clip);
  }
  model.skins.push_back(std::move(skin));
  model.clips.push_back(std::move(clip));
  return model;
}

}  // namespace sinew
