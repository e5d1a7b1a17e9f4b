#version 460
// Shadows on the floor: the key light's, and the soft dark where something stands on it or hovers close above.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(set = 0, binding = binding_frame) uniform Frame { FrameUniforms frame; };
#include "shadow_map.glsl"
layout(set = 0, binding = binding_contact_map) uniform sampler2D contact_shade;

layout(location = 0) in vec3 world_position;
layout(location = 0) out vec4 colour;

const float contact_strength = 0.62;
const float cast_strength = 0.20;

void main() {
  const vec2 at = 0.5 + 0.5 * (frame.contact_projection * vec4(world_position, 1.0)).xy;
  const float closed = contact_strength * textureLod(contact_shade, at, 0.0).x;
  const float shaded = frame.shadow.z * cast_strength * (1.0 - key_light_at(world_position, vec3(0, 1, 0)));
  const float away = distance(world_position, frame.floor_centre.xyz) / frame.floor_centre.w;
  const float fade = 1.0 - smoothstep(0.6, 1.0, away);
  colour = vec4(vec3(0), fade * (1.0 - (1.0 - closed) * (1.0 - shaded)));
}
