#pragma once
/// A human figure made from measures alone: rigged, skinned, with texture coordinates (engine/definitions.md 11).

#include <string_view>

#include "engine/core/result.h"
#include "engine/model/model.h"

namespace sinew {

struct BodyOptions {
  double sex = 0.0;     ///< 0 male to 1 female
  double height = 0.0;  ///< metres, 0.3 to 3; 0: 1.75 male to 1.63 female
  double build = 0.0;   ///< -1 slim to 1 heavy
  double muscle = 0.5;  ///< 0 to 1
  int joints = 68;      ///< 23, 37 or 68
  int vertices = 8000;  ///< about so many, those on seams of the texture counted for each side
  int triangles = 0;    ///< about so many, weighed equally with the vertices; 0: as come with them
};

/// The fewest and the most vertices that a figure can have.
constexpr int fewest_figure_vertices = 1840, most_figure_vertices = 2'000'000;

/// Options of a figure that is like one of the thesis' characters in its numbers of vertices, triangles and joints:
/// "skeleton" (1,844, 3,342, 23), "woman" (2,365, 4,412, 37), or "poser" (86,529, 166,368, 68). Fails as usage for
/// another name.
Result<BodyOptions> figure_preset(std::string_view name);

/// Fails as usage, naming the option, where one is out of its range.
Result<void> check_figure_options(const BodyOptions& options);

/// The figure in an A pose: front +z, left +x, soles at y = 0, metres. Its right half is the mirror image of the left.
/// One closed mesh; where its texture is cut open vertices stand twice. Equal options give the same model to the bit.
/// Fails as check_figure_options does.
Result<Model> build_figure(const BodyOptions& options);

}  // namespace sinew
