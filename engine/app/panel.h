#pragma once
/// One panel of a figure: a character's picture with its overlays and its inset.

#include "engine/app/figure.h"

namespace sinew {

/// A near view of a joint or a muscle, at the panel's upper right.
struct ZoomTarget {
  std::size_t character = 0;
  int node = -1;
  Vec4 place{0.0, 0.0, 0.0, 1.0};  ///< in the node's axes
  double reach = 0.0;              ///< half the height that is shown, world units
};

/// The joint or muscle of that name, and how much round it is worth seeing: most of a joint's longer neighbouring
/// segment, half of a muscle's. Of the first character that has it, or of one `only`. Fails as bad_input with the
/// nearest known name of a joint.
Result<ZoomTarget> find_zoom(const Stage& stage, const std::string& name, std::optional<std::size_t> only = {});

/// Where its middle is at a frame, world space.
Vec3 zoom_position(const Stage& stage, const ZoomTarget& zoom, int frame);

/// The size of a whole panel as an inset of another one.
PictureSize inset_size(const PictureSize& whole);

/// Draws one panel. Device and stage must outlive it.
class PanelMaker {
 public:
  static Result<PanelMaker> create(Device& device, const Stage& stage, const SceneOptions& scene,
                                   const LookOptions& look, const FigureLook& figure,
                                   std::vector<std::string>& problems);

  /// `orbit`: degrees added to the camera's. `font` may be null where nothing is labelled.
  Result<Picture> picture(int frame, double orbit, const Font* font);

  /// The near view alone, where there is one.
  Result<Picture> near_picture(int frame, double orbit, const Font* font);
  void name_inset(const std::string& label) { inset_label_ = label; }
  bool has_near_picture() const { return near_.has_value(); }

 private:
  PanelMaker(const Stage& stage, FrameMaker main, const SceneOptions& scene, const FigureLook& figure)
      : stage_(&stage), main_(std::move(main)), scene_(scene), figure_(figure) {}

  OverlayContent content(int frame) const;

  const Stage* stage_;
  FrameMaker main_;
  std::optional<FrameMaker> near_;
  ZoomTarget zoom_;
  SceneOptions scene_;
  FigureLook figure_;
  std::string inset_label_;  ///< the joint's name, unless name_inset() says otherwise
};

}  // namespace sinew
