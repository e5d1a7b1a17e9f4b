#include "engine/face/drawn_head.h"

#include <algorithm>
#include <set>

#include "engine/core/files.h"
#include "engine/core/text.h"
#include "engine/face/face_blend.h"
#include "engine/face/head_model.h"

namespace sinew {
namespace {

constexpr double stop_spacing = 1.0 / 16.0;

/// The ages at which heads are drawn, so that all ages between the least and the largest key lie among them.
std::vector<double> drawn_ages(const Keyed<double>& age) {
  const auto [low, high] = std::ranges::minmax(age.keys, {}, [](const Key<double>& key) { return key.value; });
  std::set<double> ages{low.value, high.value};
  for (double a = std::ceil(low.value / stop_spacing) * stop_spacing; a < high.value; a += stop_spacing) ages.insert(a);
  return {ages.begin(), ages.end()};
}

Result<void> check_names(const HeadSpec& spec) {
  for (const auto& [name, weight] : spec.skull)
    if (std::ranges::find(skull_names(), name) == skull_names().end())
      return bad_input("/skull: no outline \"{}\"{}; there are {}", name, did_you_mean(name, skull_names()),
                       fmt::join(skull_names(), ", "));
  return {};
}

Result<HeadMeasures> measures_at(const HeadSpec& spec, double age) {
  HeadMeasures measures = measures_of_age(age);
  if (!spec.file.empty()) {
    const auto bytes = read_file(spec.file);
    if (!bytes) return failure(bytes.error().kind, "/file: {}", bytes.error().message);
    auto parsed = parse_measures(std::string(bytes->begin(), bytes->end()), spec.file.string());
    if (!parsed) return bad_input("/file: {}", parsed.error().message);
    measures = *parsed;
  }
  apply_skull(spec.skull, measures);
  for (const auto& [name, value] : spec.measures)
    if (auto ok = set_measure(name, value, measures); !ok) return bad_input("/measures: {}", ok.error().message);
  if (auto ok = check_measures(measures); !ok) return bad_input(": {}", ok.error().message);
  return measures;
}

CharacterFace face_of(const Head& head) {
  return {picked_face(head.face, head_vertices(head)), {.unit = head.metres()}, head_guides(head.measures)};
}

}  // namespace

Result<HeadMeasures> head_measures(const HeadSpec& spec, double frame) {
  if (auto ok = check_names(spec); !ok) return pass_on(std::move(ok));
  return measures_at(spec, spec.age.value_at(frame));
}

Result<DrawnHead> DrawnHead::make(const HeadSpec& spec, double frame) {
  if (auto ok = check_names(spec); !ok) return pass_on(std::move(ok));
  DrawnHead out;
  out.ages_ = spec.age;
  const HeadMaker maker(spec.level.value_or(default_head_level));
  const auto drawn = [&](double age) -> Result<Head> {
    const auto measures = measures_at(spec, age);
    if (!measures) return tl::unexpected<Error>(measures.error());
    out.measures_ += measures_text(*measures);
    return maker.head(*measures);
  };
  const auto first = drawn(spec.age.value_at(frame));
  if (!first) return tl::unexpected<Error>(first.error());
  out.model_ = head_model(*first, nullptr, {});
  out.model_.file = "builtin:head";
  out.face_ = face_of(*first);
  const std::vector<double> ages = drawn_ages(spec.age);
  if (ages.size() == 1) return out;
  for (const double age : ages) {
    const auto head = drawn(age);
    if (!head) return tl::unexpected<Error>(head.error());
    Stop& stop = out.stops_.emplace_back();
    stop.age = age;
    for (const std::uint32_t v : head_vertices(*head)) {
      stop.positions.push_back(head->metres() * head->positions[v]);
      stop.normals.push_back(head->normals[v]);
    }
    stop.face = face_of(*head);
  }
  std::vector<FaceRig*> rigs;
  for (Stop& stop : out.stops_) rigs.push_back(&stop.face.rig);
  give_same_signals(rigs);
  // With deltas of the same signals as every age to come: buffers that hold it hold them all.
  out.face_ = out.face_at(frame);
  return out;
}

DrawnHead::Span DrawnHead::span_at(double frame) const {
  const double age = ages_.value_at(frame);
  const auto above = std::ranges::lower_bound(stops_, age, {}, &Stop::age);
  const auto b = std::clamp<std::size_t>(std::size_t(above - stops_.begin()), 1, stops_.size() - 1);
  const Stop &older = stops_[b - 1], &younger = stops_[b];
  return {&older, &younger, std::clamp((age - older.age) / (younger.age - older.age), 0.0, 1.0)};
}

FaceRig DrawnHead::sizes(double frame) const {
  const auto [older, younger, t] = span_at(frame);
  return blended_face(face_sizes(older->face.rig), face_sizes(younger->face.rig), t);
}

CharacterFace DrawnHead::face_at(double frame) const {
  const auto [older, younger, t] = span_at(frame);
  CharacterFace out{blended_face(older->face.rig, younger->face.rig, t),
                    {.unit = glm::mix(older->face.place.unit, younger->face.place.unit, t)},
                    {}};
  for (const FaceGuideName& guide : face_guide_names())
    out.guides.*guide.height = glm::mix(older->face.guides.*guide.height, younger->face.guides.*guide.height, t);
  return out;
}

void DrawnHead::age(double frame, CharacterMesh& mesh) const {
  if (!changes()) return;
  const auto [older, younger, t] = span_at(frame);
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    mesh.positions[v] = glm::mix(older->positions[v], younger->positions[v], t);
    mesh.normals[v] = unit_or(glm::mix(older->normals[v], younger->normals[v], t), older->normals[v]);
  }
  mesh.face = face_at(frame);
}

}  // namespace sinew
