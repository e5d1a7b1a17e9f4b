#include "engine/app/bench_face.h"

#include <algorithm>

#include "engine/app/bench_timing.h"
#include "engine/app/device_state.h"

namespace sinew {

Result<std::optional<FaceBench>> FaceBench::create(Device& device, const Stage& stage) {
  const auto has_face = [](const StagedCharacter& c) { return c.mesh.face.has_value(); };
  if (std::ranges::none_of(stage.characters, has_face)) return std::optional<FaceBench>();
  FaceBench bench;
  for (const StagedCharacter& c : stage.characters) {
    CharacterMesh faceless = c.mesh;
    faceless.face.reset();
    for (const auto& [mesh, to] :
         {std::pair{&c.mesh, &bench.with_}, std::pair{&std::as_const(faceless), &bench.without_}}) {
      auto deformer = GpuDeformer::create(device, *mesh, c.rest, {}, {.bulge = BulgeMode::off});
      if (!deformer) return pass_on(std::move(deformer));
      to->push_back(std::move(*deformer));
    }
  }
  return std::optional(std::move(bench));
}

Result<void> FaceBench::round(int number, const Stage& stage, const std::vector<CharacterState>& states) {
  for (std::size_t i = 0; i < with_.size(); ++i) {
    if (auto ok = load_state(stage.characters[i], states[i], with_[i]); !ok) return ok;
    without_[i].set_state({states[i].palette, states[i].morph_weights, {}});
  }
  Result<void> ok;
  const auto time = [&](std::vector<GpuDeformer>& deformers) {
    return milliseconds([&] {
      for (GpuDeformer& deformer : deformers)
        if (ok) ok = deformer.run();
    });
  };
  const bool face_first = number % 2 == 0;
  const double first = time(face_first ? with_ : without_), second = time(face_first ? without_ : with_);
  if (!ok) return ok;
  added_ms_.push_back(face_first ? first - second : second - first);
  return {};
}

double FaceBench::median_ms() const { return median(added_ms_); }

}  // namespace sinew
