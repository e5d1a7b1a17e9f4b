#pragma once
/// Skin weights of figures, by construction: every vertex knows what it was made as a part of, and follows the joints
/// of that part alone (engine/definitions.md 11).

#include <array>
#include <vector>

#include "engine/body/figure_cage.h"
#include "engine/body/figure_skeleton.h"
#include "engine/body/figure_strips.h"
#include "engine/model/model.h"

namespace sinew {

/// How far a vertex belongs to each chain; the shares sum to 1.
using ChainShares = std::array<double, chain_count>;

/// [refined vertices] shares, blended over the borders of chains: on the cage, and once more where refinement would
/// leave a kink along the cage's edges.
std::vector<ChainShares> chain_shares(const HalfCage& cage, const RefinedQuads& refined);

class FigureWeights {
 public:
  /// Both outlive the weights.
  FigureWeights(const MeasuredBody& body, const FigureSkeleton& skeleton);

  /// At most four influences, joints of the skeleton, of a vertex of the left half at `position`. A vertex on the plane
  /// of symmetry follows joints of the middle alone.
  std::vector<Influence> at(const Vec3& position, const ChainShares& shares, bool on_plane) const;

 private:
  using Weights = std::vector<double>;  ///< [joints]
  /// Joints along a part: the first owns all before the first border, each other all behind its own.
  struct Step {
    int joint = 0;
    double border = 0.0, half_width = 0.0;
  };

  void add_chain(Chain chain, const Vec3& position, double share, Weights& weights) const;
  void add_trunk(const Vec3& position, double share, Weights& weights) const;
  /// How far the upper arm carries the skin at the shoulder, 0 to 1.
  double arm_share(const Vec3& position) const;
  void add_shoulder(const Vec3& position, double share, Weights& weights) const;
  void add_head(const Vec3& position, double share, Weights& weights) const;
  void add_arm(const Vec3& position, double share, Weights& weights) const;
  void add_leg(const Vec3& position, double share, Weights& weights) const;
  void add_foot(const Vec3& position, double share, Weights& weights) const;
  void add_finger(int finger, const Vec3& position, double share, Weights& weights) const;
  std::vector<Step> steps_present(std::span<const std::pair<const char*, double>> wanted,
                                  std::span<const double> half_widths) const;
  int joint(std::string_view name) const { return skeleton_.find(name); }

  const MeasuredBody& body_;
  const FigureSkeleton& skeleton_;
  std::vector<Step> spine_, foot_, leg_, arm_;
  std::array<std::vector<Step>, 5> finger_;
  double arm_radius_ = 0.0;
  int clavicle_ = 0, acromion_ = 0, head_ = 0, jaw_ = 0, neck_ = 0;
};

}  // namespace sinew
