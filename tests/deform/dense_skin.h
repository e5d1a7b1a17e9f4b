#pragma once
/// Skinning written down again with Eigen: one dense 4x4 matrix a joint, one dense row of weights a vertex. Slow, and
/// alike to the engine's in nothing but the definition.

#include <vector>

#include <Eigen/Dense>

#include "engine/model/character_mesh.h"

namespace sinew::test {

inline Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }
inline Vec3 plain(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

inline Eigen::Matrix4d eigen(const Mat34& m) {
  Eigen::Matrix4d out = Eigen::Matrix4d::Identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) out(row, column) = m.row[row][column];
  return out;
}

inline Eigen::Matrix3d eigen(const Mat3& m) {
  Eigen::Matrix3d out;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) out(row, column) = m[column][row];
  return out;
}

/// [vertices x joints]
inline Eigen::MatrixXd dense_weights(const Influences& influences, std::size_t joints) {
  Eigen::MatrixXd weights =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(influences.vertices()), static_cast<Eigen::Index>(joints));
  for (std::size_t v = 0; v < influences.vertices(); ++v)
    for (std::uint32_t i = influences.first[v]; i < influences.first[v + 1]; ++i)
      weights(static_cast<Eigen::Index>(v), influences.entries[i].joint) += influences.entries[i].weight;
  return weights;
}

/// The blended matrix of one vertex: the sum over all joints.
inline Eigen::Matrix4d dense_blend(const Eigen::MatrixXd& weights, const std::vector<Mat34>& palette, std::size_t v) {
  Eigen::Matrix4d blend = Eigen::Matrix4d::Zero();
  for (std::size_t j = 0; j < palette.size(); ++j)
    blend += weights(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(j)) * eigen(palette[j]);
  return blend;
}

inline Vec3 dense_point(const Eigen::Matrix4d& blend, const Vec3& p) {
  return plain((blend * eigen(p).homogeneous()).head<3>());
}

inline Vec3 dense_normal(const Eigen::Matrix4d& blend, const Vec3& n) {
  const Eigen::Matrix3d inverse_transpose = blend.topLeftCorner<3, 3>().inverse().transpose();
  return plain((inverse_transpose * eigen(n)).normalized());
}

}  // namespace sinew::test
