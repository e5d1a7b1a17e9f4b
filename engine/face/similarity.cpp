#include "engine/face/similarity.h"

#include <Eigen/Geometry>

namespace sinew {

Similarity Similarity::inverse() const {
  Similarity out;
  out.scale = 1.0 / scale;
  out.rotation = glm::transpose(rotation);
  out.translation = -out.scale * (out.rotation * translation);
  return out;
}

Mat4 Similarity::matrix() const {
  Mat4 out(scale * rotation);
  out[3] = Vec4(translation, 1.0);
  return out;
}

Similarity best_similarity(std::span<const Vec3> from, std::span<const Vec3> to) {
  Eigen::Matrix3Xd a(3, from.size()), b(3, to.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      a(c, static_cast<Eigen::Index>(i)) = from[i][c];
      b(c, static_cast<Eigen::Index>(i)) = to[i][c];
    }
  const Eigen::Matrix4d m = Eigen::umeyama(a, b, true);
  Similarity out;
  out.scale = std::cbrt(m.topLeftCorner<3, 3>().determinant());
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) out.rotation[c][r] = m(r, c) / out.scale;
    out.translation[c] = m(c, 3);
  }
  return out;
}

}  // namespace sinew
