// What the program and the shaders share, in one place: this file is read by the C++ compiler and by glslang.
//
// Vertex record, 3 words of 16 bytes a vertex (48 bytes):
//   word 0: position x, y, z (float), link (uint): number of muscle regions << link_shift | index of the details
//   word 1: normal x, y, z (float), weight of influence 1 (float)
//   word 2: joints 0 and 1, joints 2 and 3 (16 bits each, the lower first), weights of influences 2 and 3 (float)
// The largest weight is not stored: it is 1 minus the others, so that the sum is exact whatever the rounding.
//
// Details, words of 16 bytes: what only some vertices have. The first zero_words words are zero and serve all vertices
// that have none. In a character with morph targets or with more than 4 influences the details of a vertex
// begin with a header
//   {number of morph deltas, 1 where there are influences 4 to 7 else 0, 0, 0}
//   a morph delta:  {position x, y, z, morph slot (uint)} {normal x, y, z, 0}
// in a character with a face follow (engine/definitions.md 15)
//   a face entry:   {share of the jaw, the same with sealed lips, angle at upper lid 1, at lower lid 1}
//                   {least distance from the eye, which turn, number of face deltas (uint), 0}
//   a face delta:   as a morph delta; signals stand behind the morph slots
// and then
//   influences 4-7: {joints 4 and 5, joints 6 and 7, 0, 0} {their weights}
// and in every character with muscles they end with its regions
//   a region entry: {x, y, f, df/dt / length} {A0^T a, muscle index (uint)} {A0^T s, 0}   (engine/definitions.md 6)
//
// Palette: 3 words a joint, the rows of its 3x4 matrix. Muscles: 1 word each (MuscleWord). Output: 2 words a vertex,
// {position, bulge height} {normal, 0}.
// Face of one frame, bind pose: {jaw's hinge, its angle} {axis of all turns, seal} {what the jaw goes forward, 0}, then
// four words a turn: {centre, upper lid} {what gaze adds to the vertex from there, a row of 3x3, lower lid} {row, 0} {row, 0}.
// Turn 0 is none, 1 and 2 are the lids of the left and the right eye, 3 and 4 the balls.
// Tangents, in a character with a normal texture: 1 word a vertex, in and out {tangent, side of the bitangent}.
#ifndef SINEW_SHADERS_LAYOUT_H
#define SINEW_SHADERS_LAYOUT_H

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#define SINEW_CONSTANT constexpr std::uint32_t
namespace sinew::layout {
using uint = std::uint32_t;
using vec4 = glm::fvec4;
using mat4 = glm::fmat4;
#else
#define SINEW_CONSTANT const uint
#endif

SINEW_CONSTANT workgroup_size = 256;
SINEW_CONSTANT words_per_vertex = 3;
SINEW_CONSTANT words_per_joint = 3;
SINEW_CONSTANT words_per_output = 2;
SINEW_CONSTANT words_per_morph_delta = 2;
SINEW_CONSTANT words_per_extra = 2;
SINEW_CONSTANT words_per_region = 3;
SINEW_CONSTANT words_per_face_entry = 2;
SINEW_CONSTANT words_per_face_delta = 2;
SINEW_CONSTANT words_of_jaw = 3;
SINEW_CONSTANT words_per_face_turn = 4;
SINEW_CONSTANT face_turns = 5;
SINEW_CONSTANT words_per_face = words_of_jaw + face_turns * words_per_face_turn;
SINEW_CONSTANT zero_words = 8;
SINEW_CONSTANT link_shift = 28;
SINEW_CONSTANT link_mask = 0x0fffffffu;

// Bindings of the deform pass, set 0.
SINEW_CONSTANT binding_vertices = 0;
SINEW_CONSTANT binding_details = 1;
SINEW_CONSTANT binding_palette = 2;
SINEW_CONSTANT binding_morph_weights = 3;
SINEW_CONSTANT binding_muscles = 4;
SINEW_CONSTANT binding_output = 5;
SINEW_CONSTANT binding_tangents = 6;
SINEW_CONSTANT binding_output_tangents = 7;
SINEW_CONSTANT binding_face = 8;
SINEW_CONSTANT deform_bindings = 9;

// Specialisation constants of the deform pass.
SINEW_CONSTANT constant_deformer = 0;
SINEW_CONSTANT constant_bulge = 1;
SINEW_CONSTANT constant_has_morphs = 2;
SINEW_CONSTANT constant_has_extra_influences = 3;
SINEW_CONSTANT constant_has_tangents = 4;
SINEW_CONSTANT constant_has_face = 5;

SINEW_CONSTANT deformer_rigid = 0;
SINEW_CONSTANT deformer_ssd = 1;
SINEW_CONSTANT bulge_off = 0;
SINEW_CONSTANT bulge_on = 1;
SINEW_CONSTANT bulge_paper = 2;

// Bindings of the draw passes: set 0 a frame, set 1 a material, set 2 the depths that transparent layers are peeled from.
SINEW_CONSTANT binding_frame = 0;
SINEW_CONSTANT binding_shadow_map = 1;   // depth from the key light
SINEW_CONSTANT binding_contact_map = 2;  // depth from below the floor; to the floor's shader the shade made of it
SINEW_CONSTANT binding_material = 0;
SINEW_CONSTANT binding_base_colour = 1;
SINEW_CONSTANT binding_metallic_roughness = 2;
SINEW_CONSTANT binding_normal = 3;
SINEW_CONSTANT binding_occlusion = 4;
SINEW_CONSTANT binding_emissive = 5;
SINEW_CONSTANT texture_count = 5;
SINEW_CONSTANT binding_opaque_depth = 0;
SINEW_CONSTANT binding_layer_depth = 1;

// Bindings of the wire pass, set 1.
SINEW_CONSTANT binding_wire_vertices = 0;
SINEW_CONSTANT binding_wire_edges = 1;

// Specialisation constants of the surface shaders: what a material lacks is compiled out.
SINEW_CONSTANT constant_shading = 0;
SINEW_CONSTANT constant_maps = 1;
SINEW_CONSTANT constant_alpha = 2;
SINEW_CONSTANT constant_unlit = 3;
SINEW_CONSTANT constant_shadows = 4;
SINEW_CONSTANT constant_from_light = 5;

// How a surface is shown.
SINEW_CONSTANT shading_lit = 0;
SINEW_CONSTANT shading_flat = 1;
SINEW_CONSTANT shading_clay = 2;
SINEW_CONSTANT shading_normals = 3;
SINEW_CONSTANT shading_weights = 4;
SINEW_CONSTANT shading_bulge = 5;
SINEW_CONSTANT shading_depth = 6;

// Bits of constant_maps: the textures that are there, and whether any is turned or scaled; then vertex colours.
SINEW_CONSTANT map_base_colour = 1;
SINEW_CONSTANT map_metallic_roughness = 2;
SINEW_CONSTANT map_normal = 4;
SINEW_CONSTANT map_occlusion = 8;
SINEW_CONSTANT map_emissive = 16;
SINEW_CONSTANT map_transform = 32;
SINEW_CONSTANT map_colours = 64;

SINEW_CONSTANT alpha_opaque = 0;
SINEW_CONSTANT alpha_mask = 1;
SINEW_CONSTANT alpha_blend = 2;

struct DeformPush {
  uint vertex_count;  // of this dispatch; its vertices and its output start at the bound ranges' beginning
};

// One muscle of one pose: one word.
struct MuscleWord {
  vec4 gauss;  // 1 / sigma_along^2, 1 / sigma_across^2, delta * peak, unused
};

struct FrameUniforms {
  mat4 view_projection;
  mat4 light_projection;    // world to the shadow map's clip space
  mat4 contact_projection;  // world to the contact map's clip space
  vec4 eye;                 // world position of the camera, 1; of parallel rays their direction towards it, 0
  vec4 back;                // the camera's axis, away from what it sees; the camera's place along it
  vec4 key;          // directions towards the lights in the world, unit length; unused
  vec4 fill;
  vec4 rim;
  vec4 depth_range;  // nearest, farthest distance of the scene, which the depth shading spreads over; largest bulge height; unused
  vec4 floor_centre;  // x, y, z; distance at which shadows have faded
  vec4 floor_size;    // half its length along x, along z; unused
  vec4 shadow;       // world length of a texel of the shadow map; reach of the contact shadow as a share of its map; 1 where the key light throws shadows
  vec4 picture;      // width and height, pixels; width of a wire, pixels; unused
};

// A texture's place: uv' = (dot(u.xy, uv) + u.z, dot(v.xy, uv) + v.z); u.w: 1 where it takes the second coordinates.
struct TexturePlace {
  vec4 u;
  vec4 v;
};

struct MaterialUniforms {
  vec4 base_colour;  // linear RGBA
  vec4 surface;      // metallic, roughness, normal scale, occlusion strength
  vec4 emissive;     // linear RGB, alpha cutoff
  vec4 specular;     // RGB reflectance at normal incidence of what is not metal, unused
  TexturePlace places[texture_count];
};

#ifdef __cplusplus
static_assert(sizeof(DeformPush) == 4);
static_assert(sizeof(MuscleWord) == 16);
static_assert(sizeof(FrameUniforms) == 352 && offsetof(FrameUniforms, eye) == 192 &&
              offsetof(FrameUniforms, picture) == 336);
static_assert(sizeof(MaterialUniforms) == 224 && offsetof(MaterialUniforms, places) == 64);
}  // namespace sinew::layout
#endif

#undef SINEW_CONSTANT
#endif
