#pragma once
/// Wavefront OBJ out.

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/model/baked_mesh.h"

namespace sinew {

/// One frame as OBJ text: the comment's lines behind `#`, then `v`, `vt` where the mesh has texture coordinates, `vn`,
/// and `f` with indices from 1. World units; numbers have 9 significant digits, which give the same float back, and a
/// decimal point whatever the locale. `vt` counts upwards from the picture's lower edge, as OBJ readers expect: 1 - v.
std::string obj_text(const BakedMesh& mesh, std::size_t frame, std::string_view comment);

}  // namespace sinew
