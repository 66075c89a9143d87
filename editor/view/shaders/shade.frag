// Simple shading: one colour per surface, under two lights that move with the viewer.
uniform int shading_mode;  // 0 solid, 1 colours, 2 irradiance
uniform float irradiance_scale;
uniform vec3 clay;
layout(location = 0) out vec4 colour;

vec3 base_colour(uvec2 face, vec4 value) {
  if (shading_mode == 1) return surface_row(face, 0).rgb * value.rgb;
  return clay;
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  uvec2 face = face_at(place);
  if (is_nothing(face)) discard;
  vec3 n = normal_at(place);
  vec4 value = texelFetch(values, place, 0);
  // A light from above and one at the eye, so that tops and fronts differ and no visible face is black.
  float key = max(dot(n, normalize(vec3(-0.35, 0.85, 0.6))), 0);
  float shine = 0.22 + 0.45 * key + 0.33 * max(n.z, 0);
  vec3 shown = base_colour(face, value) * shine;
  vec4 emission = surface_row(face, 1);
  if (shading_mode == 2) {
    // Stripes mark missing irradiance, so that black means no light.
    float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 12) < 6 ? 0.16 : 0.22;
    shown = value.a > 0.5 ? value.rgb * irradiance_scale : vec3(stripe) * shine;
  } else if (emission.a > 0) {
    // Emitters have the maximum brightness from the front, in the light's own colour.
    vec3 tint = emission.rgb / max(max(emission.r, emission.g), max(emission.b, 1e-6));
    shown = is_from_behind(face) ? mix(shown, tint * 0.3, 0.5) : mix(vec3(1, 0.93, 0.75), tint, 0.6) * (0.75 + 0.25 * shine);
  }
  colour = vec4(encoded(shown), 1);
}
