/// Neck: leaning ellipses from under the jaw to the base.

#include "engine/face/head_cage_parts.h"

namespace sinew {
namespace {

constexpr int places = 15, rings = 6, last_front = 8;

/// A leaning ellipse round the neck.
struct NeckRing {
  double width, front, back, height, lean;

  Vec3 at(double degrees) const {
    const double s = std::sin(degrees * degrees_to_radians), c = std::cos(degrees * degrees_to_radians);
    return {width * s, height - lean * c, 0.5 * (front + back) + 0.5 * (front - back) * c};
  }
};

}  // namespace

CagePoint jaw_rim(int place) {
  if (place <= 3) return chin_point(3 - place, 2);
  if (place <= 6) return cheek_point(place - 3, cheek_rows - 1);
  return side_point(place - 7, side_rows - 1);
}

void add_neck(const HeadPlan& plan, HeadCage& cage) {
  const double w = plan.m.neck_width, f = plan.m.neck_front, b = plan.m.neck_back, y = plan.m.neck_rise;
  const double l = plan.m.neck_length;
  const NeckRing ring_shapes[] = {{0.98 * w, f + 0.03, b + 0.02, -0.02 + y, 0.17},
                                  {1.00 * w, f - 0.03, b - 0.02, -0.36 * l + y, 0.16},
                                  {1.10 * w, f - 0.06, b - 0.14, -0.72 * l + y, 0.16},
                                  {1.52 * w, f + 0.02, b - 0.30, -1.02 * l + y, 0.12},
                                  {1.56 * w, f + 0.03, b - 0.32, -1.02 * l - 0.07 + y, 0.12}};
  constexpr double degrees[places] = {0, 13, 25, 38, 50, 61, 72, 83, 96, 108, 118, 130, 148, 164, 180};
  for (int i = 0; i < places; ++i) {
    const Vec3 rim = cage.at(jaw_rim(i)), below = ring_shapes[0].at(degrees[i]);
    Vec3 under = glm::mix(rim, below, i <= last_front ? 0.42 : 0.5);
    if (i <= last_front) under.y = glm::mix(rim.y, below.y, 0.2) + (i < 4 ? 0.035 : 0.0);
    for (int ring = 0; ring < rings; ++ring) {
      Vec3 p = ring == 0 ? under : ring_shapes[ring - 1].at(degrees[i]);
      if (i == 0 || i == places - 1) p.x = 0.0;
      cage.put(neck_point(ring, i), p);
    }
  }
  const auto point = [](int ring, int i) { return ring < 0 ? jaw_rim(i) : neck_point(ring, i); };
  for (int ring = -1; ring + 1 < rings; ++ring)
    for (int i = 0; i + 1 < places; ++i)
      cage.quad(point(ring, i), point(ring + 1, i), point(ring + 1, i + 1), point(ring, i + 1));
}

}  // namespace sinew
