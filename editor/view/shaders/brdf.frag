// Shades the surfaces of one BRDF model. The model's formula, `model(u, v)` and reflected_light.glsl precede
// this text.
uniform int model_number;
uniform mat3 camera_to_world;
uniform bool is_orthographic;
uniform vec2 screen_size;
uniform vec2 half_size;  // of the image plane at distance 1
uniform int sky_samples;
uniform int pass;
layout(location = 0) out vec4 colour;

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  uvec2 face = face_at(place);
  if (is_nothing(face)) discard;
  vec4 brdf = surface_row(face, 2);
  mat3 frame = frame_about(normal_at(place), texelFetch(normals, place, 0).z);
  vec3 u = local_eye(eye_direction(gl_FragCoord.xy, screen_size, half_size, is_orthographic), frame);
  vec2 start = pixel_start(uint(place.x), uint(place.y));
  vec3 sum = vec3(0);
  int term = int(brdf.x);
  for (int i = 0; i < int(brdf.y); ++i) {
    vec4 head = texelFetch(terms, term);
    if (int(head.y) == model_number) {
      first_parameter = term + 1;
      first_transmission = int(head.w) > 0 ? term + 1 + int(head.z) : 0;
      sum += head.x * reflected_light(u, camera_to_world * frame, brdf.w, start, sky_samples, pass * sky_samples);
    }
    term += 1 + int(head.z) + int(head.w);
  }
  vec3 paint = surface_row(face, 0).rgb * texelFetch(values, place, 0).rgb;
  colour = vec4(sum * paint, 1);
}
