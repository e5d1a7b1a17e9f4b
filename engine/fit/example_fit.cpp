#include "engine/fit/example_fit.h"

#include <chrono>

#include "engine/fit/bound_model.h"
#include "engine/fit/found_bones.h"
#include "engine/fit/surface_graph.h"
#include "engine/fit/weight_run.h"
#include "engine/io/mesh_read.h"
#include "engine/rig/clip_sampling.h"

namespace sinew {
namespace {

/// The file that has the skeleton: the one that was named, else animated poses, else the rest mesh.
Result<Model> read_skeleton(const ExampleFitOptions& options, const Model& rest) {
  if (!options.skeleton.empty()) return read_mesh(options.skeleton);
  if (options.poses.files.size() == 1 && !is_polygon_file(options.poses.files.front())) {
    auto animated = read_mesh(options.poses.files.front());
    if (!animated || !animated->skins.empty()) return animated;
  }
  if (!rest.skins.empty()) return rest;
  return bad_input("{}: neither it nor the poses have a skeleton; expected --skeleton FILE, or --bones unknown",
                   rest.file);
}

bool is_pose_file(const ExampleFitOptions& options) {
  std::error_code none;
  return options.poses.files.size() == 1 &&
         std::filesystem::equivalent(options.rest, options.poses.files.front(), none);
}

Result<std::vector<Pose>> clip_poses(const Model& skeleton, const Model& bound, const ClipChoice& choice,
                                     std::span<const double> seconds) {
  if (bound.clips.empty())
    return bad_input("{}: has no clip; expected one that says where the bones are in the poses", skeleton.file);
  const auto clip = find_clip(skeleton, choice);
  if (!clip) return tl::unexpected<Error>(clip.error());
  std::vector<Pose> poses(seconds.size(), rest_pose(bound));
  for (std::size_t k = 0; k < seconds.size(); ++k) sample_clip(bound.clips[*clip], seconds[k], poses[k]);
  return poses;
}

FitReport measured(const SkinnedShape& shape, std::size_t poses, std::size_t bones) {
  FitReport report;
  Bounds bounds;
  for (const Vec3& p : shape.positions) bounds.add(p);
  report.measure(bounds);
  report.poses = poses;
  report.bones = bones;
  return report;
}

Result<ExampleFit> fit_known(const ExampleFitOptions& options, const Model& rest) {
  const auto skeleton = read_skeleton(options, rest);
  if (!skeleton) return tl::unexpected<Error>(skeleton.error());
  auto bound = bound_model(rest, *skeleton, {.morphs = !is_pose_file(options)});
  if (!bound) return pass_on(std::move(bound));
  const SkinnedShape shape = skinned_shapes(*bound).front();
  const auto examples = read_example_poses(options.poses, shape);
  if (!examples) return tl::unexpected<Error>(examples.error());
  const auto poses = clip_poses(*skeleton, *bound, options.clip, examples->seconds);
  if (!poses) return tl::unexpected<Error>(poses.error());
  const BonePoses bones = bone_poses(*bound, 0, *poses);
  ExampleFit out{std::move(*bound), measured(shape, bones.poses, bones.bones)};
  const auto influences = fit_shape(out.model, shape, bones, examples->places, options, out.report);
  if (!influences) return tl::unexpected<Error>(influences.error());
  set_influences(shape, *influences, out.model);
  return out;
}

Result<ExampleFit> fit_unknown(const ExampleFitOptions& options, const Model& rest) {
  Model still;
  still.nodes.emplace_back().name = "root";
  still.roots = {0};
  const auto alone = bound_model(rest, still, {.morphs = !is_pose_file(options)});
  if (!alone) return tl::unexpected<Error>(alone.error());
  const SkinnedShape shape = skinned_shapes(*alone).front();
  const auto examples = read_example_poses(options.poses, shape);
  if (!examples) return tl::unexpected<Error>(examples.error());

  RigidBonesJob job{shape.positions, examples->places, shape.triangles, examples->seconds.size()};
  job.count = options.unknown_bones;
  job.influences = options.influences;
  job.rounds = options.iterations;
  Progress progress("finding bones", job.rounds + 1, options.progress);
  job.advance = [&progress] { progress.advance(); };
  const auto start = std::chrono::steady_clock::now();
  auto found = job.run();
  if (!found) return failure(found.error().kind, "{}: {}", rest.file, found.error().message);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;

  auto bound =
      bound_model(rest, found_skeleton(*found, shape.positions, examples->seconds), {.morphs = !is_pose_file(options)});
  if (!bound) return pass_on(std::move(bound));
  ExampleFit out{std::move(*bound), measured(shape, job.poses, job.count)};
  out.report.milliseconds = time.count();
  out.report.max_influences = most_influences(found->influences);
  const SurfaceGraph graph = surface_graph(shape.positions, shape.triangles);
  report_errors(out.model, shape, skinned_places(shape.positions, found->influences, found->bones), examples->places,
                graph.shell, out.report);
  set_influences(shape, found->influences, out.model);
  return out;
}

}  // namespace

Result<ExampleFit> fit_examples(const ExampleFitOptions& options) {
  const auto rest = read_mesh(options.rest);
  if (!rest) return tl::unexpected<Error>(rest.error());
  return options.unknown_bones > 0 ? fit_unknown(options, *rest) : fit_known(options, *rest);
}

}  // namespace sinew
