/// The ear: an egg outline in a plane that stands off the skull, rings into its shell. Its front lies on the head.

#include "engine/face/head_cage_parts.h"

namespace sinew {
namespace {

constexpr int front_places = 8, lobe = 8, top = 17;

/// The ear's plane: p backward, q up, h outward.
class EarPlane {
 public:
  explicit EarPlane(const HeadPlan& plan) {
    constexpr double lean = 10.0 * degrees_to_radians;
    const double flare = plan.m.ear_flare * degrees_to_radians;
    const double middle = 0.5 * (plan.m.ear_bottom + plan.m.ear_top);
    origin_ = {plan.loft.at(90.0, middle).x, middle, plan.m.ear_depth};
    const Vec3 back(std::sin(flare), 0.0, -std::cos(flare)), up(0.0, 1.0, 0.0);
    backward_ = std::cos(lean) * back - std::sin(lean) * up;
    upward_ = std::sin(lean) * back + std::cos(lean) * up;
    outward_ = {std::cos(flare), 0.0, std::sin(flare)};
  }
  Vec3 at(double p, double q, double h) const { return origin_ + p * backward_ + q * upward_ + h * outward_; }
  const Vec3& outward() const { return outward_; }
  const Vec3& backward() const { return backward_; }

 private:
  Vec3 origin_, backward_, upward_, outward_;
};

/// A place on the outline: its coordinates in the plane and how far back it lies, -1 to 1.
struct OutlinePlace {
  double p, q, back;
};

OutlinePlace outline(int i, double half_height) {
  double degrees = 90.0;
  if (i < front_places) degrees = 125.0 + 110.0 * i / 7.0;
  if (i == lobe) degrees = 270.0;
  if (i > lobe && i < top) degrees = 305.0 + 110.0 * (i - 9) / 7.0;
  const double c = std::cos(degrees * degrees_to_radians), s = std::sin(degrees * degrees_to_radians);
  const double half_width = 0.60 * half_height * (s > 0 ? 1.02 : 1.0 - 0.26 * std::pow(-s, 1.3));
  const double p = c * half_width * (c < 0 ? 0.62 : 1.0);
  return {p + 0.06 * half_height / 0.46, s * half_height, c};
}

class EarBuilder {
 public:
  EarBuilder(const HeadPlan& plan, HeadCage& cage)
      : plan_(plan), cage_(cage), plane_(plan), half_height_(0.5 * (plan.m.ear_top - plan.m.ear_bottom)) {}

  void add_rings(int i) {
    const OutlinePlace o = outline(i, half_height_);
    const double size = half_height_ / 0.46, rear = std::clamp(o.back + 0.55, 0.0, 1.0);
    // Between the ear's own plane (0) and the head (1): else a slit opens before the ear.
    const double on_head = smoothstep01((-o.back - 0.05) / 0.6);
    const auto mix = [&](double p, double q, double h, double h_head) {
      return glm::mix(plane_.at(p, q, h), head(p, q, h_head > 0 ? h_head * calm(i) : h_head), on_head);
    };
    const Vec3 hole = cage_.at(ear_hole(i));
    const Vec3 rim = mix(o.p, o.q, 0.02 + 0.05 * rear, 0.02);
    const Vec3 behind =
        on_head < 0.3 ? 0.45 * hole + 0.55 * mix(0.93 * o.p, 0.95 * o.q, -0.015, 0.01) : 0.5 * (hole + rim);
    cage_.put(ear_point(1, i), behind);
    cage_.put(ear_point(2, i), rim);
    cage_.put(ear_point(3, i), mix(0.90 * o.p, 0.925 * o.q, 0.045 + 0.05 * rear, 0.045));
    // The furrow inside the rim, the fold before it, the shell; the lobe is full.
    const double lobe_share = smoothstep01((-o.q / half_height_ - 0.45) / 0.4), p = o.p - 0.03;
    const double furrow = glm::mix(-0.035 + 0.02 * rear, 0.045, lobe_share);
    const double fold = glm::mix(0.060 * rear, 0.02, lobe_share);
    const double tragus = tragus_share(i);
    const auto inner = [&](double along, double up, double h, double h_head) {
      return mix(along, up, h, h_head) + tragus * size * (0.085 * plane_.backward() + 0.05 * plane_.outward());
    };
    cage_.put(ear_point(4, i),
              mix(0.74 * o.p, 0.79 * o.q, furrow, 0.03) + 0.4 * tragus * size * 0.06 * plane_.outward());
    cage_.put(ear_point(5, i), inner(0.58 * p + 0.01, 0.56 * o.q - 0.02 * size, fold, -0.01));
    cage_.put(ear_point(6, i), mix(0.36 * p - 0.005, 0.32 * o.q - 0.04 * size, -0.11, -0.095));
  }

  void add_floor() {
    for (int r = 1; r < 7; ++r)
      cage_.put(ear_point(7, r),
                0.5 * (cage_.at(ear_point(6, r)) + cage_.at(ear_point(6, 16 - r))) - 0.02 * plane_.outward());
    const auto middle = [](int r) {
      return r == 0 ? ear_point(6, top) : (r == 7 ? ear_point(6, lobe) : ear_point(7, r));
    };
    for (int r = 0; r < 7; ++r) {
      cage_.quad(ear_point(6, r), ear_point(6, r + 1), middle(r + 1), middle(r));
      cage_.quad(middle(r), middle(r + 1), ear_point(6, 15 - r), ear_point(6, 16 - r));
    }
  }

 private:
  /// The flap before the ear's hole, a little below the middle.
  static double tragus_share(int i) {
    constexpr double share[] = {0.0, 0.0, 0.1, 0.55, 1.0, 0.75, 0.2, 0.0};
    return i < front_places ? share[i] : 0.0;
  }
  /// The front's upper and lower end run out into the head.
  static double calm(int i) {
    switch (i) {
      case 0:
        return 0.25;
      case 1:
        return 0.7;
      case 6:
        return 0.8;
      case 7:
        return 0.3;
      default:
        return 1.0;
    }
  }
  Vec3 head(double p, double q, double h) const {
    const Vec3 on_plane = plane_.at(p, q, 0.0);
    const Vec3 skull = plan_.loft.at(plan_.loft.theta_of_depth(on_plane.z, on_plane.y), on_plane.y);
    return skull + h * Vec3(1.0, 0.0, 0.3);
  }

  const HeadPlan& plan_;
  HeadCage& cage_;
  EarPlane plane_;
  double half_height_;
};

}  // namespace

CagePoint ear_hole(int place) {
  if (place < front_places) return side_point(1, ear_first_row + place);
  if (place == lobe) return side_point(2, ear_last_row);
  if (place < top) return side_point(3, ear_last_row - (place - 9));
  return side_point(2, ear_first_row);
}

void add_ear(const HeadPlan& plan, HeadCage& cage) {
  EarBuilder builder(plan, cage);
  for (int i = 0; i < ear_places; ++i) builder.add_rings(i);
  const auto point = [](int ring, int i) {
    return ring == 0 ? ear_hole(i % ear_places) : ear_point(ring, i % ear_places);
  };
  for (int ring = 0; ring < 6; ++ring)
    for (int i = 0; i < ear_places; ++i)
      cage.quad(point(ring, i), point(ring, i + 1), point(ring + 1, i + 1), point(ring + 1, i));
  builder.add_floor();
}

}  // namespace sinew
