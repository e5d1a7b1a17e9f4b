#version 460
// One triangle over the whole image.
layout(location = 0) out vec2 place;  // on the image, 0 to 1

void main() {
  const vec2 corner = vec2((gl_VertexIndex << 1) & 2, gl_VertexIndex & 2);
  place = corner;
  gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
