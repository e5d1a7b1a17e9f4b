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
  // The floor throws no shadow, so that nothing has to be lifted from it; and a faint shadow needs no softer edge than
  // one look at four texels gives: this runs for a third of the picture.
  const vec2 at = 0.5 + 0.5 * (frame.contact_projection * vec4(world_position, 1.0)).xy;
  const float closed = contact_strength * textureLod(contact_shade, at, 0.0).x;
  const float lit = textureLod(shadow_map, place_in_shadow_map(world_position), 0.0);
  const float shaded = frame.shadow.z * cast_strength * (1.0 - lit);
  const float away = distance(world_position, frame.floor_centre.xyz) / frame.floor_centre.w;
  const float fade = 1.0 - smoothstep(0.6, 1.0, away);
  colour = vec4(vec3(0), fade * (1.0 - (1.0 - closed) * (1.0 - shaded)));
}
