// Tone maps the radiance for the screen, after specular reflection and emission are added.
uniform samplerBuffer terms;
uniform mat3 camera_to_world;
uniform bool is_orthographic;
uniform vec2 screen_size;
uniform vec2 half_size;
uniform int mirror_values;
layout(location = 0) out vec4 colour;

vec3 mirror_part(uvec2 face, int first, vec3 eye, vec3 n, vec3 paint) {
  float at = max(dot(eye, n), 0) * float(mirror_values - 1);
  int low = min(int(at), mirror_values - 2);
  vec3 weight = mix(texelFetch(terms, first + low).rgb, texelFetch(terms, first + low + 1).rgb, at - float(low));
  return paint * weight * visible_sky(camera_to_world * reflect(-eye, n));
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  uvec2 face = face_at(place);
  if (is_nothing(face)) discard;
  vec3 radiance = texelFetch(light, place, 0).rgb;
  vec2 aside = (gl_FragCoord.xy / screen_size * 2 - 1) * half_size;
  vec3 eye = is_orthographic ? vec3(0, 0, 1) : normalize(vec3(-aside, 1));
  int mirror = int(surface_row(face, 2).z);
  vec3 paint = surface_row(face, 0).rgb * texelFetch(values, place, 0).rgb;
  if (mirror >= 0) radiance += mirror_part(face, mirror, eye, normal_at(place), paint);
  if (!is_from_behind(face)) radiance += surface_row(face, 1).rgb;
  colour = vec4(tone_mapped(radiance), 1);
}
