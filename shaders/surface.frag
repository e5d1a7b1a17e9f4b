#version 460
// How a surface looks: its material in the studio's light, or one of the plain modes. SINEW_BEHIND keeps only what lies
// behind the last layer of layers.glsl.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

layout(set = 0, binding = binding_frame) uniform Frame { FrameUniforms frame; };

layout(constant_id = constant_shading) const uint shading = shading_lit;
layout(constant_id = constant_unlit) const bool unlit = false;
layout(constant_id = constant_shadows) const bool shadows = false;

#include "colour.glsl"
#include "material.glsl"
#include "lighting.glsl"
#include "shadow_map.glsl"
#ifdef SINEW_BEHIND
#include "layers.glsl"
#endif

layout(location = 0) out vec4 colour;

// Blue over white to red, for shares between 0 and 1.
vec3 heat(float x) { return mix(mix(vec3(0.23, 0.30, 0.55), vec3(0.90), clamp(2.0 * x, 0.0, 1.0)), vec3(0.72, 0.05, 0.06), clamp(2.0 * x - 1.0, 0.0, 1.0)); }

// From dark blue through teal and yellow to red: how much of a vertex follows a joint.
vec3 weight_colour(float w) {
  const vec3 none = vec3(0.012, 0.020, 0.110), some = vec3(0.010, 0.230, 0.330), half_way = vec3(0.120, 0.480, 0.120);
  const vec3 most = vec3(0.900, 0.560, 0.040), all = vec3(0.620, 0.030, 0.020);
  const float t = clamp(w, 0.0, 1.0) * 4.0;
  return mix(mix(mix(mix(none, some, clamp(t, 0.0, 1.0)), half_way, clamp(t - 1.0, 0.0, 1.0)), most, clamp(t - 2.0, 0.0, 1.0)), all, clamp(t - 3.0, 0.0, 1.0));
}

vec3 towards_eye() { return frame.eye.xyz - frame.eye.w * world_position; }

vec3 lit(Reflector r, vec3 n) {
  const vec3 to_eye = normalize(towards_eye());
  vec3 light = light_from_all_round(n, to_eye, r);
  vec3 key = light_from(key_light, frame.key.xyz, n, to_eye, r);
  if (shadows) key *= key_light_at(world_position, n);
  light += key;
  light += light_from(fill_light, frame.fill.xyz, n, to_eye, r);
  light += light_from(rim_light, frame.rim.xyz, n, to_eye, r);
  return light;
}

vec3 plain(vec3 diffuse, vec3 n) { return lit(Reflector(diffuse, vec3(0.04), 0.62, 1.0), n); }

Reflector reflector(vec3 base) {
  float metallic = material.surface.x, roughness = material.surface.y, occlusion = 1.0;
#ifdef SINEW_RICH
  if (has(map_metallic_roughness)) {
    const vec4 texel = texture(metallic_roughness_map, place_of(binding_metallic_roughness));
    metallic *= texel.b;
    roughness *= texel.g;
  }
  if (has(map_occlusion))
    occlusion = mix(1.0, texture(occlusion_map, place_of(binding_occlusion)).r, material.surface.w);
#endif
  return Reflector(base * (1.0 - metallic), mix(material.specular.rgb, base, metallic), max(roughness, 0.08), occlusion);
}

vec3 emission() {
  vec3 emitted = material.emissive.rgb;
#ifdef SINEW_RICH
  if (has(map_emissive)) emitted *= texture(emissive_map, place_of(binding_emissive)).rgb;
#endif
  return emitted;
}

vec3 facing_normal() {
  if (shading == shading_flat) {
    const vec3 n = normalize(cross(dFdx(world_position), dFdy(world_position)));
    return dot(n, towards_eye()) < 0.0 ? -n : n;
  }
  vec3 n = normalize(world_normal);
#ifdef SINEW_RICH
  if (has(map_normal)) {
    vec3 relief = 2.0 * texture(normal_map, place_of(binding_normal)).xyz - 1.0;
    relief.xy *= material.surface.z;
    const vec3 bitangent = cross(n, world_tangent.xyz) * world_tangent.w;
    n = normalize(relief.x * world_tangent.xyz + relief.y * bitangent + relief.z * n);
  }
#endif
  return gl_FrontFacing ? n : -n;
}

void main() {
  const vec4 base = base_colour();
  cut(base.a);
#ifdef SINEW_BEHIND
  if (!behind_layer()) discard;
#endif
  const vec3 n = facing_normal();
  vec3 shown = vec3(0);
  switch (shading) {
    case shading_lit:
    case shading_flat: shown = srgb_from_linear(unlit ? base.rgb : lit(reflector(base.rgb), n) + emission()); break;
    case shading_clay: shown = srgb_from_linear(plain(vec3(0.52, 0.50, 0.48), n)); break;
    case shading_normals: shown = 0.5 + 0.5 * n; break;
#ifdef SINEW_RICH
    case shading_weights: shown = srgb_from_linear(plain(weight_colour(vertex_colour.r), n)); break;
#endif
    case shading_bulge: shown = srgb_from_linear(plain(heat(bulge_height / max(frame.depth_range.z, 1e-12)), n)); break;
    case shading_depth: {
      const float z = frame.back.w - dot(world_position, frame.back.xyz);
      shown = vec3(1.0 - clamp((z - frame.depth_range.x) / (frame.depth_range.y - frame.depth_range.x), 0.0, 1.0));
      break;
    }
  }
  colour = vec4(shown, alpha_mode == alpha_blend ? base.a : 1.0);
}
