// The key light's shadow map: depth from the light, compared by the sampler.
layout(set = 0, binding = binding_shadow_map) uniform sampler2DShadow shadow_map;

// Where the map is looked up for a point; what the map does not reach is lit.
vec3 place_in_shadow_map(vec3 position) {
  const vec4 clip = frame.light_projection * vec4(position, 1.0);
  return vec3(0.5 + 0.5 * clip.xy, min(clip.z, 1.0));
}

// The share of the key light that reaches a point of the surface: 0 in shadow to 1.
float key_light_at(vec3 position, vec3 normal) {
  // Along the normal by the filter's width, so that a surface does not shade itself.
  const vec3 at = place_in_shadow_map(position + normal * (2.5 * frame.shadow.x));
  const float step = 1.25 / float(textureSize(shadow_map, 0).x);
  float sum = textureLod(shadow_map, at, 0.0) * 2.0;
  sum += textureLod(shadow_map, at + vec3(step, step, 0.0), 0.0);
  sum += textureLod(shadow_map, at + vec3(-step, step, 0.0), 0.0);
  sum += textureLod(shadow_map, at + vec3(step, -step, 0.0), 0.0);
  sum += textureLod(shadow_map, at + vec3(-step, -step, 0.0), 0.0);
  return sum / 6.0;
}
