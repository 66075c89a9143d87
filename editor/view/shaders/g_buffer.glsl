// Reads the G-buffer that geometry.frag wrote, and the surface tables.
#define real float
uniform usampler2D faces;
uniform sampler2D normals;
uniform sampler2D values;
uniform sampler2D uvs;
uniform sampler2D depths;
uniform sampler2D light;
uniform sampler2D colours;
uniform usamplerBuffer selected;
uniform usamplerBuffer surface_of_face;
uniform samplerBuffer surfaces;

uvec2 face_at(ivec2 place) { return texelFetch(faces, place, 0).xy; }
bool is_nothing(uvec2 face) { return (face.x & 0x7fffffffu) == 0u; }
bool is_from_behind(uvec2 face) { return (face.x & 0x80000000u) != 0u; }

vec3 normal_at(ivec2 place) {
  vec2 folded = texelFetch(normals, place, 0).xy * 2 - 1;
  vec3 n = vec3(folded, 1 - abs(folded.x) - abs(folded.y));
  if (n.z < 0) n.xy = (1 - abs(n.yx)) * vec2(n.x >= 0 ? 1 : -1, n.y >= 0 ? 1 : -1);
  return normalize(n);
}

// The rows of a surface: 0 colour and texture, 1 emission and whether there is one, 2 first term, number of
// terms, first value of the specular part (or -1), exponent of the lobe, 3 whether it is cut out by alpha, its
// opacity (a cutoff or a factor of alpha), the texture whose alpha it reads (or -1).
vec4 surface_row(uvec2 face, int row) {
  return texelFetch(surfaces, 4 * int(texelFetch(surface_of_face, int(face.y)).r) + row);
}

vec3 encoded(vec3 linear) {
  vec3 c = clamp(linear, vec3(0), vec3(1));
  vec3 low = 12.92 * c;
  vec3 high = 1.055 * pow(c, vec3(1 / 2.4)) - 0.055;
  return mix(low, high, vec3(greaterThan(c, vec3(0.0031308))));
}
