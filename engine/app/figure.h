#pragma once
/// Pictures that explain: overlays, panels side by side, insets, diagrams, contact sheets, turntables. A plain picture
/// is the figure with nothing added.

#include <map>

#include "engine/app/figure_look.h"
#include "engine/app/frame.h"
#include "engine/render/overlay.h"
#include "engine/render/sheet.h"

namespace sinew {

/// Makes the pictures of a figure. The size that was asked for is that of the whole, panels and gutters included.
/// Device and stage must outlive it.
class FigureMaker {
 public:
  /// Fails as bad_input where the joint to zoom on, the scene to compare with or the muscles to plot are not there, as
  /// cannot_write where labels are needed and no font is installed.
  static Result<FigureMaker> create(Device& device, const Stage& stage, const SceneOptions& scene,
                                    const LookOptions& look, const FigureLook& figure,
                                    std::vector<std::string>& problems);
  FigureMaker(FigureMaker&&) noexcept;
  ~FigureMaker();

  /// The numbers of the pictures that the selected frames ask for: frames, turntable steps, or one sheet.
  std::vector<int> numbers(const std::vector<int>& frames) const;

  /// What the pictures of these frames show beyond the scene and its look, as text for the recipe.
  std::string recipe(const std::vector<int>& frames) const;

  /// The picture of one of those numbers.
  Result<Picture> picture(int number, const std::vector<int>& frames);

 private:
  struct Impl;
  explicit FigureMaker(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace sinew
