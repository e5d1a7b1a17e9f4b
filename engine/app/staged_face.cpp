#include "engine/app/staged_face.h"

#include <algorithm>
#include <cmath>

namespace sinew {

Result<void> stage_face(const Character& character, const Model& model, const CharacterMesh& mesh, StagedFace& face) {
  auto track = face_track(character);
  if (!track) return pass_on(std::move(track));
  face.track = std::move(*track);
  if (face.track.empty() || mesh.face) return {};
  face.targets = TargetFace::find(model, mesh);
  if (face.targets) return face.targets->prepare(face.track);
  return bad_input(
      "/{}: the model has no face: neither regions, as builtin:head has, nor morph targets named as ARKit's or VRM's",
      character.regions.empty() ? "expressions" : "regions");
}

std::string without_regions(const Model& model, const CharacterMesh& mesh) {
  if (mesh.face) return "";
  if (TargetFace::find(model, mesh))
    return "its face is morph targets without regions; builtin:head has regions, and a scene's \"landmarks\" give them";
  return "it has no face; a scene's \"landmarks\" give a head one";
}

std::shared_ptr<const CharacterMesh> mesh_at(const StagedFace& face, const CharacterMesh& mesh, double frame) {
  if (!face.head || !face.head->changes()) return nullptr;
  auto aged = std::make_shared<CharacterMesh>(mesh);
  face.head->age(frame, *aged);
  return aged;
}

std::optional<FaceState> face_state_at(const StagedFace& face, const CharacterMesh& mesh, double frame) {
  if (!mesh.face) return std::nullopt;
  const FaceRig& rig = mesh.face->rig;
  return face_state(rig, hold_at_limits(rig, channels_at(face.track, rig, frame)).channels);
}

FaceRig face_sizes_at(const StagedFace& face, const CharacterMesh& mesh, double frame) {
  return face.head && face.head->changes() ? face.head->sizes(frame) : face_sizes(mesh.face->rig);
}

std::vector<HeldKey> held_over(const StagedFace& face, const CharacterMesh& mesh, int first, int last) {
  constexpr int most_samples = 512;
  std::vector<HeldKey> out;
  if (!mesh.face || face.track.empty()) return out;
  const int samples = std::clamp(last - first, 1, most_samples);
  for (int i = 0; i <= samples; ++i) {
    const int frame = first + static_cast<int>(std::round(double(last - first) * i / samples));
    const FaceRig rig = face_sizes_at(face, mesh, frame);
    for (const HeldChannel& held : hold_at_limits(rig, channels_at(face.track, rig, frame)).held) {
      const auto known = std::ranges::find(out, held.channel, [](const HeldKey& key) { return key.held.channel; });
      const auto excess = [](const HeldChannel& h) { return std::abs(h.asked - h.held); };
      if (known == out.end())
        out.push_back({held, frame});
      else if (excess(held) > excess(known->held))
        *known = {held, frame};
    }
  }
  return out;
}

}  // namespace sinew
