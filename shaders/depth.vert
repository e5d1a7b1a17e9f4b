#version 460
// A character's depth as the key light sees it, or as it looks from below the floor.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(set = 0, binding = binding_frame) uniform Frame { FrameUniforms frame; };
layout(constant_id = constant_from_light) const bool from_light = true;
layout(location = 0) in vec4 position_and_height;

void main() {
  gl_Position = (from_light ? frame.light_projection : frame.contact_projection) * vec4(position_and_height.xyz, 1.0);
}
