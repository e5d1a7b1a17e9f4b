#include "engine/body/figure_measures.h"

#include <cassert>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "embedded/figure_measures.h"

namespace sinew {
namespace {

using Json = nlohmann::json;

/// The measured changes are modest; at the ends of the options they are taken this many times.
constexpr double muscle_gain = 1.25, arm_muscle_gain = 2.0, heavy_gain = 1.8, slim_gain = 1.3;

constexpr double thinnest = 0.0025;

/// The document is part of the library: that it is well formed is for its test to hold, not for users to hear.
const Json& document() {
  static const Json parsed = Json::parse(figure_measures);
  return parsed;
}

/// Numbers of two documents of the same shape, blended.
class Blend {
 public:
  explicit Blend(double share) : share_(share) {}

  double number(const Json& one, const Json& other) const {
    return glm::mix(one.get<double>(), other.get<double>(), share_);
  }
  Vec3 vec3(const Json& one, const Json& other) const {
    return {number(one[0], other[0]), number(one[1], other[1]), number(one[2], other[2])};
  }
  std::vector<Vec3> points(const Json& one, const Json& other) const {
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < one.size(); ++i) out.push_back(vec3(one[i], other[i]));
    return out;
  }
  RadiusTable table(const Json& one, const Json& other) const {
    RadiusTable out{static_cast<int>(one.size()), static_cast<int>(one[0].size()), {}};
    for (std::size_t i = 0; i < one.size(); ++i)
      for (std::size_t k = 0; k < one[i].size(); ++k) out.values.push_back(number(one[i][k], other[i][k]));
    return out;
  }

 private:
  double share_;
};

BodyPart blended_part(const Blend& blend, const std::string& name, const Json& one, const Json& other) {
  BodyPart part;
  part.name = name;
  part.radius = blend.table(one["radius"], other["radius"]);
  if (one.contains("ball")) {
    part.ball = true;
    part.ball_centre = blend.vec3(one["ball"], other["ball"]);
    part.pole = glm::normalize(blend.vec3(one["pole"], other["pole"]));
    part.zero = blend.vec3(one["u"], other["u"]);
    part.zero = glm::normalize(part.zero - glm::dot(part.zero, part.pole) * part.pole);
    part.warp = blend.number(one["warp"], other["warp"]);
    return part;
  }
  part.axis = blend.points(one["axis"], other["axis"]);
  part.u = blend.points(one["u"], other["u"]);
  for (std::size_t i = 0; i < part.u.size(); ++i) {
    const Vec3 along = glm::normalize(part.axis[i + 1] - part.axis[i]);
    part.u[i] = glm::normalize(part.u[i] - glm::dot(part.u[i], along) * along);
  }
  part.first = blend.number(one["stations"][0], other["stations"][0]);
  part.last = blend.number(one["stations"][1], other["stations"][1]);
  for (std::size_t i = 0; i < one["centre"].size(); ++i)
    part.centre.emplace_back(blend.number(one["centre"][i][0], other["centre"][i][0]),
                             blend.number(one["centre"][i][1], other["centre"][i][1]));
  part.cap_first = blend.number(one["cap"][0], other["cap"][0]);
  part.cap_last = blend.number(one["cap"][1], other["cap"][1]);
  return part;
}

/// Adds `amount` of a change to the part's radii.
void change(BodyPart& part, const Blend& blend, const char* kind, double amount) {
  if (amount == 0.0) return;
  const Json& bodies = document()["bodies"];
  const Json &male = bodies["male"]["change"][kind], &female = bodies["female"]["change"][kind];
  for (const auto& [body, share_of_body] : {std::pair{&male, 0}, std::pair{&female, 1}}) {
    if (!body->contains(part.name)) continue;
    const Json& rows = (*body)[part.name];
    // The other body's change is nothing where it lists none.
    const Json nothing = 0.0;
    for (std::size_t i = 0; i < part.radius.values.size(); ++i) {
      const Json& value = rows[i / part.radius.columns][i % part.radius.columns];
      part.radius.values[i] +=
          amount * (share_of_body == 0 ? blend.number(value, nothing) : blend.number(nothing, value));
    }
  }
}

int add_union(const Json& node, MeasuredBody& body) {
  UnionNode out;
  if (node.is_string()) {
    for (std::size_t i = 0; i < body.parts.size(); ++i)
      if (body.parts[i].name == node.get<std::string>()) out.part = static_cast<int>(i);
    assert(out.part >= 0);
  } else {
    out.fillet = node[0].get<double>();
    out.one = add_union(node[1], body);
    out.other = add_union(node[2], body);
  }
  body.tree.push_back(out);
  return static_cast<int>(body.tree.size()) - 1;
}

}  // namespace

const BodyPart& MeasuredBody::part(std::string_view name) const {
  for (const BodyPart& part : parts)
    if (part.name == name) return part;
  throw std::logic_error("no such part of the body: " + std::string(name));
}

MeasuredBody measured_body(double sex, double build, double muscle) {
  const Json& bodies = document()["bodies"];
  const Json &male = bodies["male"], &female = bodies["female"];
  const Blend blend(sex);
  MeasuredBody body;
  body.height = blend.number(male["height"], female["height"]);
  for (const auto& [name, place] : male["joints"].items())
    body.joints[name] = blend.vec3(place, female["joints"][name]);
  for (const auto& [name, girth] : male["girths"].items())
    body.girths[name] = blend.number(girth, female["girths"][name]);
  for (const auto& [name, part] : male["parts"].items()) {
    body.parts.push_back(blended_part(blend, name, part, female["parts"][name]));
    BodyPart& added = body.parts.back();
    change(added, blend, "muscle_max",
           (name == "arm" ? arm_muscle_gain : muscle_gain) * std::max(2.0 * muscle - 1.0, 0.0));
    change(added, blend, "muscle_min", std::max(1.0 - 2.0 * muscle, 0.0));
    change(added, blend, "weight_max", heavy_gain * std::max(build, 0.0));
    change(added, blend, "weight_min", slim_gain * std::max(-build, 0.0));
    for (double& radius : added.radius.values) radius = std::max(radius, thinnest);
  }
  add_union(document()["union"], body);
  return body;
}

}  // namespace sinew
