#include "engine/body/muscle_spec.h"

namespace sinew {
namespace {

/// A name by which find_joint() finds the node; nothing where there is none.
std::optional<std::string> name_of(const PlacementContext& character, int node) {
  const auto finds_it = [&](const std::string& name) {
    const auto found = find_joint(character.model, character.humanoid, name);
    return found && *found == node;
  };
  for (std::size_t i = 0; i < humanoid_bone_count; ++i)
    if (character.humanoid.node[i] == node)
      if (const std::string name(humanoid_name(static_cast<HumanoidBone>(i))); finds_it(name)) return name;
  const std::string& name = character.model.nodes[node].name;
  if (!name.empty() && finds_it(name)) return name;
  return std::nullopt;
}

}  // namespace

Result<MuscleSpec> explicit_muscle(const PlacementContext& character, const PlacedMuscle& placed) {
  const Muscle& muscle = placed.muscle;
  MuscleSpec spec;
  const auto require = [&](std::optional<std::string>& name, int node) -> Result<void> {
    name = name_of(character, node);
    if (!name)
      return bad_input(
          "{}: nodes/{}: a scene cannot name this joint of the muscle \"{}\": its name \"{}\" is empty or "
          "another node's too; give it a name of its own",
          character.model.file, node, muscle.name, character.model.nodes[node].name);
    return {};
  };
  spec.name = muscle.name;
  if (auto ok = require(spec.bone, muscle.bone); !ok) return pass_on(std::move(ok));
  if (auto ok = require(spec.child, muscle.child); !ok) return pass_on(std::move(ok));
  if (auto ok = require(spec.driver, muscle.driver); !ok) return pass_on(std::move(ok));
  // Neighbours of the driver that go without saying need no name.
  const auto neighbours = driver_angle(character.model, character.humanoid, muscle.driver);
  if (!neighbours || neighbours->before != muscle.before)
    if (auto ok = require(spec.before, muscle.before); !ok) return pass_on(std::move(ok));
  spec.tip = name_of(character, muscle.tip);
  if (!spec.tip && (!neighbours || neighbours->after != muscle.tip))
    if (auto ok = require(spec.tip, muscle.tip); !ok) return pass_on(std::move(ok));
  for (const int node : muscle.except) {
    std::optional<std::string> name;
    if (auto ok = require(name, node); !ok) return pass_on(std::move(ok));
    if (!spec.except) spec.except.emplace();
    spec.except->push_back(*name);
  }
  spec.facing = placed.region.plane.normal;
  spec.from = muscle.from;
  spec.to = muscle.to;
  spec.spread = muscle.spread;
  spec.peak = muscle.peak;
  spec.sigma = muscle.sigma;
  spec.rest_angle = muscle.rest_angle;
  spec.reference_angle = muscle.reference_angle;
  spec.on = muscle.on;
  return spec;
}

}  // namespace sinew
