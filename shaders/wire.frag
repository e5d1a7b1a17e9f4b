#version 460
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(set = 0, binding = binding_frame) uniform Frame { FrameUniforms frame; };
layout(push_constant) uniform Push { vec4 ink; };  // sRGB and alpha

layout(location = 0) noperspective in float across;
layout(location = 0) out vec4 colour;

void main() { colour = vec4(ink.rgb, ink.a * clamp(0.5 * frame.picture.z + 0.5 - abs(across), 0.0, 1.0)); }
