#include "engine/fit/mirrored_weights.h"

#include <algorithm>

#include "engine/core/text.h"
#include "engine/fit/closest_surface.h"
#include "engine/fit/weight_run.h"
#include "engine/rig/humanoid.h"
#include "engine/rig/pose.h"

namespace sinew {
namespace {

constexpr double partner_share = 0.02;
constexpr double middle_share = 1e-3;

std::vector<Mat4> rest_global(const Model& model) {
  return global_transforms(model, hierarchy_order(model), rest_pose(model));
}

/// A name with its side exchanged: words in full, and single letters between marks.
std::string exchanged(const std::string& name) {
  std::string out = lower(name);
  for (const auto& [a, b] : {std::pair<std::string, std::string>{"left", "right"}, {"right", "left"}})
    if (const std::size_t at = out.find(a); at != std::string::npos) return out.replace(at, a.size(), b);
  const auto mark = [&](std::size_t i) { return i >= out.size() || out[i] == '_' || out[i] == '.' || out[i] == '-'; };
  for (std::size_t i = 0; i < out.size(); ++i)
    if ((out[i] == 'l' || out[i] == 'r') && mark(i + 1) && (i == 0 || mark(i - 1))) {
      out[i] = out[i] == 'l' ? 'r' : 'l';
      return out;
    }
  return out;
}

struct Mirror {
  MirrorPlane plane;
  std::vector<int> partner;
  double band = 0.0;  ///< half width of the middle
};

Result<Mirror> mirror_of(const Model& model, const SkinnedShape& shape) {
  const Skin& skin = model.skins[shape.skin];
  Mirror mirror{mirror_plane(model), {}, 0.0};
  mirror.partner = mirror_joints(model, skin, mirror.plane);
  Bounds bounds;
  for (const Vec3& p : shape.positions) bounds.add(p);
  mirror.band = middle_share * bounds.diagonal();
  std::vector<char> used(skin.joints.size());
  for (const Influence& influence : shape.influences.entries) used[influence.joint] = 1;
  for (std::size_t j = 0; j < used.size(); ++j)
    if (used[j] && mirror.partner[j] < 0)
      return bad_input("{}: joint \"{}\" has no partner on the other side; expected a skeleton that is symmetric",
                       model.file, model.nodes[skin.joints[j]].name);
  return mirror;
}

std::vector<Influence> exchanged(std::vector<Influence> run, const std::vector<int>& partner) {
  for (Influence& influence : run) influence.joint = static_cast<std::uint32_t>(partner[influence.joint]);
  return run;
}

}  // namespace

MirrorPlane mirror_plane(const Model& model) {
  const std::vector<Mat4> global = rest_global(model);
  const Humanoid humanoid = find_humanoid(model, global);
  MirrorPlane plane{body_left(model, humanoid, global), 0.0};
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < humanoid_bone_count; ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    const int other = humanoid.find(mirrored_bone(bone));
    if (mirrored_bone(bone) == bone || humanoid.node[i] < 0 || other < 0) continue;
    sum += glm::dot(Vec3(global[humanoid.node[i]][3]), plane.left);
    ++count;
  }
  if (count > 0) plane.middle = sum / static_cast<double>(count);
  return plane;
}

std::vector<int> mirror_joints(const Model& model, const Skin& skin, const MirrorPlane& plane) {
  const std::vector<Mat4> global = rest_global(model);
  const Humanoid humanoid = find_humanoid(model, global);
  Bounds bounds;
  for (const int node : skin.joints) bounds.add(Vec3(global[node][3]));
  const double reach = partner_share * bounds.diagonal();
  const auto slot = [&](int node) {
    const auto found = std::find(skin.joints.begin(), skin.joints.end(), node);
    return found == skin.joints.end() ? -1 : static_cast<int>(found - skin.joints.begin());
  };
  std::vector<int> partner(skin.joints.size(), -1);
  for (std::size_t i = 0; i < humanoid_bone_count; ++i) {
    const int mine = slot(humanoid.node[i]), theirs = slot(humanoid.find(mirrored_bone(static_cast<HumanoidBone>(i))));
    if (humanoid.node[i] >= 0 && mine >= 0 && theirs >= 0) partner[mine] = theirs;
  }
  for (std::size_t j = 0; j < partner.size(); ++j) {
    if (partner[j] >= 0) continue;
    const Vec3 wanted = plane.mirrored(Vec3(global[skin.joints[j]][3]));
    std::vector<std::string> names;
    std::vector<int> near;
    for (std::size_t i = 0; i < partner.size(); ++i) {
      if (glm::length(Vec3(global[skin.joints[i]][3]) - wanted) > reach) continue;
      near.push_back(static_cast<int>(i));
      names.push_back(model.nodes[skin.joints[i]].name);
    }
    const auto named = nearest_name(exchanged(model.nodes[skin.joints[j]].name), names);
    const auto found = named ? std::find(names.begin(), names.end(), *named) : names.begin();
    if (!near.empty()) partner[j] = near[static_cast<std::size_t>(found - names.begin())];
  }
  return partner;
}

Result<Influences> mirrored_weights(const Model& model, const SkinnedShape& shape, BodySide from) {
  const auto mirror = mirror_of(model, shape);
  if (!mirror) return tl::unexpected<Error>(mirror.error());
  if (shape.triangles.empty()) return bad_input("{}: has no triangles to mirror weights on", model.file);
  const ClosestSurface surface(shape.positions, shape.triangles);
  const double sign = from == BodySide::left ? 1.0 : -1.0;
  std::vector<std::vector<Influence>> runs(shape.positions.size());
  for (std::size_t v = 0; v < runs.size(); ++v) {
    const auto own = influences_of(shape.influences, v);
    const double side = sign * (glm::dot(shape.positions[v], mirror->plane.left) - mirror->plane.middle);
    Mixture mixture;
    if (side > mirror->band) {
      mixture.add(own, 1.0);
    } else if (side >= -mirror->band) {
      mixture.add(own, 0.5);
      mixture.add(exchanged({own.begin(), own.end()}, mirror->partner), 0.5);
    } else {
      const SurfacePoint point = surface.find(mirror->plane.mirrored(shape.positions[v]));
      for (int c = 0; c < 3; ++c) {
        const auto there = influences_of(shape.influences, point.vertex[c]);
        mixture.add(exchanged({there.begin(), there.end()}, mirror->partner), point.share[c]);
      }
    }
    if (auto weights = mixture.list(); !weights.empty()) runs[v] = weight_run(std::move(weights), max_influences);
  }
  return gathered(runs);
}

}  // namespace sinew
