#pragma once
/// A head as a model: one mesh, a primitive a material, in metres.

#include <span>
#include <string>

#include "engine/face/face_shapes.h"
#include "engine/face/head.h"
#include "engine/model/model.h"

namespace sinew {

/// The head in the shape `base` (its own positions and normals if null), with a morph target a shape: what is added to
/// the base. A vertex stands once in each primitive that uses it.
Model head_model(const Head& head, const HeadShape* base, std::span<const HeadShape> shapes);

/// Which vertex of the head each of the model's is, primitives one after another. [vertices of the model]
std::vector<std::uint32_t> head_vertices(const Head& head);

/// Where each vertex of the head came to stand: [vertices] its number in the first primitive that has it, vertices of
/// the primitives before counted.
std::vector<std::uint32_t> model_vertices(const Head& head);

}  // namespace sinew
