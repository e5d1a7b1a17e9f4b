#pragma once
/// What a face costs: `face_ms` of `sinew bench`.

#include <optional>
#include <vector>

#include "engine/app/stage.h"
#include "engine/gpu/gpu_deformer.h"

namespace sinew {

/// Plain SSD of all characters with their faces and without, one after the other; which comes first alternates.
class FaceBench {
 public:
  /// Nothing where no character has a face.
  static Result<std::optional<FaceBench>> create(Device& device, const Stage& stage);

  /// Times one round in these states.
  Result<void> round(int number, const Stage& stage, const std::vector<CharacterState>& states);
  /// Drops what was timed so far.
  void forget() { added_ms_.clear(); }
  /// The median over the rounds of what the face adds, milliseconds.
  double median_ms() const;

 private:
  std::vector<GpuDeformer> with_, without_;
  std::vector<double> added_ms_;
};

}  // namespace sinew
