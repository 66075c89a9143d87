// Adds what the BRDF viewer's object reflects, after lit_surface.glsl.
uniform sampler2D normals;
uniform vec2 size;
uniform vec2 shift;  // of the pass, in pixels
uniform vec3 view_forward, view_right, view_up;  // the last two are half the image plane at distance 1
uniform int first_sample;
uniform int samples;    // of the environment; 0: none
uniform float weight;   // of what the environment adds
uniform float opacity;  // of the object; 0 where it was added before
layout(location = 0) out vec4 result;

void main() {
  vec4 surface = texelFetch(normals, ivec2(gl_FragCoord.xy), 0);
  if (surface.w == 0) discard;
  normal = surface.xyz;
  tangent = tangent_at(normal);
  bitangent = bitangent_at(normal);
  vec2 at = (gl_FragCoord.xy + shift) / size * 2 - 1;
  vec3 u = local_eye(-normalize(view_forward + view_right * at.x + view_up * at.y));
  float x = floor(gl_FragCoord.x);
  float y = size.y - 1 - floor(gl_FragCoord.y);  // rows from the top
  if (sky == 3) {
    shift_a = part_above_floor(0.7548776662 * x + 0.5698402910 * y);
    shift_b = part_above_floor(0.8191725134 * x + 0.6710436067 * y);
  }
  vec3 sum = reflected_radiance(u, first_sample, samples, weight);
  if (samples > 0) sum += specular_radiance(u) * weight;
  result = vec4(sum, opacity);
}
