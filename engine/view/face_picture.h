#pragma once
/// A face as a comic draws it: the nine regions and their helpers as a few lines, with handles that are dragged.
/// Drawing units as the viewer sees them: x to the viewer's right, which is the character's left, y up from the chin.

#include <vector>

#include "engine/view/face_edit.h"

namespace sinew {

/// A point that moves one or two channels.
struct FaceHandle {
  const char* name;
  Vec2 at{0.0};  ///< where the channels have it now
  /// What a channel gains when the handle goes one unit along `way`.
  struct Lead {
    FaceChannel channel;
    Vec2 way{0.0};  ///< unit length
    double gain = 1.0;
  };
  std::vector<Lead> leads;

  /// Where the channels are to go when the handle has been pulled from where `face` shows it.
  std::vector<ChannelGoal> pulled(const ShownFace& face, const Vec2& by) const;
  /// The corners of where it can go: two for one channel, four for two.
  std::vector<Vec2> reach(const ShownFace& face) const;
};

struct FacePicture {
  /// A brow's two edges, which run the same way.
  struct Brow {
    std::vector<Vec2> one, other;
  };
  /// An eye: lids from its viewer's left to its right, the iris.
  struct Eye {
    std::vector<Vec2> upper, lower;
    Vec2 iris{0.0};
    double iris_radius = 0.0;
  };
  std::vector<Vec2> outline;  ///< of cheeks and jaw, open at the top
  std::vector<Brow> brows;
  std::vector<Eye> eyes;                   ///< the character's left first
  std::vector<Vec2> nose;                  ///< a line
  std::vector<Vec2> lip_outer, lip_inner;  ///< closed
  std::vector<FaceHandle> handles;
};

FacePicture face_picture(const ShownFace& face, const FaceGuides& guides);

/// The picture's part that is worth seeing, lower left and upper right corners.
constexpr Vec2 face_picture_low{-1.12, -0.62}, face_picture_high{1.12, 2.70};

}  // namespace sinew
