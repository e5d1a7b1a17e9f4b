#include "engine/face/head_measures.h"

#include <algorithm>
#include <array>

#include "embedded/head_measures.h"
#include "engine/core/text.h"
#include "engine/io/json_reader.h"
#include "engine/io/json_writer.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

using Json = nlohmann::json;
using M = HeadMeasures;

constexpr HeadMeasureField fields[] = {
    {"height", &M::height, 0.02, 2.0},
    {"hair_line", &M::hair_line, 2.0, 3.4},
    {"brow_height", &M::brow_height, 1.3, 2.6},
    {"eye_height", &M::eye_height, 1.1, 2.2},
    {"nose_height", &M::nose_height, 0.6, 1.4},
    {"mouth_height", &M::mouth_height, 0.35, 1.0},
    {"eye_spacing", &M::eye_spacing, 0.40, 0.68},
    {"eye_radius", &M::eye_radius, 0.22, 0.44},
    {"eye_depth", &M::eye_depth, 1.2, 1.55},
    {"lid_inner", &M::lid_inner, -0.30, -0.12},
    {"lid_outer", &M::lid_outer, 0.14, 0.34},
    {"lid_inner_rise", &M::lid_inner_rise, -0.10, 0.08},
    {"lid_outer_rise", &M::lid_outer_rise, -0.08, 0.10},
    {"lid_upper", &M::lid_upper, 0.05, 0.22},
    {"lid_lower", &M::lid_lower, 0.05, 0.22},
    {"lid_thickness", &M::lid_thickness, 0.5, 1.6},
    {"lid_puff", &M::lid_puff, -0.03, 0.05},
    {"iris_angle", &M::iris_angle, 20.0, 42.0},
    {"brow_ridge", &M::brow_ridge, -0.03, 0.10},
    {"brow_thickness", &M::brow_thickness, 0.015, 0.10},
    {"brow_inner_rise", &M::brow_inner_rise, -0.08, 0.15},
    {"brow_arch", &M::brow_arch, 0.0, 2.0},
    {"nose_width", &M::nose_width, 0.15, 0.40},
    {"nose_length", &M::nose_length, 0.08, 0.45},
    {"nose_tip_rise", &M::nose_tip_rise, 0.08, 0.28},
    {"nasion_depth", &M::nasion_depth, -0.06, 0.12},
    {"bridge_width", &M::bridge_width, 0.05, 0.14},
    {"mouth_width", &M::mouth_width, 0.20, 0.56},
    {"upper_lip", &M::upper_lip, 0.05, 0.20},
    {"lower_lip", &M::lower_lip, 0.06, 0.22},
    {"lip_depth", &M::lip_depth, 0.02, 0.24},
    {"chin_width", &M::chin_width, 0.18, 0.56},
    {"chin_depth", &M::chin_depth, 1.30, 1.70},
    {"chin_boss", &M::chin_boss, -0.03, 0.10},
    {"jaw_width", &M::jaw_width, 0.60, 1.15},
    {"jaw_height", &M::jaw_height, 0.25, 0.85},
    {"jaw_depth", &M::jaw_depth, -0.15, 0.40},
    {"cheek_bone", &M::cheek_bone, -0.03, 0.12},
    {"cheek_puff", &M::cheek_puff, -0.05, 0.25},
    {"ear_bottom", &M::ear_bottom, 0.5, 1.4},
    {"ear_top", &M::ear_top, 1.2, 2.4},
    {"ear_depth", &M::ear_depth, -0.30, 0.15},
    {"ear_flare", &M::ear_flare, 5.0, 45.0},
    {"neck_width", &M::neck_width, 0.45, 1.0},
    {"neck_front", &M::neck_front, 0.3, 0.8},
    {"neck_back", &M::neck_back, -1.3, -0.8},
    {"neck_rise", &M::neck_rise, -0.1, 0.1},
    {"neck_length", &M::neck_length, 0.4, 1.4},
    {"width_jaw", &M::width_jaw, 0.75, 1.4},
    {"width_mouth", &M::width_mouth, 0.75, 1.4},
    {"width_eyes", &M::width_eyes, 0.75, 1.4},
    {"width_temples", &M::width_temples, 0.75, 1.4},
    {"width_crown", &M::width_crown, 0.7, 1.45},
    {"skull_adult", &M::skull_adult, 0.0, 1.0},
    {"skull_child", &M::skull_child, 0.0, 1.0},
    {"skull_infant", &M::skull_infant, 0.0, 1.0},
};

/// The document is part of the library: that it is well formed is for its test to hold, not for users to hear.
const Json& document() {
  static const Json parsed = Json::parse(head_measures);
  return parsed;
}

std::vector<std::string> field_names() {
  std::vector<std::string> names;
  for (const HeadMeasureField& field : fields) names.emplace_back(field.name);
  return names;
}

const HeadMeasureField* find_field(std::string_view name) {
  const auto found = std::ranges::find_if(fields, [&](const HeadMeasureField& f) { return name == f.name; });
  return found == std::end(fields) ? nullptr : found;
}

std::string unknown_measure(std::string_view name) {
  const std::vector<std::string> names = field_names();
  return fmt::format("no measure \"{}\"{}; there are {}", name, did_you_mean(name, names), fmt::join(names, ", "));
}

HeadMeasures stop(std::size_t i) {
  HeadMeasures out{};
  for (const HeadMeasureField& field : fields) out.*field.member = document()["ages"][age_names()[i]][field.name];
  return out;
}

}  // namespace

std::span<const HeadMeasureField> head_measure_fields() { return fields; }

HeadMeasures measures_of_age(double age) {
  const double place = std::clamp(age, 0.0, 1.0) * double(age_names().size() - 1);
  const auto below = std::min<std::size_t>(static_cast<std::size_t>(place), age_names().size() - 2);
  const HeadMeasures younger = stop(below + 1);
  HeadMeasures out = stop(below);
  for (const HeadMeasureField& field : fields)
    out.*field.member = glm::mix(out.*field.member, younger.*field.member, place - double(below));
  return out;
}

Result<double> parse_age(std::string_view text) {
  const auto names = age_names();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (text == names[i]) return double(i) / double(names.size() - 1);
  const auto number = parse_number(text);
  if (number && *number >= 0.0 && *number <= 1.0) return *number;
  return failure(ErrorKind::usage, "--age {}: expected {}, or a number from 0 (adult) to 1 (infant){}", text,
                 fmt::join(names, ", "), did_you_mean(text, names));
}

std::span<const std::string> skull_names() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    for (const auto& [name, changes] : document()["skulls"].items()) names.push_back(name);
    return names;
  }();
  return all;
}

Result<SkullWeights> parse_skull(std::string_view text) {
  const auto names = skull_names();
  SkullWeights out;
  for (const std::string& word : split(text, ',')) {
    const std::vector<std::string> sides = split(word, '=');
    if (std::ranges::find(names, sides[0]) == names.end())
      return failure(ErrorKind::usage, "--skull {}: no skull \"{}\"{}; there are {}", text, sides[0],
                     did_you_mean(sides[0], names), fmt::join(names, ", "));
    const auto weight = sides.size() == 1 ? std::optional(1.0) : parse_number(sides[1]);
    if (sides.size() > 2 || !weight || *weight < 0.0 || *weight > 1.0)
      return failure(ErrorKind::usage, "--skull {}: expected NAME or NAME=WEIGHT, weights from 0 to 1", text);
    out[sides[0]] = *weight;
  }
  return out;
}

void apply_skull(const SkullWeights& skull, HeadMeasures& measures) {
  for (const auto& [name, weight] : skull) {
    const Json& changes = document()["skulls"].at(name);
    for (const auto& [measure, factor] : changes["times"].items())
      measures.*find_field(measure)->member *= 1.0 + weight * (factor.get<double>() - 1.0);
    for (const auto& [measure, amount] : changes["plus"].items())
      measures.*find_field(measure)->member += weight * amount.get<double>();
  }
  // Of skulls that pull the same way the sum may be more than a head bears; nobody asked for that number.
  for (const HeadMeasureField& field : fields)
    measures.*field.member = std::clamp(measures.*field.member, field.low, field.high);
}

Result<void> apply_measure(std::string_view text, HeadMeasures& measures) {
  const std::size_t equals = text.find('=');
  const auto value = equals == std::string_view::npos ? std::optional<double>() : parse_number(text.substr(equals + 1));
  if (!value) return failure(ErrorKind::usage, "--measure {}: expected NAME=VALUE", text);
  if (auto ok = set_measure(text.substr(0, equals), *value, measures); !ok)
    return bad_input("--measure {}: {}", text, ok.error().message);
  return {};
}

Result<void> set_measure(std::string_view name, double value, HeadMeasures& measures) {
  const HeadMeasureField* field = find_field(name);
  if (field == nullptr) return bad_input("{}", unknown_measure(name));
  if (!(value >= field->low && value <= field->high))
    return bad_input("{} is {:.4g}, expected from {} to {}", field->name, value, field->low, field->high);
  measures.*field->member = value;
  return {};
}

Result<void> check_measures(const HeadMeasures& m) {
  for (const HeadMeasureField& field : fields)
    if (!(m.*field.member >= field.low && m.*field.member <= field.high))
      return bad_input("{} is {:.4g}, expected from {} to {}", field.name, m.*field.member, field.low, field.high);
  struct Order {
    const char *lower, *upper;
    double lower_value, upper_value, gap;
  };
  const Order orders[] = {
      {"mouth_height", "nose_height", m.mouth_height, m.nose_height, 1.25 * m.upper_lip + 0.08},
      {"nose_height", "eye_height", m.nose_height, m.eye_height, 0.35},
      {"eye_height", "brow_height", m.eye_height, m.brow_height, 0.14},
      {"brow_height", "hair_line", m.brow_height, m.hair_line, 0.30},
      {"ear_bottom", "ear_top", m.ear_bottom, m.ear_top, 0.45},
      {"eye_radius", "eye_spacing", m.eye_radius, m.eye_spacing, 0.12},
      {"jaw_height", "ear_bottom", m.jaw_height, m.ear_bottom, 0.15},
      {"lower_lip", "mouth_height", m.lower_lip, m.mouth_height, 0.25},
      {"mouth_width", "jaw_width", m.mouth_width, m.jaw_width, 0.25},
      {"chin_width", "jaw_width", m.chin_width, m.jaw_width, 0.25},
  };
  for (const Order& order : orders)
    if (order.upper_value - order.lower_value < order.gap - 1e-9)
      return bad_input("measures cross: {} ({:.4g}) has to be at least {:.4g} below {} ({:.4g})", order.lower,
                       order.lower_value, order.gap, order.upper, order.upper_value);
  if (m.skull_adult + m.skull_child + m.skull_infant < 1e-6)
    return bad_input("skull_adult, skull_child and skull_infant are all 0: at least one has to be above");
  return {};
}

std::string measures_text(const HeadMeasures& measures) {
  nlohmann::ordered_json out;
  out["sinew_head"] = 1;
  for (const HeadMeasureField& field : fields) out["measures"][field.name] = measures.*field.member;
  return readable_json(out);
}

Result<HeadMeasures> parse_measures(std::string_view text, const std::string& name) {
  auto json = parse_json(text, name);
  if (!json) return pass_on(std::move(json));
  JsonReport report(name);
  const JsonValue root(*json, report);
  HeadMeasures out = measures_of_age(0.0);
  const std::vector<std::string> known{"sinew_head", "measures"}, names = field_names();
  if (root.expect_object(known)) {
    if (const auto version = root.require("sinew_head", "1, the version of the file")) version->integer(1, 1);
    const auto list = root.require("measures", "an object of measures");
    if (list && list->expect_object(names))
      for (const HeadMeasureField& field : fields)
        if (const auto value = list->find(field.name)) out.*field.member = value->number({field.low, field.high});
  }
  if (report.error()) return tl::unexpected<Error>(*report.error());
  if (auto ok = check_measures(out); !ok) return bad_input("{}: {}", name, ok.error().message);
  return out;
}

SkullSections skull_sections(const HeadMeasures& m) {
  const Json& sections = document()["sections"];
  const std::pair<const char*, double> skulls[] = {
      {"adult", m.skull_adult}, {"child", m.skull_child}, {"infant", m.skull_infant}};
  const double sum = m.skull_adult + m.skull_child + m.skull_infant;
  SkullSections out;
  out.heights = sections["heights"].get<std::vector<double>>();
  out.radii.assign(out.heights.size(), std::vector<double>(sections["adult"][0].size(), 0.0));
  for (const auto& [name, share] : skulls)
    for (std::size_t i = 0; i < out.radii.size(); ++i)
      for (std::size_t k = 0; k < out.radii[i].size(); ++k)
        out.radii[i][k] += share / sum * sections[name][i][k].get<double>();
  return out;
}

}  // namespace sinew
