#include "engine/body/muscle_placement.h"

#include "engine/model/scene_words.h"

namespace sinew {
namespace {

/// A rest pose bent by more than this shows by itself which side flexes.
constexpr double telling_bend_degrees = 5.0;

/// Numbers of a preset, in units of the limb: L its length, r its radius at the belly. engine/definitions.md 7.
struct PresetShape {
  HumanoidBone left_bone, left_child;
  double from, to, spread;
  double peak_radii;
  double sigma_along_lengths, sigma_across_radii;
  double reference_angle;
};

PresetShape preset_shape(MusclePreset preset) {
  switch (preset) {
    case MusclePreset::biceps:
      return {HumanoidBone::left_upper_arm, HumanoidBone::left_lower_arm, 1.0 / 3.0, 1.0, 75.0, 0.30, 0.20, 0.70, 35.0};
    case MusclePreset::calf:
      return {HumanoidBone::left_lower_leg, HumanoidBone::left_foot, 0.05, 0.60, 60.0, 0.12, 0.15, 0.70, 150.0};
  }
  return {};
}

std::string bone_name(HumanoidBone left_bone, MuscleSide side) {
  return std::string(humanoid_name(side == MuscleSide::left ? left_bone : mirrored_bone(left_bone)));
}

/// Towards the inside of the bend at the bone's far end, across the bone; nothing where the limb is straight.
std::optional<Vec3> flexor_side(const PlacementContext& character, const Muscle& muscle, const JointAngle& driver) {
  const std::vector<Mat4>& global = character.rest.global;
  if (driver.at != muscle.child || 180.0 - driver.degrees(global) < telling_bend_degrees) return std::nullopt;
  const Vec3 axis = glm::normalize(Vec3(global[muscle.child][3]) - Vec3(global[muscle.bone][3]));
  const Vec3 beyond = Vec3(global[driver.after][3]) - Vec3(global[muscle.child][3]);
  return unit_or(beyond - glm::dot(beyond, axis) * axis, Vec3(0.0));
}

Vec3 preset_facing(const PlacementContext& character, MusclePreset preset, const Muscle& muscle,
                   const JointAngle& driver) {
  const Vec3 front = body_front(character.model, character.humanoid, character.rest.global);
  if (preset == MusclePreset::calf) return -front;
  return flexor_side(character, muscle, driver).value_or(front);
}

/// Fills in a preset's words where the scene did not say otherwise; numbers that need the limb's measures come later.
MuscleSpec with_preset_joints(MuscleSpec spec) {
  const PresetShape shape = preset_shape(*spec.preset);
  const MuscleSide side = *spec.side;
  const auto fill = [](auto& field, auto value) {
    if (!field) field = value;
  };
  fill(spec.bone, bone_name(shape.left_bone, side));
  fill(spec.child, bone_name(shape.left_child, side));
  fill(spec.driver, *spec.child);
  fill(spec.from, shape.from);
  fill(spec.to, shape.to);
  fill(spec.spread, shape.spread);
  fill(spec.reference_angle, shape.reference_angle);
  return spec;
}

Result<void> resolve_joints(const PlacementContext& character, const MuscleSpec& spec, Muscle& muscle) {
  const auto resolve = [&](const std::optional<std::string>& name, int& node) -> Result<void> {
    if (!name) return {};
    auto found = find_joint(character.model, character.humanoid, *name);
    if (!found) return bad_input("muscle \"{}\": {}", muscle.name, found.error().message);
    node = *found;
    return {};
  };
  if (auto ok = resolve(spec.bone, muscle.bone); !ok) return ok;
  if (auto ok = resolve(spec.child, muscle.child); !ok) return ok;
  muscle.driver = muscle.child;
  if (auto ok = resolve(spec.driver, muscle.driver); !ok) return ok;
  return resolve(spec.tip, muscle.tip);
}

}  // namespace

Result<PlacedMuscle> place_muscle(const PlacementContext& character, const MuscleSpec& stated) {
  const MuscleSpec spec = stated.preset ? with_preset_joints(stated) : stated;
  PlacedMuscle placed;
  Muscle& muscle = placed.muscle;
  muscle.name = muscle_name(spec);
  if (auto ok = resolve_joints(character, spec, muscle); !ok) return pass_on(std::move(ok));

  const auto driver = driver_angle(character.model, character.humanoid, muscle.driver, muscle.tip);
  if (!driver)
    return bad_input(
        "muscle \"{}\": no angle can be measured at its driver \"{}\": there is no joint before or after it; "
        "name another driver, or a tip",
        muscle.name, character.model.nodes[muscle.driver].name);
  placed.driver = *driver;
  muscle.tip = driver->after;
  muscle.from = *spec.from;
  muscle.to = *spec.to;
  muscle.spread = *spec.spread;
  muscle.facing = spec.facing ? *spec.facing : preset_facing(character, *spec.preset, muscle, *driver);
  muscle.reference_angle = *spec.reference_angle;
  muscle.rest_angle = spec.rest_angle ? *spec.rest_angle : driver->degrees(character.rest.global);
  if (std::abs(muscle.rest_angle - muscle.reference_angle) < 1e-6)
    return bad_input("muscle \"{}\": its rest angle and its reference angle are both {} degrees; they must differ",
                     muscle.name, muscle.rest_angle);

  if (muscle.from >= muscle.to)
    return bad_input("muscle \"{}\": its region runs from {} to {}; from must be less than to", muscle.name,
                     muscle.from, muscle.to);
  auto region = muscle_region(character.model, character.mesh, character.rest, muscle);
  if (!region) return pass_on(std::move(region));
  placed.region = std::move(*region);
  if (spec.preset) {
    const PresetShape shape = preset_shape(*spec.preset);
    const double r = limb_radius(character.model, character.mesh, character.rest, muscle, placed.region);
    muscle.peak = shape.peak_radii * r;
    // Without a vertex to measure there is nothing to swell either; any width but 0 will do.
    muscle.sigma = {shape.sigma_along_lengths * placed.region.plane.length,
                    std::max(shape.sigma_across_radii * r, 1e-9)};
  }
  if (spec.peak) muscle.peak = *spec.peak;
  if (spec.sigma) muscle.sigma = *spec.sigma;
  return placed;
}

std::vector<PlacedMuscle> default_muscles(const PlacementContext& character, std::vector<std::string>& problems) {
  std::vector<PlacedMuscle> muscles;
  if (!character.humanoid.complete() || character.mesh.vertices() == 0) return muscles;
  for (const MusclePreset preset : {MusclePreset::biceps, MusclePreset::calf}) {
    for (const MuscleSide side : {MuscleSide::left, MuscleSide::right}) {
      MuscleSpec spec;
      spec.preset = preset;
      spec.side = side;
      auto placed = place_muscle(character, spec);
      if (placed) {
        muscles.push_back(std::move(*placed));
      } else {
        problems.push_back(placed.error().message);
      }
    }
  }
  return muscles;
}

}  // namespace sinew
