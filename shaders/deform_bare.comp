#version 460
// For benchmarks only: a bare 4-influence SSD kernel that reads and writes what deform.comp does, without morph targets,
// bulge or inverse transpose. The cost of everything else is measured against it.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(local_size_x = workgroup_size) in;
layout(push_constant) uniform Push { DeformPush push; };
#ifdef SINEW_TEXEL_BUFFERS
layout(binding = binding_vertices) uniform utextureBuffer vertex_words;
layout(binding = binding_palette) uniform textureBuffer palette_words;
uvec4 vertex_word(uint i) { return texelFetch(vertex_words, int(i)); }
vec4 palette_word(uint i) { return texelFetch(palette_words, int(i)); }
#else
layout(binding = binding_vertices, std430) readonly buffer Vertices { uvec4 vertex_words[]; };
layout(binding = binding_palette, std430) readonly buffer Palette { vec4 palette_words[]; };
uvec4 vertex_word(uint i) { return vertex_words[i]; }
vec4 palette_word(uint i) { return palette_words[i]; }
#endif
layout(binding = binding_output, std430) writeonly buffer Output { vec4 output_words[]; };

void main() {
  if (gl_GlobalInvocationID.x >= push.vertex_count) return;
  const uint vertex = gl_GlobalInvocationID.x;
  const uint record = vertex * words_per_vertex;
  const uvec4 word0 = vertex_word(record), word1 = vertex_word(record + 1), word2 = vertex_word(record + 2);
  const vec4 position = vec4(uintBitsToFloat(word0.xyz), 1.0);
  const vec3 normal = uintBitsToFloat(word1.xyz);
  const float w1 = uintBitsToFloat(word1.w), w2 = uintBitsToFloat(word2.z), w3 = uintBitsToFloat(word2.w);
  const float weights[4] = float[](((1.0 - w1) - w2) - w3, w1, w2, w3);
  const uint joints[4] = uint[](word2.x & 0xffffu, word2.x >> 16, word2.y & 0xffffu, word2.y >> 16);
  vec4 x = vec4(0), y = vec4(0), z = vec4(0);
  for (int i = 0; i < 4; ++i) {
    const uint first = joints[i] * words_per_joint;
    x += weights[i] * palette_word(first);
    y += weights[i] * palette_word(first + 1);
    z += weights[i] * palette_word(first + 2);
  }
  const vec3 turned = vec3(dot(x.xyz, normal), dot(y.xyz, normal), dot(z.xyz, normal));
  output_words[vertex * words_per_output] = vec4(dot(x, position), dot(y, position), dot(z, position), 0.0);
  output_words[vertex * words_per_output + 1] = vec4(turned * inversesqrt(dot(turned, turned)), 0.0);
}
