// Writes the G-buffer: see g_buffer.h.
uniform usamplerBuffer face_of_triangle;
uniform int first_triangle;
uniform int instance;
uniform int first_face;
uniform bool is_mirrored;
uniform bool is_orthographic;
uniform bool has_irradiance;
uniform vec3 y_axis;  // the mesh's own y axis in camera space
// The texture whose alpha decides where the faces painted now are; -1: faces without one, -2: all are opaque.
uniform int alpha_number;
uniform sampler2D image;
uniform usamplerBuffer surface_of_face;
uniform samplerBuffer surfaces;
uniform vec2 shift;  // of the pass, pixels
in vec4 vertex_value;
in vec2 vertex_uv;
layout(location = 0) out uvec2 face_out;
layout(location = 1) out vec4 normal_out;
layout(location = 2) out vec4 value_out;
layout(location = 3) out vec2 uv_out;

vec2 octahedral(vec3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  vec2 signs = vec2(n.x >= 0 ? 1 : -1, n.y >= 0 ? 1 : -1);
  vec2 folded = n.z >= 0 ? n.xy : (1 - abs(n.yx)) * signs;
  return folded * 0.5 + 0.5;
}

// The angle from the frame's own x axis to the direction of increasing u, or without uv to the horizontal in
// local space.
float tangent_angle(vec3 n) {
  vec2 along_x = dFdx(vertex_uv);
  vec2 along_y = dFdy(vertex_uv);
  float area = along_x.x * along_y.y - along_x.y * along_y.x;
  vec3 tangent = cross(y_axis, n);
  if (area != 0) tangent = (dFdx(camera_place) * along_y.y - dFdy(camera_place) * along_x.y) * sign(area);
  float side = n.z >= 0 ? 1 : -1;
  float a = -1 / (side + n.z);
  float b = n.x * n.y * a;
  vec3 x = vec3(1 + side * n.x * n.x * a, side * b, -side * n.x);
  vec3 y = vec3(b, side + n.y * n.y * a, -n.y);
  return atan(dot(tangent, y), dot(tangent, x) + 1e-20);
}

// A random number per pixel, face and pass: the passes that antialias the image blend what it decides.
float random_number(uint face) {
  uvec2 place = uvec2(gl_FragCoord.xy);
  uint x = place.x ^ (place.y * 0x9e3779b1u) ^ (face * 0x85ebca77u);
  x ^= floatBitsToUint(shift.x) ^ (floatBitsToUint(shift.y) * 0xc2b2ae3du);
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  x ^= x >> 16;
  return float(x >> 8) / 16777216.0;
}

bool is_absent(uint face, float alpha) {
  vec4 opacity = texelFetch(surfaces, 4 * int(texelFetch(surface_of_face, int(face)).r) + 3);
  if (int(opacity.z) != alpha_number) return true;
  return opacity.x > 0 ? alpha < opacity.y : random_number(face) >= opacity.y * alpha;
}

void main() {
  uint face = texelFetch(face_of_triangle, first_triangle + gl_PrimitiveID).r;
  bool from_behind = gl_FrontFacing == is_mirrored;
  face_out = uvec2(uint(instance + 1) | (from_behind ? 0x80000000u : 0u), uint(first_face) + face);
  vec3 eye = is_orthographic ? vec3(0, 0, 1) : normalize(-camera_place);
  vec3 n = shading_normal(eye);
  normal_out = vec4(octahedral(n), tangent_angle(n) / 6.28318531 + 0.5, 0);
  vec2 width = max(abs(dFdx(vertex_uv)), abs(dFdy(vertex_uv)));
  float footprint = log2(max(max(width.x, width.y), 1e-6));
  value_out = vec4(vertex_value.rgb, has_irradiance ? (vertex_value.a > 0.999 ? 1 : 0) : footprint);
  uv_out = vertex_uv;
  if (alpha_number == -2) return;
  float alpha = alpha_number >= 0 ? texture(image, vertex_uv).a : 1;
  if (is_absent(uint(first_face) + face, alpha)) discard;
}
