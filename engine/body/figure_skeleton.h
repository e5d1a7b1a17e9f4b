#pragma once
/// The skeletons of figures: joints by their H-Anim 2.0 names (ISO/IEC 19774-1).

#include <string>
#include <string_view>
#include <vector>

#include "engine/body/figure_measures.h"
#include "engine/model/model.h"

namespace sinew {

struct FigureJoint {
  std::string name;
  int parent = -1;
  int mirror = 0;      ///< the same joint on the other side; itself in the middle
  Vec3 position{0.0};  ///< fractions of body height
};

struct FigureSkeleton {
  std::vector<FigureJoint> joints;  ///< parents before children

  /// The joint of this name; where this skeleton lacks it, the one above it in the full hierarchy that it has.
  int find(std::string_view name) const;
  bool has(std::string_view name) const;
};

/// How many joints skeletons may have.
constexpr int figure_joint_counts[] = {23, 37, 68};

/// `count` is one of figure_joint_counts. 23: H-Anim's level 1 with two more joints of the spine, neck and clavicles;
/// 37 adds thumbs and the roots of the fingers; 68 all joints of the fingers, spine, shoulder and foot of level 2 but
/// the carpometacarpals of the fingers, the jaw, and a twist joint in upper arms and forearms.
FigureSkeleton figure_skeleton(const MeasuredBody& body, int count);

}  // namespace sinew
