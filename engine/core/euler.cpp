#include "engine/core/euler.h"

namespace sinew {

Quat axis_rotation(int axis, double radians) {
  Vec3 direction(0.0);
  direction[axis] = 1.0;
  return glm::angleAxis(radians, direction);
}

Quat from_euler(const Vec3& radians, const EulerOrder& order) {
  return axis_rotation(order[0], radians[0]) * axis_rotation(order[1], radians[1]) *
         axis_rotation(order[2], radians[2]);
}

Vec3 to_euler(const Quat& rotation, const EulerOrder& order) {
  // Of R = R_i R_j R_k: entry (i, k) is s sin(middle), row i and column k hold the other two; s is the sign of ijk.
  const auto [i, j, k] = order;
  const double s = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;
  const Mat3 m = glm::mat3_cast(glm::normalize(rotation));
  const auto entry = [&](int row, int column) { return m[column][row]; };
  const double cosine = std::hypot(entry(i, i), entry(i, j));
  const double middle = std::atan2(s * entry(i, k), cosine);
  constexpr double locked = 1e-9;
  if (cosine < locked) return {std::atan2(s * entry(k, j), entry(j, j)), middle, 0.0};
  return {std::atan2(-s * entry(j, k), entry(k, k)), middle, std::atan2(-s * entry(i, j), entry(i, i))};
}

}  // namespace sinew
