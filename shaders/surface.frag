#version 460
// How a surface looks: a soft three-light studio that stands relative to the camera, or one of the plain modes.
// Light is linear; the last step turns it into sRGB.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(set = 0, binding = binding_frame) uniform Frame { FrameUniforms frame; };
layout(set = 1, binding = binding_material) uniform Material { MaterialUniforms material; };
layout(set = 1, binding = binding_base_colour) uniform sampler2D base_colour;

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec2 surface_coordinate;
layout(location = 3) in float bulge_height;

layout(location = 0) out vec4 colour;

vec3 linear_from_srgb(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045))); }

vec3 srgb_from_linear(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

// A light from a direction given in the camera's axes (right, up, towards the camera).
struct Light {
  vec3 direction;
  vec3 colour;
  float wrap;  // how far light reaches round the form: the softness of a large source
};

const Light key = Light(vec3(-0.52, 0.62, 0.59), vec3(1.00, 0.97, 0.93) * 1.02, 0.14);
const Light fill = Light(vec3(0.86, 0.05, 0.50), vec3(0.86, 0.93, 1.00) * 0.20, 0.40);
const Light rim = Light(vec3(0.55, 0.45, -0.70), vec3(0.95, 0.98, 1.00) * 0.60, 0.05);
const vec3 sky = vec3(0.120, 0.130, 0.145);
const vec3 ground = vec3(0.060, 0.052, 0.046);
const float gloss = 34.0;
const float reflectance = 0.10;

vec3 to_world(vec3 v) { return v.x * frame.right.xyz + v.y * frame.up.xyz + v.z * frame.back.xyz; }

vec3 light_from(Light light, vec3 n, vec3 to_eye, vec3 albedo) {
  const vec3 l = to_world(normalize(light.direction));
  const float diffuse = max((dot(n, l) + light.wrap) / (1.0 + light.wrap), 0.0);
  const vec3 h = normalize(l + to_eye);
  const float specular = dot(n, l) > 0.0 ? pow(max(dot(n, h), 0.0), gloss) * reflectance : 0.0;
  return light.colour * (albedo * diffuse * diffuse * (1.5 - 0.5 * diffuse) + specular);
}

vec3 lit(vec3 albedo, vec3 n) {
  const vec3 to_eye = normalize(frame.eye.xyz - world_position);
  vec3 light = albedo * mix(ground, sky, 0.5 + 0.5 * n.y);
  light += light_from(key, n, to_eye, albedo);
  light += light_from(fill, n, to_eye, albedo);
  light += light_from(rim, n, to_eye, albedo);
  return light;
}

// Blue over white to red, for heights between 0 and 1.
vec3 heat(float x) { return mix(mix(vec3(0.23, 0.30, 0.55), vec3(0.90), clamp(2.0 * x, 0.0, 1.0)), vec3(0.72, 0.05, 0.06), clamp(2.0 * x - 1.0, 0.0, 1.0)); }

void main() {
  const vec4 texel = texture(base_colour, surface_coordinate);
  const vec4 base = vec4(linear_from_srgb(texel.rgb), texel.a) * material.base_colour;
  if (base.a < material.alpha_cutoff) discard;
  const vec3 face = cross(dFdx(world_position), dFdy(world_position));
  vec3 n = frame.shading == shading_flat ? normalize(face) : normalize(world_normal);
  const vec3 to_eye = frame.eye.xyz - world_position;
  if (frame.shading == shading_flat ? dot(n, to_eye) < 0.0 : !gl_FrontFacing) n = -n;

  vec3 shown = vec3(0);
  switch (frame.shading) {
    case shading_lit:
    case shading_flat: shown = srgb_from_linear(lit(base.rgb, n)); break;
    case shading_clay: shown = srgb_from_linear(lit(vec3(0.52, 0.50, 0.48), n)); break;
    case shading_normals: shown = 0.5 + 0.5 * n; break;
    case shading_bulge: shown = srgb_from_linear(lit(heat(bulge_height / max(frame.depth_range.z, 1e-12)), n)); break;
    case shading_depth: {
      const float z = dot(to_eye, frame.back.xyz);
      shown = vec3(1.0 - clamp((z - frame.depth_range.x) / (frame.depth_range.y - frame.depth_range.x), 0.0, 1.0));
      break;
    }
  }
  colour = vec4(shown, mix(base.a, 1.0, material.opaque));
}
