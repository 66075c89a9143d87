// A sphere seen from afar. Each pass takes more directions of the environment; alpha counts the passes.
uniform float side;
uniform int first;
uniform int samples;
out vec4 result;
void main() {
  vec2 place = (gl_FragCoord.xy - vec2(side / 2)) / (0.47 * side);
  float z2 = 1 - dot(place, place);
  result = vec4(0, 0, 0, 1);
  if (z2 <= 0) return;
  normal = vec3(place, sqrt(z2));
  tangent = tangent_at(normal);
  bitangent = bitangent_at(normal);
  vec2 pixel = floor(gl_FragCoord.xy);
  shift_a = part_above_floor(0.7548776662 * pixel.x + 0.5698402910 * pixel.y);
  shift_b = part_above_floor(0.8191725134 * pixel.x + 0.6710436067 * pixel.y);
  vec3 u = local_eye(vec3(0, 0, 1));
  result.rgb = reflected_radiance(u, first, samples, 1) + specular_radiance(u);
}
