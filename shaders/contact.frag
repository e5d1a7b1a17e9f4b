#version 460
// How much of what is near above a point of the floor is closed off: the mean over a disc, nearer things counting more.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(set = 0, binding = binding_frame) uniform Frame { FrameUniforms frame; };
layout(set = 0, binding = binding_contact_map) uniform sampler2D contact_map;

layout(location = 0) in vec2 place;
layout(location = 0) out float shade;

const int taps = 96;
const float golden_angle = 2.39996323;

void main() {
  float sum = 0.0, weights = 0.0;
  for (int i = 0; i < taps; ++i) {
    const float r = sqrt((float(i) + 0.5) / float(taps)), a = float(i) * golden_angle;
    const float weight = 1.0 - 0.7 * r;
    const float near = 1.0 - textureLod(contact_map, place + r * frame.shadow.y * vec2(cos(a), sin(a)), 0.0).x;
    sum += weight * near * near;
    weights += weight;
  }
  shade = sum / weights;
}
