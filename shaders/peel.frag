#version 460
// Finds the depth of a layer: of what is transparent, before the opaque surface and behind the last layer, the nearest
// remains by the depth test.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"
#include "material.glsl"
#include "layers.glsl"

void main() {
  const bool shows = base_colour().a > 0.0;
  if (!shows || !behind_layer() || !before_opaque()) discard;
}
