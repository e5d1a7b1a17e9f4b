#pragma once
/// Skin weights of a single vertex from where it stood in example poses. engine/definitions.md 16.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "engine/fit/bone_poses.h"
#include "engine/model/model.h"

namespace sinew {

/// Some bones of one vertex with their weights, in no order.
struct Support {
  static constexpr std::size_t most = 32;  ///< more than are ever kept: the choice among them comes last

  std::size_t size = 0;
  std::array<std::uint32_t, most> bone{};
  std::array<double, most> weight{};
  double error = 0.0;  ///< sum over the poses of the squared distance to the examples

  void add(std::uint32_t b, double w) {
    bone[size] = b;
    weight[size++] = w;
  }
  void remove(std::size_t i) {
    --size;
    bone[i] = bone[size];
    weight[i] = weight[size];
  }
  bool has(std::uint32_t b) const;
};

/// Fits one vertex after the other; each thread has its own. With weights that sum to 1 the residual is `D w`, column b
/// of D being what vertex and example differ by when the vertex follows bone b alone, [3 * poses].
class VertexFit {
 public:
  /// `poses` must outlive it.
  explicit VertexFit(const BonePoses& poses);

  /// Turns to a vertex: its bind position and its places in the poses, [poses].
  void begin(const Vec3& rest, std::span<const Vec3> posed);

  /// At most `influences` bones with w >= 0 and sum w = 1. The active-set method of Lawson and Hanson finds the best
  /// weights over all bones; of more than `influences` bones the one that is missed least goes, again and again; then
  /// bones are exchanged while that helps.
  Support convex(std::size_t influences);

  /// The same from the bones and weights of an earlier fit on, to bones that have moved a little: bones are added where
  /// there are fewer than `influences`, and exchanged. Faster; may stay at a choice that convex() would better.
  Support convex_from(Support start, std::size_t influences);

  /// The paper's: the bones of the smallest lone errors, least squares with sum w = 1 by SVD, the solution nearest to
  /// equal weights where there are many. Weights may be negative.
  Support paper(std::size_t influences);

  /// Takes out bones, those missed least first, as long as each raises the error by less than `allowance`.
  void prune(Support& support, double allowance);

  /// The residual D w, [3 * poses].
  Eigen::VectorXd residual(const Support& support);

  /// True where the examples leave the weights on these bones open: some of them moved the vertex alike.
  bool undetermined(const Support& support);

 private:
  const Eigen::VectorXd& column(std::uint32_t bone);
  void compute_error(Support& support);
  void solve_equal(const Support& support, std::array<double, Support::most>& weights);
  void settle(Support& support);
  Support without(const Support& support, std::size_t i);
  std::uint32_t steepest(const Support& support, double& slope);
  Support best_over_all();
  /// Adds bones, the steepest first, as long as the error falls and there are fewer than `most`.
  void grow(Support& support, std::size_t most);
  void exchange(Support& support);

  const BonePoses& poses_;
  Vec3 rest_{0.0};
  std::span<const Vec3> posed_;
  double negligible_ = 0.0;               ///< squared residual that is rounding
  std::vector<Eigen::VectorXd> columns_;  ///< [bones], computed when they are asked for
  std::vector<double> lone_errors_;       ///< [bones] gamma, of the columns that are there
  std::vector<char> there_;               ///< [bones]
  std::vector<char> tried_;               ///< [bones] in vain, from the support of the moment
  Eigen::MatrixXd differences_;           ///< [3 * poses, Support::most] work space
};

}  // namespace sinew
