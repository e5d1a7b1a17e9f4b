#pragma once
/// One panel of a figure: a character's picture with its overlays and its inset.

#include "engine/app/figure.h"

namespace sinew {

/// A near view of a joint, at the panel's upper right.
struct ZoomTarget {
  std::size_t character = 0;
  int node = -1;
  double reach = 0.0;  ///< half the height that is shown, world units
};

/// The joint of that name, and how much round it is worth seeing: most of its longer neighbouring segment. Fails as
/// bad_input with the nearest known name.
Result<ZoomTarget> find_zoom(const Stage& stage, const std::string& joint);

/// Draws one panel. Device and stage must outlive it.
class PanelMaker {
 public:
  static Result<PanelMaker> create(Device& device, const Stage& stage, const SceneOptions& scene,
                                   const LookOptions& look, const FigureOptions& figure,
                                   std::vector<std::string>& problems);

  /// `orbit`: degrees added to the camera's. `font` may be null where nothing is labelled.
  Result<Picture> picture(int frame, double orbit, const Font* font);

 private:
  PanelMaker(const Stage& stage, FrameMaker main, const SceneOptions& scene, const FigureOptions& figure)
      : stage_(&stage), main_(std::move(main)), scene_(scene), figure_(figure) {}

  Result<Picture> inset(int frame, double orbit, const Font* font);
  OverlayContent content(int frame) const;

  const Stage* stage_;
  FrameMaker main_;
  std::optional<FrameMaker> near_;
  ZoomTarget zoom_;
  SceneOptions scene_;
  FigureOptions figure_;
};

}  // namespace sinew
