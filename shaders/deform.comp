#version 460
// The deformation of a character, one invocation a vertex: morph targets, face, skin, projection-plane Gaussian muscle
// bulge. Twin of engine/deform; the formulas are engine/definitions.md 2, 3, 6 and 15.
//
// Two builds of one source: SINEW_TEXEL_BUFFERS reads through texel buffers (what a CPU driver vectorises), otherwise
// through storage buffers (no size limit worth speaking of). They give the same bits.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(local_size_x = workgroup_size) in;

layout(constant_id = constant_deformer) const uint deformer = deformer_ssd;
layout(constant_id = constant_bulge) const uint bulge = bulge_on;
layout(constant_id = constant_has_morphs) const bool has_morphs = true;
layout(constant_id = constant_has_extra_influences) const bool has_extra_influences = true;
layout(constant_id = constant_has_tangents) const bool has_tangents = true;
layout(constant_id = constant_has_face) const bool has_face = true;

layout(push_constant) uniform Push { DeformPush push; };

#ifdef SINEW_TEXEL_BUFFERS
layout(binding = binding_vertices) uniform utextureBuffer vertex_words;
layout(binding = binding_details) uniform utextureBuffer detail_words;
layout(binding = binding_palette) uniform textureBuffer palette_words;
layout(binding = binding_morph_weights) uniform textureBuffer morph_weights;
layout(binding = binding_muscles) uniform textureBuffer muscle_words;
layout(binding = binding_tangents) uniform textureBuffer tangent_words;
layout(binding = binding_face) uniform textureBuffer face_words;
uvec4 vertex_word(uint i) { return texelFetch(vertex_words, int(i)); }
uvec4 detail_word(uint i) { return texelFetch(detail_words, int(i)); }
vec4 palette_word(uint i) { return texelFetch(palette_words, int(i)); }
float morph_weight(uint i) { return texelFetch(morph_weights, int(i)).x; }
vec4 muscle_word(uint i) { return texelFetch(muscle_words, int(i)); }
vec4 tangent_word(uint i) { return texelFetch(tangent_words, int(i)); }
vec4 face_word(uint i) { return texelFetch(face_words, int(i)); }
#else
layout(binding = binding_vertices, std430) readonly buffer Vertices { uvec4 vertex_words[]; };
layout(binding = binding_details, std430) readonly buffer Details { uvec4 detail_words[]; };
layout(binding = binding_palette, std430) readonly buffer Palette { vec4 palette_words[]; };
layout(binding = binding_morph_weights, std430) readonly buffer MorphWeights { float morph_weights[]; };
layout(binding = binding_muscles, std430) readonly buffer Muscles { vec4 muscle_words[]; };
layout(binding = binding_tangents, std430) readonly buffer Tangents { vec4 tangent_words[]; };
layout(binding = binding_face, std430) readonly buffer Face { vec4 face_words[]; };
uvec4 vertex_word(uint i) { return vertex_words[i]; }
uvec4 detail_word(uint i) { return detail_words[i]; }
vec4 palette_word(uint i) { return palette_words[i]; }
float morph_weight(uint i) { return morph_weights[i]; }
vec4 muscle_word(uint i) { return muscle_words[i]; }
vec4 tangent_word(uint i) { return tangent_words[i]; }
vec4 face_word(uint i) { return face_words[i]; }
#endif
layout(binding = binding_output, std430) writeonly buffer Output { vec4 output_words[]; };
layout(binding = binding_output_tangents, std430) writeonly buffer OutputTangents { vec4 output_tangents[]; };

// The rows of a 3x4 matrix.
struct Rows {
  vec4 x, y, z;
};

void add_joint(inout Rows rows, uint joint, float weight) {
  const uint first = joint * words_per_joint;
  rows.x += weight * palette_word(first);
  rows.y += weight * palette_word(first + 1);
  rows.z += weight * palette_word(first + 2);
}

// Adds one region's height, and its change over the bind surface as a covector. The zero words that every character's
// details begin with add nothing.
void add_region(uint first, inout float height, inout vec3 gradient) {
  const vec4 place = uintBitsToFloat(detail_word(first));
  const uvec4 along_word = detail_word(first + 1);
  const vec3 along_axis = uintBitsToFloat(along_word.xyz);
  const vec3 across_axis = uintBitsToFloat(detail_word(first + 2).xyz);
  const vec4 muscle = muscle_word(along_word.w);
  const float x = place.x, y = place.y;
  const float g = muscle.z * exp(-0.5 * (x * x * muscle.x + y * y * muscle.y));
  const float fade = bulge == bulge_paper ? (first == 0 ? 0.0 : 1.0) : place.z;
  const float fade_slope = bulge == bulge_paper ? 0.0 : place.w;
  height += g * fade;
  gradient += g * ((fade_slope - x * muscle.x * fade) * along_axis - y * muscle.y * fade * across_axis);
}

// Sine, and 1 less the cosine, of an angle up to 1.6: Taylor's, to 3e-7. What devices promise of theirs is coarser.
vec2 small_turn(float angle) {
  const float q = angle * angle;
  const float sine =
      1.0 - q / 6.0 * (1.0 - q / 20.0 * (1.0 - q / 42.0 * (1.0 - q / 72.0 * (1.0 - q / 110.0))));
  const float versine =
      0.5 * q * (1.0 - q / 12.0 * (1.0 - q / 30.0 * (1.0 - q / 56.0 * (1.0 - q / 90.0 * (1.0 - q / 132.0)))));
  return vec2(angle * sine, versine);
}

// What turning adds to a vector: exactly nothing where it does not turn.
vec3 turn_adds(vec3 axis, vec3 v, vec2 turn) {
  return turn.x * cross(axis, v) - turn.y * (v - dot(axis, v) * axis);
}

// The turns of a face's vertex that a direction takes part in.
struct FaceTurn {
  vec3 axis;
  vec2 jaw, lid;
  vec3 gaze_x, gaze_y, gaze_z;
};

vec3 turn_direction(FaceTurn face, vec3 v) {
  v += vec3(dot(face.gaze_x, v), dot(face.gaze_y, v), dot(face.gaze_z, v));
  v += turn_adds(face.axis, v, face.jaw);
  return v + turn_adds(face.axis, v, face.lid);
}

// Moves a vertex of the bind pose as the face's regions say; `detail` stands at its face entry and is left behind its
// last delta. Branches would not be taken one by one by a CPU driver: vertices beside the face are moved by zeros.
FaceTurn move_face(inout uint detail, inout vec3 position, inout vec3 normal) {
  const vec4 shares = uintBitsToFloat(detail_word(detail));
  const uvec4 part = detail_word(detail + 1);
  detail += words_per_face_entry;
  const vec4 hinge = face_word(0), axis = face_word(1), forward = face_word(2);
  FaceTurn face;
  face.axis = axis.xyz;
  const float jaw = mix(shares.x, shares.y, axis.w);
  face.jaw = small_turn(jaw * hinge.w);
  position += turn_adds(face.axis, position - hinge.xyz, face.jaw) + jaw * forward.xyz;
  for (uint i = 0; i < part.z; ++i, detail += words_per_face_delta) {
    const uvec4 delta = detail_word(detail);
    const float amount = morph_weight(delta.w);
    position += amount * uintBitsToFloat(delta.xyz);
    normal += amount * uintBitsToFloat(detail_word(detail + 1).xyz);
  }
  const uint turn = words_of_jaw + part.y * words_per_face_turn;
  const vec4 centre = face_word(turn), row_x = face_word(turn + 1);
  face.gaze_x = row_x.xyz;
  face.gaze_y = face_word(turn + 2).xyz;
  face.gaze_z = face_word(turn + 3).xyz;
  face.lid = small_turn(shares.z * centre.w - shares.w * row_x.w);
  vec3 from_centre = position - centre.xyz;
  vec3 added = vec3(dot(face.gaze_x, from_centre), dot(face.gaze_y, from_centre), dot(face.gaze_z, from_centre));
  added += turn_adds(face.axis, from_centre, face.lid);
  from_centre += added;
  const float least = uintBitsToFloat(part.x);
  const float pushed = max(least * inversesqrt(max(dot(from_centre, from_centre), 1e-30)), 1.0) - 1.0;
  position += added + pushed * from_centre;
  return face;
}

void main() {
  if (gl_GlobalInvocationID.x >= push.vertex_count) return;
  const uint vertex = gl_GlobalInvocationID.x;
  const uint record = vertex * words_per_vertex;
  const uvec4 word0 = vertex_word(record), word1 = vertex_word(record + 1), word2 = vertex_word(record + 2);
  precise vec3 position = uintBitsToFloat(word0.xyz);
  precise vec3 normal = uintBitsToFloat(word1.xyz);

  uvec4 header = uvec4(0);
  uint detail = word0.w & link_mask;
  if (has_morphs || has_extra_influences) header = detail_word(detail++);

  if (has_morphs) {
    for (uint i = 0; i < header.x; ++i, detail += words_per_morph_delta) {
      const uvec4 delta = detail_word(detail);
      const float weight = morph_weight(delta.w);
      position += weight * uintBitsToFloat(delta.xyz);
      normal += weight * uintBitsToFloat(detail_word(detail + 1).xyz);
    }
  }

  FaceTurn face;
  if (has_face) {
    face = move_face(detail, position, normal);
    normal = turn_direction(face, normal);
  }

  precise Rows blend = Rows(vec4(0), vec4(0), vec4(0));
  if (deformer == deformer_rigid) {
    add_joint(blend, word2.x & 0xffffu, 1.0);
    if (has_extra_influences) detail += header.y * words_per_extra;
  } else {
    const float w1 = uintBitsToFloat(word1.w), w2 = uintBitsToFloat(word2.z), w3 = uintBitsToFloat(word2.w);
    precise float w0 = ((1.0 - w1) - w2) - w3;
    if (has_extra_influences) {
      for (uint i = 0; i < header.y; ++i, detail += words_per_extra) {
        const uvec4 joints = detail_word(detail);
        const vec4 weights = uintBitsToFloat(detail_word(detail + 1));
        add_joint(blend, joints.x & 0xffffu, weights.x);
        add_joint(blend, joints.x >> 16, weights.y);
        add_joint(blend, joints.y & 0xffffu, weights.z);
        add_joint(blend, joints.y >> 16, weights.w);
        w0 = (((w0 - weights.x) - weights.y) - weights.z) - weights.w;
      }
    }
    add_joint(blend, word2.x & 0xffffu, w0);
    add_joint(blend, word2.x >> 16, w1);
    add_joint(blend, word2.y & 0xffffu, w2);
    add_joint(blend, word2.y >> 16, w3);
  }

  const vec4 homogeneous = vec4(position, 1.0);
  precise vec3 posed = vec3(dot(blend.x, homogeneous), dot(blend.y, homogeneous), dot(blend.z, homogeneous));

  // A^-T is the cofactor matrix over the determinant; only the determinant's sign matters to a direction.
  const vec3 cofactor_x = cross(blend.y.xyz, blend.z.xyz);
  const vec3 cofactor_y = cross(blend.z.xyz, blend.x.xyz);
  const vec3 cofactor_z = cross(blend.x.xyz, blend.y.xyz);
  const float determinant = dot(blend.x.xyz, cofactor_x);
  vec3 carried = vec3(dot(cofactor_x, normal), dot(cofactor_y, normal), dot(cofactor_z, normal));
  carried = determinant < 0.0 ? -carried : carried;
  const float squared = dot(carried, carried);
  vec3 outward = squared > 0.0 ? carried * inversesqrt(squared) : normal;

  float height = 0.0;
  vec4 tangent = vec4(0);
  vec3 carried_tangent = vec3(0);
  if (has_tangents) {
    tangent = tangent_word(vertex);
    if (has_face) tangent.xyz = turn_direction(face, tangent.xyz);
    carried_tangent = vec3(dot(blend.x.xyz, tangent.xyz), dot(blend.y.xyz, tangent.xyz), dot(blend.z.xyz, tangent.xyz));
  }
  if (bulge != bulge_off) {
    vec3 gradient = vec3(0);
    // llvmpipe runs a loop's body once before it looks whether any lane wants it: so the first region, real or the zero
    // words, is added whatever the number.
    const uint regions = word0.w >> link_shift;
    if (regions == 0) detail = 0;
    uint i = 0;
    do {
      add_region(detail, height, gradient);
      detail += words_per_region;
    } while (++i < regions);
    posed += height * outward;
    if (has_tangents) carried_tangent += dot(gradient, tangent.xyz) * outward;
    if (gradient != vec3(0) && determinant != 0.0) {
      // The swollen surface's normal is n' minus the tangential part of A^-T grad h: Sherman and Morrison's formula for
      // the cofactors of A + n' grad h^T.
      vec3 tilt = vec3(dot(cofactor_x, gradient), dot(cofactor_y, gradient), dot(cofactor_z, gradient));
      tilt *= 1.0 / determinant;
      tilt -= dot(tilt, outward) * outward;
      const vec3 swollen = outward - tilt;
      outward = swollen * inversesqrt(dot(swollen, swollen));
    }
  }

  output_words[vertex * words_per_output] = vec4(posed, height);
  output_words[vertex * words_per_output + 1] = vec4(outward, 0.0);
  if (has_tangents) {
    carried_tangent -= dot(carried_tangent, outward) * outward;
    const float length_squared = dot(carried_tangent, carried_tangent);
    output_tangents[vertex] = vec4(length_squared > 0.0 ? carried_tangent * inversesqrt(length_squared) : vec3(0),
                                   determinant < 0.0 ? -tangent.w : tangent.w);
  }
}
