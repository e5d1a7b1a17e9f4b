#pragma once
/// The parts of a written glTF file, one function each: what a Model holds to what the JSON says. For gltf_write.cpp
/// and vrm_write.cpp.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/io/glb_builder.h"
#include "engine/io/rig_layout.h"
#include "engine/model/model.h"

namespace sinew {

/// The vectors' numbers as floats, one vector after another.
std::vector<float> floats(std::span<const Vec2> vectors);
std::vector<float> floats(std::span<const Vec3> vectors);
std::vector<float> floats(std::span<const Vec4> vectors);

/// Sets the key unless the array is empty, which glTF does not allow.
void set_unless_empty(Json& object, const char* key, Json array);

/// Adds key times as floats and gives their accessor. Times that glTF does not allow make the builder fail.
int add_times(const std::string& place, std::span<const double> seconds, GlbBuilder& glb);

Json written_meshes(const Model& model, const RigLayout& layout, GlbBuilder& glb);
Json written_clips(const Model& model, const RigLayout& layout, GlbBuilder& glb);
/// Sets all that a rig has: rig_glb without its container.
void write_rig(const Model& model, GlbBuilder& glb);
/// Sets `materials` and, where they have pictures, `textures`, `samplers` and `images`.
void write_materials(const Model& model, GlbBuilder& glb);

}  // namespace sinew
