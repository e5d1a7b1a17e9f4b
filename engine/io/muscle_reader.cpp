#include "engine/io/character_reader.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

constexpr std::string_view joint_name = "a joint's name";

void read_preset(const JsonValue& value, MuscleSpec& muscle) {
  if (const auto preset = value.find("preset"))
    muscle.preset = static_cast<MusclePreset>(preset->word(muscle_preset_names()));
  const auto side = muscle.preset ? value.require("side", "\"left\" or \"right\" beside a preset") : value.find("side");
  if (!side) return;
  muscle.side = static_cast<MuscleSide>(side->word(side_names()));
  if (!muscle.preset) side->error("a side without a preset, expected \"preset\" beside it, or no side");
}

std::vector<std::string> read_joints(const JsonValue& value) {
  std::vector<std::string> joints;
  if (!value.expect_list(0, value.size(), "a list of joints' names")) return joints;
  for (std::size_t i = 0; i < value.size(); ++i) joints.push_back(value.item(i).text(joint_name));
  return joints;
}

Vec3 read_facing(const JsonValue& value) {
  constexpr std::string_view expected = "a direction [x, y, z]";
  const Vec3 facing = value.vec3(expected);
  if (facing == Vec3(0)) value.error("expected a direction, found [0, 0, 0]");
  return facing;
}

Vec2 read_sigma(const JsonValue& value) {
  const auto sigma = value.numbers(2, "two lengths [along, across]", {.low = 0, .above_low = true});
  return {sigma[0], sigma[1]};
}

void read_region(const JsonValue& value, MuscleSpec& muscle) {
  constexpr NumberRange along_segment{-1, 2};
  if (const auto facing = value.find("facing")) muscle.facing = read_facing(*facing);
  if (const auto from = value.find("from")) muscle.from = from->number(along_segment);
  if (const auto to = value.find("to")) {
    muscle.to = to->number(along_segment);
    if (muscle.from && *muscle.from >= *muscle.to)
      to->error(fmt::format("expected more than \"from\" ({}), found {}", *muscle.from, *muscle.to));
  }
  if (const auto spread = value.find("spread")) muscle.spread = spread->number({0, 180});
  if (const auto sigma = value.find("sigma")) muscle.sigma = read_sigma(*sigma);
}

void read_swelling(const JsonValue& value, MuscleSpec& muscle) {
  constexpr NumberRange joint_angle{0, 180};
  if (const auto peak = value.find("peak")) muscle.peak = peak->number();
  if (const auto rest = value.find("rest_angle")) muscle.rest_angle = rest->number(joint_angle);
  if (const auto reference = value.find("reference_angle")) {
    muscle.reference_angle = reference->number(joint_angle);
    if (muscle.rest_angle == muscle.reference_angle)
      reference->error(fmt::format(
          "expected an angle other than \"rest_angle\" ({}): the swelling grows between the two", *muscle.rest_angle));
  }
}

void expect_whole(const JsonValue& value) {
  for (const char* key :
       {"name", "bone", "child", "facing", "from", "to", "spread", "peak", "sigma", "reference_angle"})
    value.require(key, "a value, since the muscle has no preset to take it from");
}

}  // namespace

MuscleSpec read_muscle(const JsonValue& value) {
  static const std::vector<std::string> known{
      "preset", "side", "name",   "bone", "child", "driver",     "before",          "tip", "except", "facing",
      "from",   "to",   "spread", "peak", "sigma", "rest_angle", "reference_angle", "on"};
  MuscleSpec muscle;
  if (!value.expect_object(known)) return muscle;
  read_preset(value, muscle);
  if (const auto name = value.find("name")) muscle.name = name->text("a name");
  if (const auto bone = value.find("bone")) muscle.bone = bone->text(joint_name);
  if (const auto child = value.find("child")) muscle.child = child->text(joint_name);
  if (const auto driver = value.find("driver")) muscle.driver = driver->text(joint_name);
  if (const auto before = value.find("before")) muscle.before = before->text(joint_name);
  if (const auto tip = value.find("tip")) muscle.tip = tip->text(joint_name);
  if (const auto except = value.find("except")) muscle.except = read_joints(*except);
  if (muscle.bone && muscle.bone == muscle.child)
    value.find("child")->error(
        fmt::format("expected another joint than \"bone\", found \"{}\" for both", *muscle.bone));
  read_region(value, muscle);
  read_swelling(value, muscle);
  if (const auto on = value.find("on")) muscle.on = on->flag();
  if (!muscle.preset) expect_whole(value);
  return muscle;
}

}  // namespace sinew
