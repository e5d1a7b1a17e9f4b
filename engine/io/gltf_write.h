#pragma once
/// glTF 2.0 out: deformed vertices, or the whole rig, as one `.glb`. Both pass the Khronos validator without a message
/// of severity error or warning, but for what it says of a picture that the model's file had already. The same data
/// gives the same bytes.

#include <string_view>

#include "engine/core/files.h"
#include "engine/core/result.h"
#include "engine/model/baked_mesh.h"
#include "engine/model/model.h"

namespace sinew {

/// The baked mesh as one node named `name`: positions, normals, texture coordinates and triangles of the first frame.
/// Where there are several frames, each has a position and a normal morph target (its difference to the first), and an
/// animation "baked" blends linearly from key to key at `times`. A mesh without triangles gives the node alone.
/// Fails as bad_input where times do not rise from 0 or later as 32-bit floats, a number is not finite, or the file
/// would pass 4 GiB.
Result<Bytes> baked_glb(const BakedMesh& mesh, std::string_view name);

/// What the model's scene shows, as a rig: nodes, skins, influences, morph targets with their names, clips, materials
/// and pictures as the file had them. A picture that is neither PNG nor JPEG is left out. Nodes keep their indices and
/// names; where glTF's rules ask for other places, rig_layout.h says what moves. The humanoid map is not written: the
/// joints keep the names by which it is found again.
/// Fails as bad_input, naming the place in the written file, where key times do not rise from 0 or later as 32-bit
/// floats, a number is not finite as one, a skin has more than 65536 joints, or the file would pass 4 GiB.
Result<Bytes> rig_glb(const Model& model);

}  // namespace sinew
