#pragma once
/// A head as a file.

#include "engine/core/files.h"
#include "engine/face/head_model.h"

namespace sinew {

/// The model as rig_glb writes it, with the head's landmarks, by name their vertices in the whole mesh (primitives
/// counted one after another) and their positions, its measures, and the drawing unit in metres in the mesh's extras.
Result<Bytes> head_glb(const Head& head, const Model& model);

}  // namespace sinew
