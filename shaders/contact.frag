#version 460
// How much of what is near above a point of the floor is closed off: the mean over a disc, nearer things counting more.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(set = 0, binding = binding_frame) uniform Frame { FrameUniforms frame; };
layout(set = 0, binding = binding_contact_map) uniform sampler2D contact_map;

layout(location = 0) in vec2 place;
layout(location = 0) out float shade;

const int taps = 96;
// Cosine and sine of the golden angle: each tap's direction is the one before, turned by it.
const vec2 turn = vec2(-0.737368878, 0.675490294);

void main() {
  float sum = 0.0, weights = 0.0;
  vec2 direction = vec2(1.0, 0.0);
  for (int i = 0; i < taps; ++i) {
    const float r = sqrt((float(i) + 0.5) / float(taps));
    const float weight = 1.0 - 0.7 * r;
    const float near = 1.0 - textureLod(contact_map, place + r * frame.shadow.y * direction, 0.0).x;
    sum += weight * near * near;
    weights += weight;
    direction = vec2(turn.x * direction.x - turn.y * direction.y, turn.y * direction.x + turn.x * direction.y);
  }
  shade = sum / weights;
}
