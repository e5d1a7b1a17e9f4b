#pragma once
#include <vector>

#include "engine/model/model.h"

namespace sinew {

/// Tangents of a surface for its normal texture: the directions in which the texture's u rises, one a vertex.
///
/// Every triangle says how the surface moves with u and v; a vertex takes the sum over its triangles, weighted by their
/// angle there, laid into the plane of its normal (Lengyel 2001; weights as in Mikkelsen 2008). Where triangles of both
/// handedness meet in a vertex, those of the greater angle prevail: no vertices are split. Where the texture
/// coordinates say nothing (all alike, or none), any direction in the plane stands in.
/// @return [vertices] unit length, w: 1 or -1, bitangent = w (normal x tangent)
std::vector<Vec4> generate_tangents(const Primitive& primitive, const Texture& texture);

}  // namespace sinew
