#version 460
// The floor: a rectangle that shows nothing but the shadows on it.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(set = 0, binding = binding_frame) uniform Frame { FrameUniforms frame; };
layout(location = 0) out vec3 world_position;

void main() {
  const vec2 corner = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) * 2.0 - 1.0;
  world_position = frame.floor_centre.xyz + vec3(corner.x * frame.floor_size.x, 0.0, corner.y * frame.floor_size.y);
  gl_Position = frame.view_projection * vec4(world_position, 1.0);
}
