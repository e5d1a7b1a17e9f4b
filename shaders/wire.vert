#version 460
// An edge of the mesh as a ribbon of even width on the picture: six vertices an edge.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(set = 0, binding = binding_frame) uniform Frame { FrameUniforms frame; };
layout(set = 1, binding = binding_wire_vertices, std430) readonly buffer Vertices { vec4 vertex_words[]; };
layout(set = 1, binding = binding_wire_edges, std430) readonly buffer Edges { uvec2 edges[]; };

layout(location = 0) noperspective out float across;  // pixels from the middle of the line

// Towards the eye, so that an edge is not hidden by its own triangles.
const float lift = 0.002;

vec4 clip_of(uint vertex) {
  const vec3 at = vertex_words[vertex * words_per_output].xyz;
  const float distance_share = frame.eye.w > 0.0 ? 1.0 : frame.back.w - dot(at, frame.back.xyz);
  const vec3 position = at + lift * distance_share * (frame.eye.xyz - frame.eye.w * at);
  return frame.view_projection * vec4(position, 1.0);
}

void main() {
  const uvec2 edge = edges[gl_VertexIndex / 6];
  const int corner = int[](0, 1, 2, 2, 1, 3)[gl_VertexIndex % 6];
  const vec4 from = clip_of(edge.x), to = clip_of(edge.y);
  const vec2 half_size = 0.5 * frame.picture.xy;
  // An edge that leaves through the near plane is left out: its direction on the picture is not defined.
  const bool seen = from.w > 0.0 && to.w > 0.0 && from.z > 0.0 && to.z > 0.0;
  const vec2 direction = half_size * (to.xy / to.w - from.xy / from.w);
  const float pixels = length(direction);
  const vec2 along = pixels > 1e-4 ? direction / pixels : vec2(1, 0);
  const float reach = 0.5 * frame.picture.z + 0.75;
  const float side = (corner & 1) == 0 ? -reach : reach;
  vec4 clip = corner < 2 ? from : to;
  clip.xy += side * vec2(-along.y, along.x) / half_size * clip.w;
  across = side;
  gl_Position = seen ? clip : vec4(0, 0, -1, 1);
}
