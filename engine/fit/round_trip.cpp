#include "engine/fit/round_trip.h"

#include <algorithm>
#include <chrono>
#include <set>

#include "engine/fit/random_poses.h"
#include "engine/fit/skinned_shape.h"

namespace sinew {
namespace {

constexpr std::size_t most_worst = 10;

/// Errors summed up over skins, before they are ordered.
struct Errors {
  double squared = 0.0, test_squared = 0.0;
  std::size_t places = 0, test_places = 0;
};

std::string mesh_name(const Model& model, const ShapePart& part) {
  const std::string& name = model.meshes[part.mesh].name;
  return name.empty() ? fmt::format("meshes/{}", part.mesh) : name;
}

Result<void> check_same(const Model& rest, const std::vector<SkinnedShape>& mine, const Model& character,
                        const std::vector<SkinnedShape>& theirs) {
  if (mine.empty()) return bad_input("{}: nothing in it is skinned; expected a mesh with a skeleton", rest.file);
  if (theirs.empty()) return bad_input("{}: nothing in it is skinned; expected a mesh with a skeleton", character.file);
  if (mine.size() != theirs.size())
    return bad_input("{}: {} skins are drawn, {} in {}; expected the same", rest.file, mine.size(), theirs.size(),
                     character.file);
  for (std::size_t i = 0; i < mine.size(); ++i) {
    if (mine[i].positions.size() != theirs[i].positions.size() || mine[i].triangles != theirs[i].triangles)
      return bad_input("{}, skins/{}: {} vertices and {} triangles, {} and {} in {}; expected the same topology",
                       rest.file, mine[i].skin, mine[i].positions.size(), mine[i].triangles.size() / 3,
                       theirs[i].positions.size(), theirs[i].triangles.size() / 3, character.file);
    const auto &joints = rest.skins[mine[i].skin].joints, &others = character.skins[theirs[i].skin].joints;
    if (joints.size() != others.size())
      return bad_input("{}, skins/{}: {} joints, {} in {}; expected the same skeleton", rest.file, mine[i].skin,
                       joints.size(), others.size(), character.file);
    for (std::size_t b = 0; b < joints.size(); ++b)
      if (rest.nodes[joints[b]].name != character.nodes[others[b]].name)
        return bad_input("{}, skins/{}/joints/{}: is \"{}\", \"{}\" in {}; expected the same skeleton", rest.file,
                         mine[i].skin, b, rest.nodes[joints[b]].name, character.nodes[others[b]].name, character.file);
  }
  return {};
}

double squared_distance(const Vec3& a, const Vec3& b) { return glm::dot(a - b, a - b); }

/// Compares the fit with the examples: totals, the worst vertices, each shell.
void add_errors(const Model& model, const SkinnedShape& shape, std::span<const Vec3> fitted,
                std::span<const Vec3> wanted, const SkinFitReport& fit, Errors& errors, RoundTripReport& report) {
  const std::size_t poses = wanted.size() / shape.positions.size();
  std::vector<ShellResidual> shells(fit.shells);
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    double squared = 0.0;
    for (std::size_t i = v * poses; i < (v + 1) * poses; ++i) {
      const double one = squared_distance(fitted[i], wanted[i]);
      squared += one;
      report.max_error = std::max(report.max_error, std::sqrt(one));
    }
    errors.squared += squared;
    const std::string mesh = mesh_name(model, shape.part_of(v));
    ShellResidual& shell = shells[fit.shell[v]];
    if (shell.vertices++ == 0) shell.mesh = mesh;
    shell.rmse += squared;
    report.worst.push_back({report.vertices + v, mesh, std::sqrt(squared / static_cast<double>(poses))});
  }
  std::sort(report.worst.begin(), report.worst.end(), [](const WorstVertex& a, const WorstVertex& b) {
    return a.rmse != b.rmse ? a.rmse > b.rmse : a.vertex < b.vertex;
  });
  report.worst.resize(std::min(report.worst.size(), most_worst));
  for (ShellResidual& shell : shells) shell.rmse = std::sqrt(shell.rmse / static_cast<double>(shell.vertices * poses));
  report.shells.insert(report.shells.end(), shells.begin(), shells.end());
  errors.places += wanted.size();
}

void add_reasons(const Model& model, const SkinnedShape& shape, const BonePoses& bones, const SkinFitReport& fit,
                 const Bounds& bounds, RoundTripReport& report) {
  const std::vector<int>& joints = model.skins[shape.skin].joints;
  for (const auto& [bone, like] : bones_moved_alike(bones, bounds))
    report.reasons.push_back(fmt::format("\"{}\" moves like \"{}\" in all poses: their weights cannot be told apart",
                                         model.nodes[joints[bone]].name, model.nodes[joints[like]].name));
  if (fit.undetermined > 0)
    report.reasons.push_back(
        fmt::format("the weights of {} vertices are not determined by {} poses: some of their bones move them alike",
                    fit.undetermined, bones.poses));
}

Result<void> fit_shape(const Model& character, const SkinnedShape& source, std::span<const Pose> poses,
                       std::span<const Pose> tests, const SkinnedShape& shape, const RoundTripOptions& options,
                       RandomNumbers& random, Model& rest, Errors& errors, RoundTripReport& report) {
  const BonePoses bones = bone_poses(character, source.skin, poses);
  std::vector<Vec3> wanted = skinned_places(source.positions, source.influences, bones);
  if (options.noise > 0.0)
    for (Vec3& place : wanted)
      for (int i = 0; i < 3; ++i) place[i] += 1e-3 * options.noise * random.normal();
  SkinFitJob job{shape.positions, wanted, shape.triangles, bones, options.method, options.influences};
  if (auto ok = job.validate(); !ok) return bad_input("{}, skins/{}: {}", rest.file, shape.skin, ok.error().message);
  Progress progress("fitting weights", job.steps(), options.progress);
  job.advance = [&progress] { progress.advance(); };
  SkinFitReport fit;
  const auto start = std::chrono::steady_clock::now();
  const auto influences = job.run(fit);
  if (!influences) return tl::unexpected<Error>(influences.error());
  report.milliseconds += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  Bounds bounds;
  for (const Vec3& p : shape.positions) bounds.add(p);
  add_errors(rest, shape, skinned_places(shape.positions, *influences, bones), wanted, fit, errors, report);
  add_reasons(rest, shape, bones, fit, bounds, report);
  if (!tests.empty()) {
    const BonePoses unseen = bone_poses(character, source.skin, tests);
    const std::vector<Vec3> truth = skinned_places(source.positions, source.influences, unseen);
    const std::vector<Vec3> guess = skinned_places(shape.positions, *influences, unseen);
    for (std::size_t i = 0; i < truth.size(); ++i) errors.test_squared += squared_distance(truth[i], guess[i]);
    errors.test_places += truth.size();
  }
  for (std::size_t v = 0; v < influences->vertices(); ++v)
    report.max_influences =
        std::max<std::size_t>(report.max_influences, influences->first[v + 1] - influences->first[v]);
  report.vertices += shape.positions.size();
  report.noise = std::max(report.noise, fit.noise);
  report.negative += fit.negative;
  report.undetermined += fit.undetermined;
  set_influences(shape, *influences, rest);
  return {};
}

}  // namespace

Result<RoundTripReport> fit_round_trip(const Model& character, const RoundTripOptions& options, Model& rest) {
  const std::vector<SkinnedShape> shapes = skinned_shapes(rest), sources = skinned_shapes(character);
  if (auto ok = check_same(rest, shapes, character, sources); !ok) return pass_on(std::move(ok));
  std::set<int> joints;
  Bounds bounds;
  for (const SkinnedShape& source : sources)
    joints.insert(character.skins[source.skin].joints.begin(), character.skins[source.skin].joints.end());
  for (const SkinnedShape& shape : shapes)
    for (const Vec3& p : shape.positions) bounds.add(p);
  const std::vector<int> turned(joints.begin(), joints.end());
  RandomNumbers random(options.seed);
  const std::vector<Pose> poses = random_poses(character, turned, options.poses, random);
  const std::vector<Pose> tests = random_poses(character, turned, options.test_poses, random);

  RoundTripReport report;
  report.poses = options.poses;
  report.bones = turned.size();
  report.diagonal = bounds.diagonal();
  const Vec3 size = bounds.high - bounds.low;
  report.height = std::max({size.x, size.y, size.z});
  Errors errors;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (auto ok = fit_shape(character, sources[i], poses, tests, shapes[i], options, random, rest, errors, report); !ok)
      return pass_on(std::move(ok));
  report.rmse = std::sqrt(errors.squared / static_cast<double>(errors.places));
  if (errors.test_places > 0)
    report.test_rmse = std::sqrt(errors.test_squared / static_cast<double>(errors.test_places));
  std::stable_sort(report.shells.begin(), report.shells.end(),
                   [](const ShellResidual& a, const ShellResidual& b) { return a.rmse > b.rmse; });
  return report;
}

}  // namespace sinew
