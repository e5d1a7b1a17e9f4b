#include "engine/fit/example_poses.h"

#include <algorithm>

#include "engine/core/interrupt.h"
#include "engine/deform/morph.h"
#include "engine/deform/ssd.h"
#include "engine/io/mesh_read.h"
#include "engine/rig/clip_sampling.h"

namespace sinew {
namespace {

/// Keys that are no farther apart are one key: two channels' times after rounding.
constexpr double same_time = 1e-5;

std::array<std::uint32_t, 3> corners(const std::vector<std::uint32_t>& triangles, std::size_t i) {
  std::array<std::uint32_t, 3> sorted{triangles[i], triangles[i + 1], triangles[i + 2]};
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

Result<void> check_topology(const std::string& file, const CharacterMesh& mesh, const SkinnedShape& rest) {
  if (mesh.vertices() != rest.positions.size() || mesh.triangles.size() != rest.triangles.size())
    return bad_input(
        "{}: has {} vertices and {} triangles, the rest mesh {} and {}; expected the same topology in every pose", file,
        mesh.vertices(), mesh.triangles.size() / 3, rest.positions.size(), rest.triangles.size() / 3);
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3)
    if (corners(mesh.triangles, i) != corners(rest.triangles, i))
      return bad_input(
          "{}: triangle {} joins vertices {}, in the rest mesh {}; expected the same topology in every pose", file,
          i / 3, fmt::join(corners(mesh.triangles, i), ", "), fmt::join(corners(rest.triangles, i), ", "));
  return {};
}

/// Deforms a model in one pose after the other.
class PosedMesh {
 public:
  explicit PosedMesh(const Model& model)
      : model_(model),
        mesh(character_mesh(model)),
        order_(hierarchy_order(model)),
        positions_(mesh.vertices()),
        normals_(mesh.vertices()) {}

  const std::vector<Vec3>& places(const Pose& pose) {
    const MorphedVertices morphed = morph(mesh, morph_slot_weights(mesh, pose));
    const std::vector<Mat34> palette = palette_transforms(mesh, global_transforms(model_, order_, pose));
    SsdJob{{morphed.positions, morphed.normals, palette, mesh.influences}, {positions_, normals_, {}}}.run();
    return positions_;
  }

 private:
  const Model& model_;

 public:
  const CharacterMesh mesh;

 private:
  std::vector<int> order_;
  std::vector<Vec3> positions_, normals_;
};

/// A pose after the other into the order that fits ask for.
void put(const std::vector<Vec3>& posed, std::size_t pose, ExamplePoses& out) {
  const std::size_t poses = out.seconds.size();
  out.places.resize(posed.size() * poses);
  for (std::size_t v = 0; v < posed.size(); ++v) out.places[v * poses + pose] = posed[v];
}

std::vector<double> key_times(const Clip& clip) {
  std::vector<double> times;
  for (const Channel& channel : clip.channels) times.insert(times.end(), channel.times.begin(), channel.times.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end(), [](double a, double b) { return b - a <= same_time; }),
              times.end());
  return times;
}

std::vector<double> frame_times(const ExampleFiles& files, std::size_t count) {
  std::vector<double> seconds;
  for (std::size_t i = 0; i < count; ++i)
    seconds.push_back((files.frames ? static_cast<double>((*files.frames)[i]) : static_cast<double>(i)) / files.fps);
  return seconds;
}

Result<void> check_count(const std::string& file, std::size_t poses) {
  if (poses <= most_example_poses) return {};
  return bad_input("{}: {} poses; expected at most {}; --frames takes fewer", file, poses, most_example_poses);
}

Result<ExamplePoses> poses_of_animation(const Model& model, const ExampleFiles& files, const SkinnedShape& rest) {
  if (model.clips.empty())
    return bad_input("{}: is not animated; expected a clip whose keys are the example poses", model.file);
  const auto named = std::find_if(model.clips.begin(), model.clips.end(),
                                  [&](const Clip& clip) { return !files.clip.empty() && clip.name == files.clip; });
  const Clip& clip = named == model.clips.end() ? model.clips.front() : *named;
  PosedMesh posed(model);
  if (auto ok = check_topology(model.file, posed.mesh, rest); !ok) return pass_on(std::move(ok));
  ExamplePoses out;
  out.seconds = files.frames ? frame_times(files, files.frames->size()) : key_times(clip);
  if (auto ok = check_count(model.file, out.seconds.size()); !ok) return pass_on(std::move(ok));
  for (std::size_t k = 0; k < out.seconds.size(); ++k) {
    if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
    Pose pose = rest_pose(model);
    sample_clip(clip, out.seconds[k], pose);
    put(posed.places(pose), k, out);
  }
  return out;
}

}  // namespace

Result<ExamplePoses> read_example_poses(const ExampleFiles& files, const SkinnedShape& rest) {
  if (files.files.size() == 1 && !is_polygon_file(files.files.front())) {
    const auto model = read_mesh(files.files.front());
    if (!model) return tl::unexpected<Error>(model.error());
    return poses_of_animation(*model, files, rest);
  }
  const std::string first = files.files.empty() ? "" : files.files.front().string();
  if (files.frames && files.frames->size() != files.files.size())
    return bad_input("{}: {} frames for {} files; expected a frame a file", first, files.frames->size(),
                     files.files.size());
  if (auto ok = check_count(first, files.files.size()); !ok) return pass_on(std::move(ok));
  ExamplePoses out;
  out.seconds = frame_times(files, files.files.size());
  for (std::size_t k = 0; k < files.files.size(); ++k) {
    if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
    const auto model = read_mesh(files.files[k]);
    if (!model) return tl::unexpected<Error>(model.error());
    PosedMesh posed(*model);
    if (auto ok = check_topology(files.files[k].string(), posed.mesh, rest); !ok) return pass_on(std::move(ok));
    put(posed.places(rest_pose(*model)), k, out);
  }
  return out;
}

}  // namespace sinew
