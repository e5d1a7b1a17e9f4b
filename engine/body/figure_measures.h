#pragma once
/// The measured bodies (engine/body/figure_measures.json, part of the library) and what lies between them.

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/body/figure_part.h"

namespace sinew {

/// One step of the union: a part, or two nodes joined with a fillet that reaches `fillet` far.
struct UnionNode {
  int part = -1;  ///< index into MeasuredBody::parts, or -1
  double fillet = 0.0;
  int one = -1, other = -1;  ///< indices into MeasuredBody::tree
};

/// The left half of a body, lengths in fractions of its height: soles at y = 0, front +z, left +x.
struct MeasuredBody {
  double height = 0.0;                   ///< metres, where nobody asks for another
  std::map<std::string, Vec3> joints;    ///< centres
  std::map<std::string, double> girths;  ///< as a tape measures them
  std::vector<BodyPart> parts;
  std::vector<UnionNode> tree;  ///< children before parents: the last is the whole

  const BodyPart& part(std::string_view name) const;
  const Vec3& joint(const std::string& name) const { return joints.at(name); }
};

/// The body between the measured male (`sex` 0) and female (1), changed by `build` (-1 slim to 1 heavy; 0 as measured)
/// and `muscle` (0 to 1; 0.5 as measured).
MeasuredBody measured_body(double sex, double build, double muscle);

}  // namespace sinew
