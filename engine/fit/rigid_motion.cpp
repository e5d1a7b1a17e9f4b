#include "engine/fit/rigid_motion.h"

#include <Eigen/Dense>

namespace sinew {

void RigidMotion::add(const Vec3& p, const Vec3& q, double weight) {
  weight_ += weight * weight;
  p_ += weight * weight * p;
  q_ += weight * q;
  products_ += weight * glm::outerProduct(q, p);
}

Mat34 RigidMotion::solve(const Mat34& fallback) const {
  if (!(weight_ > 0.0)) return fallback;
  const Vec3 p = p_ / weight_, q = q_ / weight_;
  Eigen::Matrix3d covariance;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      covariance(row, column) = products_[column][row] - weight_ * q[row] * p[column];
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs(1.0, 1.0, 1.0);
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) signs[2] = -1.0;
  const Eigen::Matrix3d turn = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  Mat34 out;
  for (int row = 0; row < 3; ++row) {
    const Vec3 r(turn(row, 0), turn(row, 1), turn(row, 2));
    out.row[row] = Vec4(r, q[row] - glm::dot(r, p));
  }
  return out;
}

}  // namespace sinew
