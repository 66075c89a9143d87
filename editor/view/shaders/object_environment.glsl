// An environment of the BRDF viewer and others: see studies::Environment. studio.glsl and atan2 precede this text.
uniform int sky;        // 0 none, 1 constant, 2 studio, 3 map
uniform vec3 sky_scale;
uniform vec2 sky_turn;  // cosine and sine
uniform bool sky_is_drawn;
uniform sampler2D sky_map;         // radiance, and the pdf of the directions drawn from it
uniform sampler2D sky_directions;  // these directions

vec3 rotated(vec3 d, vec2 turn) { return vec3(turn.x * d.x - turn.y * d.z, d.y, turn.y * d.x + turn.x * d.z); }

// The position of a direction on the map, (0, 0) its upper left corner and (1, 1) the lower right one.
vec2 sky_place(vec3 direction) {
  vec3 d = rotated(direction, sky_turn);
  float theta = atan2(sqrt(d.x * d.x + d.z * d.z), d.y);
  return vec2(0.5 + atan2(d.x, -d.z) / (2 * PI), theta / PI);
}

vec4 sky_texel(vec3 direction) {
  ivec2 size = textureSize(sky_map, 0);
  return texelFetch(sky_map, clamp(ivec2(sky_place(direction) * vec2(size)), ivec2(0), size - 1), 0);
}

vec3 environment_radiance(vec3 d) {
  if (sky == 3) return sky_scale * sky_texel(d).rgb;
  if (sky == 2) return sky_scale * studio_radiance(rotated(d, sky_turn));
  return sky == 1 ? sky_scale : vec3(0);
}

bool environment_is_drawn() { return sky_is_drawn; }
float environment_pdf(vec3 d) { return sky_texel(d).a; }
vec3 environment_direction(int i) {
  ivec2 size = textureSize(sky_directions, 0);
  int k = i % (size.x * size.y);
  vec3 d = texelFetch(sky_directions, ivec2(k % size.x, k / size.x), 0).xyz;
  return rotated(d, vec2(sky_turn.x, -sky_turn.y));
}
