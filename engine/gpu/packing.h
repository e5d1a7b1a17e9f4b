#pragma once
/// A character as the deform pass reads it: the layout is described in shaders/layout.h. No Vulkan here.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/body/muscle_placement.h"
#include "engine/deform/bulge.h"
#include "engine/deform/face.h"
#include "engine/deform/rest_shape.h"
#include "engine/deform/rigid_split.h"
#include "shaders/layout.h"

namespace sinew {

/// Sixteen bytes as the shader loads them.
struct Word {
  std::uint32_t x = 0, y = 0, z = 0, w = 0;
  friend bool operator==(const Word&, const Word&) = default;
};

struct PackedCharacter {
  std::vector<Word> vertices;   ///< [vertices * layout::words_per_vertex]
  std::vector<Word> details;    ///< of the vertices that have any; the first few words are zero
  std::vector<Vec4f> tangents;  ///< [vertices], or empty
  bool has_morphs = false;
  bool has_extra_influences = false;
  bool has_face = false;

  std::size_t vertex_count() const { return vertices.size() / layout::words_per_vertex; }
};

/// Packs the mesh's vertices, followed by the `duplicates` of a rigid split (each follows one joint only).
/// Fails where the palette has more than 65,536 joints, a vertex lies in more than 15 regions, or the details are more
/// than 2^28 words.
Result<PackedCharacter> pack_character(const CharacterMesh& mesh, const RestShape& rest,
                                       std::span<const PlacedMuscle> muscles,
                                       std::span<const RigidDuplicate> duplicates = {});

/// True where pack_character() makes the same words of both: they differ at most in what pack_muscle() holds, in
/// angles, or in their names.
bool is_packed_alike(const PlacedMuscle& a, const PlacedMuscle& b);

/// The palette's rows as floats, [joints * layout::words_per_joint].
void pack_palette(std::span<const Mat34> palette, std::span<Vec4f> words);

/// What a frame's face is for all vertices alike, but for the signals. [layout::words_per_face]
void pack_face(const CharacterFace& face, const FaceState& state, std::span<Vec4f> words);

/// A muscle at an activation.
layout::MuscleWord pack_muscle(const PlacedMuscle& placed, double activation);

}  // namespace sinew
