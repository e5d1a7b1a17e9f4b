#include "engine/fit/round_trip.h"

#include <set>

#include "engine/fit/random_poses.h"
#include "engine/fit/skinned_shape.h"

namespace sinew {
namespace {

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

/// Of the poses that the fit does not see.
struct TestErrors {
  double squared = 0.0;
  std::size_t places = 0;
};

Result<void> fit_again(const Model& character, const SkinnedShape& source, std::span<const Pose> poses,
                       std::span<const Pose> tests, const SkinnedShape& shape, const RoundTripOptions& options,
                       RandomNumbers& random, Model& rest, TestErrors& errors, FitReport& report) {
  const BonePoses bones = bone_poses(character, source.skin, poses);
  std::vector<Vec3> wanted = skinned_places(source.positions, source.influences, bones);
  if (options.noise > 0.0)
    for (Vec3& place : wanted)
      for (int i = 0; i < 3; ++i) place[i] += 1e-3 * options.noise * random.normal();
  const auto influences = fit_shape(rest, shape, bones, wanted, options, report);
  if (!influences) return tl::unexpected<Error>(influences.error());
  if (!tests.empty()) {
    const BonePoses unseen = bone_poses(character, source.skin, tests);
    const std::vector<Vec3> truth = skinned_places(source.positions, source.influences, unseen);
    const std::vector<Vec3> guess = skinned_places(shape.positions, *influences, unseen);
    for (std::size_t i = 0; i < truth.size(); ++i) errors.squared += squared_distance(truth[i], guess[i]);
    errors.places += truth.size();
  }
  set_influences(shape, *influences, rest);
  return {};
}

}  // namespace

Result<FitReport> fit_round_trip(const Model& character, const RoundTripOptions& options, Model& rest) {
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

  FitReport report;
  report.poses = options.poses;
  report.bones = turned.size();
  report.measure(bounds);
  TestErrors errors;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (auto ok = fit_again(character, sources[i], poses, tests, shapes[i], options, random, rest, errors, report); !ok)
      return pass_on(std::move(ok));
  if (errors.places > 0) report.test_rmse = std::sqrt(errors.squared / static_cast<double>(errors.places));
  return report;
}

}  // namespace sinew
