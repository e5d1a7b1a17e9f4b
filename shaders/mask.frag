#version 460
// The depth of a surface with holes: what its mask cuts away casts no shadow.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"
#include "material.glsl"

void main() { cut(base_colour().a); }
