#include "engine/face/fitted_ball.h"

#include <Eigen/QR>

namespace sinew {

FittedBall fitted_ball(const std::vector<Vec3>& points) {
  Eigen::MatrixXd a(points.size(), 4);
  Eigen::VectorXd b(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    a.row(row) << 2 * points[i].x, 2 * points[i].y, 2 * points[i].z, 1.0;
    b(row) = glm::dot(points[i], points[i]);
  }
  const Eigen::Vector4d x = a.colPivHouseholderQr().solve(b);
  FittedBall out;
  out.centre = {x(0), x(1), x(2)};
  out.radius = std::sqrt(std::max(0.0, x(3) + glm::dot(out.centre, out.centre)));
  double sum = 0.0;
  for (const Vec3& p : points) sum += std::pow(glm::distance(p, out.centre) - out.radius, 2);
  out.error = std::sqrt(sum / static_cast<double>(points.size())) / std::max(out.radius, 1e-12);
  return out;
}

}  // namespace sinew
