#pragma once
/// Three rings about a joint, each of which turns one of a joint key's three numbers. No interface here.

#include <array>
#include <optional>
#include <vector>

#include "engine/view/picking.h"

namespace sinew {

struct Gizmo {
  Vec3 centre{0.0};
  std::array<Vec3, 3> axes{};  ///< unit axes in the world that a key's x, y and z turn the joint about, as it stands
  double radius = 0.0;         ///< world units
};

/// A gizmo that is `pixels` high from its centre.
Gizmo make_gizmo(const JointStand& stand, const Viewpoint& viewpoint, double picture_height, double pixels);

/// A ring as it is drawn: its half towards the camera, and all of it.
struct RingLines {
  std::vector<Vec2> front, whole;
};
RingLines ring_lines(const Gizmo& gizmo, int ring, const Screen& screen);

/// The ring whose front half is nearest to the pointer, at most `reach` pixels away; -1: none.
int ring_near(const Gizmo& gizmo, const Screen& screen, const Vec2& at, double reach);

/// A ring that is being turned. The camera stands still meanwhile.
class RingDrag {
 public:
  RingDrag(const Gizmo& gizmo, int ring, const Viewpoint& viewpoint, const Vec2& size, const Vec2& at);

  /// Follows the pointer; the degrees turned since the ring was taken, whole turns too. Rings that are seen from the
  /// side go with the pointer's way along them.
  double follow(const Vec2& at);
  int ring() const { return ring_; }

 private:
  std::optional<double> angle(const Vec2& at) const;

  Gizmo gizmo_;
  int ring_;
  Viewpoint viewpoint_;
  Vec2 size_;
  Vec3 first_{0.0}, second_{0.0};  ///< axes in the ring's plane
  bool from_side_ = false;
  Vec2 taken_{0.0}, tangent_{0.0};  ///< pixels; degrees a pixel
  double last_ = 0.0, turned_ = 0.0;
};

/// A key's number after its ring was turned: within the range, and with `steps` a multiple of five degrees.
double turned_number(double from, double by, const DegreeRange& range, bool steps);

}  // namespace sinew
