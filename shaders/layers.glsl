// The depths of the opaque surface and of the layer that was peeled last (render/layers.h).
#ifdef SINEW_MULTISAMPLED
layout(set = 2, binding = binding_opaque_depth) uniform sampler2DMS opaque_depth;
layout(set = 2, binding = binding_layer_depth) uniform sampler2DMS layer_depth;
float depth_here(sampler2DMS map) { return texelFetch(map, ivec2(gl_FragCoord.xy), gl_SampleID).x; }
#else
layout(set = 2, binding = binding_opaque_depth) uniform sampler2D opaque_depth;
layout(set = 2, binding = binding_layer_depth) uniform sampler2D layer_depth;
float depth_here(sampler2D map) { return texelFetch(map, ivec2(gl_FragCoord.xy), 0).x; }
#endif

bool behind_layer() { return gl_FragCoord.z > depth_here(layer_depth); }
bool before_opaque() { return gl_FragCoord.z < depth_here(opaque_depth); }
