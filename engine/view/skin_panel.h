#pragma once
/// What the skin panel shows and what the user did in it.

#include <string>

namespace sinew {

struct SkinPanel {
  std::string mesh;      ///< the file that is bound: the chosen character's model; empty: a built-in one
  std::string skeleton;  ///< the file whose joints it shall follow
  std::string output;    ///< .glb
  int resolution = 192;  ///< voxels along the longest side, 16 to 384
  int influences = 4;    ///< at most so many joints a vertex, 1 to 8
  bool opens = false;    ///< the panel is to open: what was opened has no skin weights
  bool bind = false;     ///< asked for
  bool binds = false;    ///< under way
};

/// Takes another model in: the fields get the values that suit it.
void follow_model(SkinPanel& panel, const std::string& model, bool has_skin);

}  // namespace sinew
