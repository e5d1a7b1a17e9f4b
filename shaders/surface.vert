#version 460
// A deformed character's surface: vertices come skinned and swollen, in world space.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(set = 0, binding = binding_frame) uniform Frame { FrameUniforms frame; };

layout(location = 0) in vec4 position_and_height;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec2 texture_coordinate;

layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;
layout(location = 2) out vec2 surface_coordinate;
layout(location = 3) out float bulge_height;

void main() {
  world_position = position_and_height.xyz;
  world_normal = normal.xyz;
  surface_coordinate = texture_coordinate;
  bulge_height = position_and_height.w;
  gl_Position = frame.view_projection * vec4(world_position, 1.0);
}
