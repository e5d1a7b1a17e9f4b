#include "engine/body/muscle_placement.h"

#include <array>

#include "engine/body/belly_side.h"
#include "engine/body/muscle_atlas.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

/// Limbs that have a neighbour under the same bone: below a spine bone all that does not lead to the child is not the
/// muscle's. Bones of the left side; of each pair the first that the model has.
constexpr std::array<std::array<HumanoidBone, 2>, 2> trunk_branches{
    {{HumanoidBone::neck, HumanoidBone::head}, {HumanoidBone::right_shoulder, HumanoidBone::right_upper_arm}}};

bool is_trunk(HumanoidBone bone) {
  return bone == HumanoidBone::spine || bone == HumanoidBone::chest || bone == HumanoidBone::upper_chest;
}

HumanoidBone on_side(HumanoidBone left_bone, MuscleSide side) {
  return side == MuscleSide::left ? left_bone : mirrored_bone(left_bone);
}

/// The node of an atlas bone on a side, or -1. Spines have one to three bones: the nearest below stands in.
int atlas_node(const Humanoid& humanoid, HumanoidBone left_bone, MuscleSide side) {
  HumanoidBone bone = on_side(left_bone, side);
  while (is_trunk(bone) && humanoid.find(bone) < 0 && bone != HumanoidBone::spine) bone = *parent_bone(bone);
  return humanoid.find(bone);
}

/// The spine bone under a shoulder from which a muscle of the breast fans out: the highest that stands clearly below
/// the shoulder, else the lowest. Rigs put the last spine bone anywhere from the ribs to the collar, and an axis that
/// runs level with the shoulder would have the breast beside it.
int fan_origin(const PlacementContext& character, int shoulder) {
  const std::vector<Mat4>& global = character.rest.global;
  const Vec3 up = body_up(character.model, character.humanoid, global);
  int lowest = -1;
  for (const HumanoidBone bone : {HumanoidBone::upper_chest, HumanoidBone::chest, HumanoidBone::spine}) {
    const int node = character.humanoid.find(bone);
    if (node < 0) continue;
    lowest = node;
    const Vec3 way = Vec3(global[shoulder][3]) - Vec3(global[node][3]);
    const double rise = glm::dot(way, up);
    if (rise > 0.6 * glm::length(way - rise * up)) break;
  }
  return lowest;
}

/// Resolves the joints of one muscle, by name where the scene names them and else by preset.
class Joints {
 public:
  Joints(const PlacementContext& character, const MuscleSpec& spec, std::string muscle)
      : character_(character), spec_(spec), muscle_(std::move(muscle)) {}

  Result<void> into(Muscle& muscle) const {
    const AtlasMuscle* preset = spec_.preset ? &atlas_muscle(*spec_.preset) : nullptr;
    using Bone = std::optional<HumanoidBone>;
    if (auto ok = resolve(spec_.bone, preset ? Bone(preset->bone) : Bone(), muscle.bone); !ok) return ok;
    if (auto ok = resolve(spec_.child, preset ? Bone(preset->child) : Bone(), muscle.child); !ok) return ok;
    if (preset && !spec_.bone && is_trunk(preset->bone)) muscle.bone = fan_origin(character_, muscle.child);
    muscle.driver = muscle.child;
    if (preset && !spec_.child) {
      if (auto ok = resolve({}, usable_driver(*preset).joint, muscle.driver); !ok) return ok;
    }
    if (auto ok = resolve(spec_.driver, {}, muscle.driver); !ok) return ok;
    const AtlasDriver* driver = atlas_driver(muscle.driver);
    if (auto ok = resolve(spec_.before, driver ? driver->before : Bone(), muscle.before); !ok) return ok;
    if (auto ok = resolve(spec_.tip, {}, muscle.tip); !ok) return ok;
    return resolve_except(preset, muscle);
  }

  /// What the atlas says about this driver of the preset; null where it says nothing.
  const AtlasDriver* atlas_driver(int node) const {
    if (!spec_.preset) return nullptr;
    for (const AtlasDriver& driver : atlas_muscle(*spec_.preset).drivers)
      if (atlas_node(character_.humanoid, driver.joint, *spec_.side) == node) return &driver;
    return nullptr;
  }

 private:
  /// The first driver of the preset at which this model has an angle; else the first.
  const AtlasDriver& usable_driver(const AtlasMuscle& preset) const {
    for (const AtlasDriver& driver : preset.drivers) {
      const int node = atlas_node(character_.humanoid, driver.joint, *spec_.side);
      if (node >= 0 && driver_angle(character_.model, character_.humanoid, node)) return driver;
    }
    return preset.drivers.front();
  }

  Result<void> resolve(const std::optional<std::string>& name, std::optional<HumanoidBone> preset, int& node) const {
    if (name) {
      auto found = find_joint(character_.model, character_.humanoid, *name);
      if (!found) return bad_input("muscle \"{}\": {}", muscle_, found.error().message);
      node = *found;
    } else if (preset) {
      node = atlas_node(character_.humanoid, *preset, *spec_.side);
      if (node < 0)
        return bad_input(
            "muscle \"{}\": {}: no joint of this model is the humanoid bone \"{}\"; `sinew info` lists the bones it "
            "has",
            muscle_, character_.model.file, humanoid_name(on_side(*preset, *spec_.side)));
    }
    return {};
  }

  Result<void> resolve_except(const AtlasMuscle* preset, Muscle& muscle) const {
    if (spec_.except) {
      for (const std::string& name : *spec_.except)
        if (auto ok = resolve(name, {}, muscle.except.emplace_back(-1)); !ok) return ok;
    } else if (preset && is_trunk(preset->bone)) {
      for (const auto& branch : trunk_branches)
        for (const HumanoidBone bone : branch)
          if (const int node = atlas_node(character_.humanoid, bone, *spec_.side); node >= 0) {
            muscle.except.push_back(node);
            break;
          }
    }
    return {};
  }

  const PlacementContext& character_;
  const MuscleSpec& spec_;
  std::string muscle_;
};

Vec3 facing_of(const PlacementContext& character, const MuscleSpec& spec, const Muscle& muscle,
               const JointAngle& driver) {
  if (spec.facing) return *spec.facing;
  const AtlasMuscle& preset = atlas_muscle(*spec.preset);
  std::optional<JointAngle> bend = driver;
  // A driver elsewhere says nothing about the bend at the segment's end, which the atlas' own driver may measure.
  if (driver.at != muscle.child)
    bend = spec.driver ? std::nullopt : driver_angle(character.model, character.humanoid, muscle.child);
  return belly_direction(character.model, character.humanoid, character.rest.global, muscle, bend,
                         *spec.side == MuscleSide::left, preset.side, preset.otherwise);
}

/// Peak and sigma from the limb's measures, where the scene does not give them.
void measure(const PlacementContext& character, const MuscleSpec& spec, PlacedMuscle& placed) {
  Muscle& muscle = placed.muscle;
  if (spec.preset) {
    const AtlasMuscle& preset = atlas_muscle(*spec.preset);
    const double r = limb_radius(character.model, character.mesh, character.rest, muscle, placed.region);
    const double range = std::abs(muscle.reference_angle - muscle.rest_angle);
    muscle.peak = preset.peak * r * (range < preset.full_range ? range / preset.full_range : 1.0);
    // Without a vertex to measure there is nothing to swell either; any width but 0 will do.
    muscle.sigma = {preset.sigma_along * placed.region.plane.length, std::max(preset.sigma_across * r, 1e-9)};
  }
  if (spec.peak) muscle.peak = *spec.peak;
  if (spec.sigma) muscle.sigma = *spec.sigma;
}

Result<void> check_angles(const MuscleSpec& spec, const Muscle& muscle) {
  // A rest angle read from joints that lie on a line is straight but for rounding, of which a swelling over the
  // remaining thousandths of a degree would be the amplifier.
  constexpr double least_range = 1.0;
  const double range = std::abs(muscle.rest_angle - muscle.reference_angle);
  if (spec.preset && !spec.rest_angle && !spec.reference_angle && range < least_range)
    return bad_input(
        "muscle \"{}\": the rest pose holds its driver at {:.2f} degrees, where the whole swelling is due at {}: it "
        "has nothing to grow by; give \"rest_angle\" or \"reference_angle\", or a model that rests otherwise",
        muscle.name, muscle.rest_angle, muscle.reference_angle);
  if (range < 1e-6)
    return bad_input("muscle \"{}\": its rest angle and its reference angle are both {} degrees; they must differ",
                     muscle.name, muscle.rest_angle);
  return {};
}

}  // namespace

Result<PlacedMuscle> place_muscle(const PlacementContext& character, const MuscleSpec& spec) {
  PlacedMuscle placed;
  Muscle& muscle = placed.muscle;
  muscle.name = muscle_name(spec);
  muscle.on = spec.on;
  const AtlasMuscle* preset = spec.preset ? &atlas_muscle(*spec.preset) : nullptr;
  const Joints joints(character, spec, muscle.name);
  if (auto ok = joints.into(muscle); !ok) return pass_on(std::move(ok));

  const auto driver = driver_angle(character.model, character.humanoid, muscle.driver, muscle.tip, muscle.before);
  if (!driver)
    return bad_input(
        "muscle \"{}\": no angle can be measured at its driver \"{}\": there is no joint before or after it; "
        "name another driver, or a tip",
        muscle.name, character.model.nodes[muscle.driver].name);
  placed.driver = *driver;
  if (const AtlasDriver* used = joints.atlas_driver(muscle.driver);
      used && used != preset->drivers.data() && !spec.driver && !spec.child)
    placed.note = fmt::format("{} has no joint after it to measure an angle to; {} drives the muscle instead",
                              humanoid_name(on_side(preset->drivers.front().joint, *spec.side)),
                              humanoid_name(on_side(used->joint, *spec.side)));
  muscle.before = driver->before;
  muscle.tip = driver->after;
  muscle.from = preset ? spec.from.value_or(preset->from) : *spec.from;
  muscle.to = preset ? spec.to.value_or(preset->to) : *spec.to;
  muscle.spread = preset ? spec.spread.value_or(preset->spread) : *spec.spread;
  muscle.facing = facing_of(character, spec, muscle, *driver);
  muscle.rest_angle = spec.rest_angle ? *spec.rest_angle : driver->degrees(character.rest.global);
  if (spec.reference_angle) {
    muscle.reference_angle = *spec.reference_angle;
  } else {
    const AtlasDriver* known = joints.atlas_driver(muscle.driver);
    muscle.reference_angle = (known ? *known : preset->drivers.front()).reference_angle;
  }
  if (auto ok = check_angles(spec, muscle); !ok) return pass_on(std::move(ok));
  if (muscle.from >= muscle.to)
    return bad_input("muscle \"{}\": its region runs from {} to {}; from must be less than to", muscle.name,
                     muscle.from, muscle.to);
  auto region = muscle_region(character.model, character.mesh, character.rest, muscle);
  if (!region) return pass_on(std::move(region));
  placed.region = std::move(*region);
  measure(character, spec, placed);
  return placed;
}

std::vector<std::string> placement_problems(const PlacedMuscle& placed) {
  constexpr std::size_t least_vertices = 5;
  const std::size_t count = placed.region.vertices.size(), segment = placed.region.segment_vertices;
  const std::string& name = placed.muscle.name;
  std::vector<std::string> problems;
  if (!placed.note.empty()) problems.push_back(fmt::format("muscle \"{}\": {}", name, placed.note));
  if (count == 0)
    problems.push_back(fmt::format(
        "muscle \"{}\": its region holds none of the segment's {} vertices; it moves nothing", name, segment));
  else if (count < least_vertices)
    problems.push_back(
        fmt::format("muscle \"{}\": its region holds only {} of the segment's {} vertices; below five a swelling shows "
                    "corners, no arc",
                    name, count, segment));
  return problems;
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
