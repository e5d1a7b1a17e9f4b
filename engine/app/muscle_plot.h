#pragma once
/// Diagrams of a character's muscles (engine/definitions.md 3 and 6): how high they stand at every angle of the joint
/// that drives them, and along the limb. Heights and lengths in millimetres, a unit being a metre.

#include "engine/app/stage.h"
#include "engine/render/plot.h"

namespace sinew {

/// Makes the diagrams of a stage's first character that has muscles. The stage must outlive it.
class MusclePlotMaker {
 public:
  /// Fails as bad_input where no character has a muscle.
  static Result<MusclePlotMaker> create(const Stage& stage, MusclePlot kind, BulgeMode bulge);

  /// The diagram at a frame: curves that do not depend on it, or the muscles as they stand, and where they stand.
  Plot plot(int frame) const;

  Result<Picture> picture(int frame, const PictureSize& size, const Font& font) const;

 private:
  MusclePlotMaker(const Stage& stage, std::size_t character, MusclePlot kind, BulgeMode bulge)
      : stage_(&stage), character_(character), kind_(kind), bulge_(bulge) {}

  Plot by_angle(const CharacterState& state) const;
  Plot along_limb(const CharacterState& state) const;

  const Stage* stage_;
  std::size_t character_;
  MusclePlot kind_;
  BulgeMode bulge_;
};

}  // namespace sinew
