// A surface's material: its numbers, its textures and where they lie. Two builds: SINEW_RICH has tangents, vertex
// colours and a second set of texture coordinates; without it there is one set of coordinates only.
layout(set = 1, binding = binding_material) uniform Material { MaterialUniforms material; };
layout(set = 1, binding = binding_base_colour) uniform sampler2D base_colour_map;
#ifdef SINEW_RICH
layout(set = 1, binding = binding_metallic_roughness) uniform sampler2D metallic_roughness_map;
layout(set = 1, binding = binding_normal) uniform sampler2D normal_map;
layout(set = 1, binding = binding_occlusion) uniform sampler2D occlusion_map;
layout(set = 1, binding = binding_emissive) uniform sampler2D emissive_map;
#endif

layout(constant_id = constant_maps) const uint maps = 0;
layout(constant_id = constant_alpha) const uint alpha_mode = alpha_opaque;

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec2 surface_coordinate;
layout(location = 3) in float bulge_height;
#ifdef SINEW_RICH
layout(location = 4) in vec4 world_tangent;
layout(location = 5) in vec2 second_coordinate;
layout(location = 6) in vec4 vertex_colour;
#endif

bool has(uint map) { return (maps & map) != 0; }

// Where a texture is looked up; `texture_binding` is its binding_... constant.
vec2 place_of(uint texture_binding) {
  vec2 uv = surface_coordinate;
  if (has(map_transform)) {
    const TexturePlace place = material.places[texture_binding - binding_base_colour];
#ifdef SINEW_RICH
    uv = place.u.w > 0.5 ? second_coordinate : uv;
#endif
    uv = vec2(dot(place.u.xy, uv) + place.u.z, dot(place.v.xy, uv) + place.v.z);
  }
  return uv;
}

// Linear RGBA.
vec4 base_colour() {
  vec4 base = material.base_colour;
  if (has(map_base_colour)) base *= texture(base_colour_map, place_of(binding_base_colour));
#ifdef SINEW_RICH
  if (has(map_colours)) base *= vertex_colour;
#endif
  return base;
}

// Drops what a mask cuts away.
void cut(float alpha) {
  if (alpha_mode == alpha_mask && alpha < material.emissive.w) discard;
}
