#version 460
// A deformed character's surface: vertices come skinned and swollen, in world space. SINEW_RICH: with all that a
// material may ask for. SINEW_FROM_LIGHT: as the key light sees it, or from below the floor (twin of depth.vert).
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(set = 0, binding = binding_frame) uniform Frame { FrameUniforms frame; };

layout(location = 0) in vec4 position_and_height;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec2 texture_coordinate;
#ifdef SINEW_RICH
layout(location = 3) in vec4 tangent;
layout(location = 4) in vec2 second_texture_coordinate;
layout(location = 5) in vec4 colour;
#endif

layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;
layout(location = 2) out vec2 surface_coordinate;
layout(location = 3) out float bulge_height;
#ifdef SINEW_RICH
layout(location = 4) out vec4 world_tangent;
layout(location = 5) out vec2 second_coordinate;
layout(location = 6) out vec4 vertex_colour;
#endif

#ifdef SINEW_FROM_LIGHT
layout(constant_id = constant_from_light) const bool from_light = true;
#endif

// Layers are found again by their exact depth.
invariant gl_Position;

void main() {
  world_position = position_and_height.xyz;
  world_normal = normal.xyz;
  surface_coordinate = texture_coordinate;
  bulge_height = position_and_height.w;
#ifdef SINEW_RICH
  world_tangent = tangent;
  second_coordinate = second_texture_coordinate;
  vertex_colour = colour;
#endif
#ifdef SINEW_FROM_LIGHT
  gl_Position = (from_light ? frame.light_projection : frame.contact_projection) * vec4(world_position, 1.0);
#else
  gl_Position = frame.view_projection * vec4(world_position, 1.0);
#endif
}
