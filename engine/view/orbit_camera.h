#pragma once
/// How dragging and turning the wheel move a camera. No Vulkan here.

#include "engine/app/frame.h"

namespace sinew {

/// A camera that turns round a point.
struct OrbitCamera {
  ViewDirection direction;
  Vec3 target{0.0};
  double distance = 1.0;
  Rays rays = Rays::from_eye;

  /// Where the scene has its camera at a frame, what it leaves open framed.
  static OrbitCamera of(const FrameMaker& maker, int frame, double aspect);
  /// Frames a box from where it looks.
  void frame(const Bounds& box, double aspect);
  /// Frames what lies within `reach` of a point, as `--zoom` does.
  void frame(const Vec3& centre, double reach, double aspect);

  /// `across`, `down`: shares of the picture's height that the pointer went.
  void orbit(double across, double down);
  /// What lies under the pointer at the target's depth stays under it.
  void pan(double across, double down);
  /// Each step comes a tenth nearer.
  void zoom(double steps);

  /// As a scene's camera, standing still.
  Camera camera() const;
};

}  // namespace sinew
