#include "engine/gpu/packing.h"

#include <algorithm>
#include <bit>
#include <tuple>

#include <glm/gtc/matrix_transform.hpp>

namespace sinew {
namespace {

std::uint32_t bits(double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); }

Word word(const Vec3& v, std::uint32_t w) { return {bits(v.x), bits(v.y), bits(v.z), w}; }

std::uint32_t joint_pair(std::uint32_t low, std::uint32_t high) { return low | high << 16; }

/// The influences of one vertex, padded to eight with joint 0 at weight 0.
struct PaddedRun {
  std::uint32_t joint[max_influences] = {};
  double weight[max_influences] = {};
  std::size_t count = 0;
};

PaddedRun padded_run(const Influences& influences, std::size_t v) {
  PaddedRun run;
  for (std::uint32_t i = influences.first[v]; i < influences.first[v + 1]; ++i, ++run.count) {
    run.joint[run.count] = influences.entries[i].joint;
    run.weight[run.count] = influences.entries[i].weight;
  }
  return run;
}

/// One muscle's entry for one vertex of its region.
struct RegionEntry {
  std::uint32_t muscle = 0;
  const RegionVertex* place = nullptr;
};

std::vector<std::vector<RegionEntry>> regions_by_vertex(std::size_t vertices, std::span<const PlacedMuscle> muscles) {
  std::vector<std::vector<RegionEntry>> entries(vertices);
  for (std::size_t m = 0; m < muscles.size(); ++m)
    for (const RegionVertex& place : muscles[m].region.vertices)
      entries[place.vertex].push_back({static_cast<std::uint32_t>(m), &place});
  return entries;
}

/// Which of the face's turns a vertex takes part in (shaders/layout.h).
std::uint32_t face_turn(const FaceVertex& vertex) {
  if (vertex.eye < 0) return 0;
  return static_cast<std::uint32_t>((vertex.ball ? 3 : 1) + vertex.eye);
}

class Packer {
 public:
  Packer(const CharacterMesh& mesh, const RestShape& rest, std::span<const PlacedMuscle> muscles)
      : mesh_(mesh), rest_(rest), muscles_(muscles), regions_(regions_by_vertex(mesh.vertices(), muscles)) {
    packed_.details.resize(layout::zero_words);
    packed_.has_morphs = !mesh.morph_deltas.empty();
    packed_.has_face = mesh.face.has_value();
    for (std::size_t v = 0; v < mesh.vertices(); ++v)
      packed_.has_extra_influences |= mesh.influences.first[v + 1] - mesh.influences.first[v] > 4;
  }

  void add(std::size_t v, const PaddedRun& run) {
    const std::uint32_t details = add_details(v, run);
    packed_.vertices.push_back(word(mesh_.positions[v], details));
    packed_.vertices.push_back(word(mesh_.normals[v], bits(run.weight[1])));
    packed_.vertices.push_back({joint_pair(run.joint[0], run.joint[1]), joint_pair(run.joint[2], run.joint[3]),
                                bits(run.weight[2]), bits(run.weight[3])});
    if (!mesh_.tangents.empty()) packed_.tangents.emplace_back(mesh_.tangents[v]);
  }

  PackedCharacter finish() { return std::move(packed_); }

 private:
  /// The vertex's link, 0 where it has no details.
  std::uint32_t add_details(std::size_t v, const PaddedRun& run) {
    const std::uint32_t morphs = mesh_.morph_first[v + 1] - mesh_.morph_first[v];
    const std::uint32_t extra = run.count > 4 ? 1 : 0;
    const auto regions = static_cast<std::uint32_t>(regions_[v].size());
    const bool face = packed_.has_face && mesh_.face->rig.moves(v);
    if (morphs == 0 && extra == 0 && regions == 0 && !face) return 0;
    const auto index = static_cast<std::uint32_t>(packed_.details.size());
    if (packed_.has_morphs || packed_.has_extra_influences) packed_.details.push_back({morphs, extra, 0, 0});
    for (std::uint32_t i = mesh_.morph_first[v]; i < mesh_.morph_first[v + 1]; ++i) add_morph(mesh_.morph_deltas[i]);
    if (packed_.has_face) add_face(v);
    if (extra != 0) add_extra(run);
    for (const RegionEntry& entry : regions_[v]) add_region(v, entry);
    return regions << layout::link_shift | index;
  }

  void add_morph(const MorphDelta& delta) {
    packed_.details.push_back(word(delta.position, delta.slot));
    packed_.details.push_back(word(delta.normal, 0));
  }

  void add_face(std::size_t v) {
    const FaceRig& rig = mesh_.face->rig;
    const FacePlace& place = mesh_.face->place;
    const FaceVertex& vertex = rig.vertices[v];
    packed_.details.push_back(
        {bits(vertex.jaw), bits(vertex.jaw_sealed), bits(vertex.close_upper), bits(vertex.close_lower)});
    packed_.details.push_back(
        {bits(place.unit * vertex.least_distance), face_turn(vertex), rig.first[v + 1] - rig.first[v], 0});
    const auto first_signal = static_cast<std::uint32_t>(mesh_.morph_slots.size());
    for (std::uint32_t i = rig.first[v]; i < rig.first[v + 1]; ++i) {
      const FaceDelta& delta = rig.deltas[i];
      packed_.details.push_back(word(place.unit * (place.axes * delta.position), first_signal + delta.signal));
      packed_.details.push_back(word(place.axes * delta.normal, 0));
    }
  }

  void add_extra(const PaddedRun& run) {
    packed_.details.push_back({joint_pair(run.joint[4], run.joint[5]), joint_pair(run.joint[6], run.joint[7]), 0, 0});
    packed_.details.push_back({bits(run.weight[4]), bits(run.weight[5]), bits(run.weight[6]), bits(run.weight[7])});
  }

  void add_region(std::size_t v, const RegionEntry& entry) {
    const Muscle& muscle = muscles_[entry.muscle].muscle;
    const ProjectionPlane& plane = muscles_[entry.muscle].region.plane;
    const RegionVertex& r = *entry.place;
    const RegionFade fade = region_fade(muscle, r);
    const Mat3 to_bind = glm::transpose(rest_.blend[v]);
    packed_.details.push_back({bits(r.x), bits(r.y), bits(fade.value), bits(fade.slope / plane.length)});
    packed_.details.push_back(word(to_bind * plane.axis, entry.muscle));
    packed_.details.push_back(word(to_bind * plane.side, 0));
  }

  const CharacterMesh& mesh_;
  const RestShape& rest_;
  std::span<const PlacedMuscle> muscles_;
  std::vector<std::vector<RegionEntry>> regions_;
  PackedCharacter packed_;
};

}  // namespace

Result<PackedCharacter> pack_character(const CharacterMesh& mesh, const RestShape& rest,
                                       std::span<const PlacedMuscle> muscles,
                                       std::span<const RigidDuplicate> duplicates) {
  if (mesh.palette.size() > 65536)
    return bad_input("the character has {} joints over all skins; 65,536 is the most", mesh.palette.size());
  constexpr std::size_t most_muscles = 1u << (32 - layout::link_shift);
  for (const std::vector<RegionEntry>& regions : regions_by_vertex(mesh.vertices(), muscles))
    if (regions.size() >= most_muscles)
      return bad_input("a vertex lies in the regions of {} muscles; {} is the most", regions.size(), most_muscles - 1);
  Packer packer(mesh, rest, muscles);
  for (std::size_t v = 0; v < mesh.vertices(); ++v) packer.add(v, padded_run(mesh.influences, v));
  for (const RigidDuplicate& duplicate : duplicates) {
    PaddedRun run;
    run.joint[0] = duplicate.joint;
    run.weight[0] = 1.0;
    run.count = 1;
    packer.add(duplicate.vertex, run);
  }
  PackedCharacter packed = packer.finish();
  if (packed.details.size() > layout::link_mask)
    return bad_input("the character's morph targets, face and muscle regions need {} words, {} is the most",
                     packed.details.size(), layout::link_mask);
  return packed;
}

bool is_packed_alike(const PlacedMuscle& a, const PlacedMuscle& b) {
  const auto fade = [](const Muscle& m) { return std::tie(m.from, m.to, m.spread); };
  const auto plane = [](const ProjectionPlane& p) { return std::tie(p.axis, p.side, p.length); };
  const auto same_place = [](const RegionVertex& p, const RegionVertex& q) {
    return std::tie(p.vertex, p.x, p.y, p.t, p.angle, p.share) == std::tie(q.vertex, q.x, q.y, q.t, q.angle, q.share);
  };
  return fade(a.muscle) == fade(b.muscle) && plane(a.region.plane) == plane(b.region.plane) &&
         std::ranges::equal(a.region.vertices, b.region.vertices, same_place);
}

void pack_palette(std::span<const Mat34> palette, std::span<Vec4f> words) {
  for (std::size_t i = 0; i < palette.size(); ++i)
    for (std::size_t row = 0; row < 3; ++row) words[i * layout::words_per_joint + row] = Vec4f(palette[i].row[row]);
}

void pack_face(const CharacterFace& face, const FaceState& state, std::span<Vec4f> words) {
  const FaceRig& rig = face.rig;
  const FacePlace& place = face.place;
  const auto in_bind = [&place](const Vec3& p) { return place.origin + place.unit * (place.axes * p); };
  words[0] = Vec4f(Vec4(in_bind(rig.hinge), state.jaw_angle));
  words[1] = Vec4f(Vec4(place.axes[0], state.seal));
  words[2] = Vec4f(Vec4(place.unit * state.jaw_forward * place.axes[2], 0.0));
  std::ranges::fill(words.subspan(layout::words_of_jaw), Vec4f(0.0f));
  for (std::uint32_t eye = 0; eye < 2; ++eye) {
    const Vec4 centre(in_bind(rig.eye_centres[eye]), 0.0);
    const auto lid = words.subspan(layout::words_of_jaw + (1 + eye) * layout::words_per_face_turn);
    lid[0] = Vec4f(centre + Vec4(0.0, 0.0, 0.0, state.upper_lid[eye]));
    lid[1].w = static_cast<float>(state.lower_lid[eye]);
    const auto ball = words.subspan(layout::words_of_jaw + (3 + eye) * layout::words_per_face_turn);
    const Vec2& gaze = state.gaze[eye];
    const Mat3 turn(glm::rotate(Mat4(1.0), gaze.x, Vec3(0, 1, 0)) * glm::rotate(Mat4(1.0), -gaze.y, Vec3(1, 0, 0)));
    const Mat3 adds = place.axes * (state.eye_share * turn - Mat3(1.0)) * glm::transpose(place.axes);
    ball[0] = Vec4f(centre);
    for (int row = 0; row < 3; ++row) ball[1 + row] = Vec4f(adds[0][row], adds[1][row], adds[2][row], 0.0f);
  }
}

layout::MuscleWord pack_muscle(const PlacedMuscle& placed, double activation) {
  const Muscle& m = placed.muscle;
  return {Vec4f(Vec4(1.0 / (m.sigma.x * m.sigma.x), 1.0 / (m.sigma.y * m.sigma.y), activation * m.peak, 0.0))};
}

}  // namespace sinew
