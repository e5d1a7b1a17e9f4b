#pragma once
/// What the pointer does in the picture besides moving the camera: picks joints, turns them by rings, pulls hands and
/// feet, moves the line between a comparison's sides. ImGui's calls inside.

#include "engine/view/gizmo.h"
#include "engine/view/panels.h"

struct ImVec2;

namespace sinew {

class PictureTools {
 public:
  /// Draws the tools over the picture that is seen from `viewpoint` and lets them have the pointer. True where they
  /// use it, so that the camera must not move.
  bool work(const Document& document, ViewState& state, const Viewpoint& viewpoint);

 private:
  /// The picture in the window, and what is seen where. All in units of the interface from the picture's corner.
  struct Sight {
    const Viewpoint& viewpoint;
    Vec2 size;
    Screen screen;
    Vec2 pointer;
    bool free;    ///< the pointer is over the picture, and no panel has it
    Vec2 corner;  ///< of the picture in the window

    ImVec2 in_window(const Vec2& p) const;
    void stroke(const std::vector<Vec2>& line, unsigned colour, float width) const;
  };
  struct Turning {
    RingDrag drag;
    Scene scene;   ///< as it was before
    Vec3 degrees;  ///< likewise
    DegreeRange range;
  };
  /// A hand or foot, how it is called and where it is seen.
  struct Handle {
    std::size_t character;
    Limb limb;
    Vec3 place;
    ScreenPoint seen;
  };
  struct Pulling {
    Handle handle;
    Vec2 off;  ///< from the pointer to the handle
  };

  bool divide(ViewState& state, const Sight& sight);
  bool turn(const Document& document, ViewState& state, const Sight& sight);
  bool pull(const Document& document, ViewState& state, const Sight& sight);
  void pick(const Document& document, ViewState& state, const Sight& sight);
  std::vector<Handle> handles(const Document& document, const ViewState& state, const Sight& sight) const;

  bool dividing_ = false;  ///< the line between a comparison's sides is being dragged
  std::optional<Turning> turning_;
  std::optional<Pulling> pulling_;
  std::optional<Vec2> pressed_;  ///< where the button went down over the picture
};

}  // namespace sinew
