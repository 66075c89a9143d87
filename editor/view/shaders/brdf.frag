// What one BRDF model reflects of a light at the viewer's head and of a sky. The model's formula and `model(u, v)`
// stand before this text.
uniform int model_number;
uniform mat3 camera_to_world;
uniform bool is_orthographic;
uniform vec2 screen_size;
uniform vec2 half_size;  // of what is seen, at distance 1
uniform int sky_samples;
uniform int pass;
layout(location = 0) out vec4 colour;

// Numbers in [0,1) that fill the square evenly (Roberts 2018, "The unreasonable effectiveness of quasirandom
// sequences"), from another start in each pixel.
vec2 uniforms(int i) {
  uvec2 p = uvec2(gl_FragCoord.xy);
  uint h = p.x * 1973u + p.y * 9277u;
  h = (h ^ 61u) ^ (h >> 16);
  h *= 9u;
  h = h ^ (h >> 4);
  h *= 0x27d4eb2du;
  h = h ^ (h >> 15);
  vec2 start = vec2(float(h & 0xffffu), float(h >> 16)) / 65536.0;
  return fract(start + float(i) * vec2(0.7548776662, 0.5698402910));
}

vec3 cosine_direction(vec2 xi) {
  float r = sqrt(xi.x);
  return vec3(r * cos(2 * PI * xi.y), r * sin(2 * PI * xi.y), sqrt(max(0.0, 1 - xi.x)));
}

vec3 lobe_direction(vec3 u, float exponent, vec2 xi) {
  float below_one = -expm1(log1p(-xi.x) / (exponent + 1));
  float sine = sqrt(below_one * (2 - below_one));
  vec3 h = vec3(sine * cos(2 * PI * xi.y), sine * sin(2 * PI * xi.y), 1 - below_one);
  return 2 * dot(u, h) * h - u;
}

float lobe_density(vec3 u, vec3 v, float exponent) {
  vec3 h = normalize(u + v);
  return (exponent + 1) / (2 * PI) * exp(-exponent / 2 * log1p(tan2_of_half(h))) / (4 * max(dot(u, h), 1e-4));
}

// Half of the directions are drawn by the cosine and half by the lobe, each weighed by both densities.
vec3 sky_part(vec3 u, mat3 to_world, float exponent) {
  vec3 sum = vec3(0);
  for (int i = 0; i < sky_samples; ++i) {
    vec2 xi = uniforms(i / 2 + pass * sky_samples);
    vec3 v = (i & 1) == 0 ? cosine_direction(xi) : lobe_direction(u, exponent, xi);
    if (v.z <= 1e-4) continue;
    float density = 0.5 * (v.z / PI + lobe_density(u, v, exponent));
    sum += model(u, v) * sky(to_world * v) * (v.z / density);
  }
  return sum / float(sky_samples);
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  uvec2 face = face_at(place);
  if (is_nothing(face)) discard;
  vec4 brdf = surface_row(face, 2);
  vec3 n = normal_at(place);
  vec2 aside = (gl_FragCoord.xy / screen_size * 2 - 1) * half_size;
  vec3 eye = is_orthographic ? vec3(0, 0, 1) : normalize(vec3(-aside, 1));
  mat3 frame = frame_at(place, n);
  vec3 u = eye * frame;
  u = normalize(vec3(u.xy, max(u.z, 1e-3)));
  vec3 sum = vec3(0);
  int term = int(brdf.x);
  for (int i = 0; i < int(brdf.y); ++i) {
    vec4 head = texelFetch(terms, term);
    if (int(head.y) == model_number) {
      first_parameter = term + 1;
      sum += head.x * (model(u, u) * (1.6 * u.z) + sky_part(u, camera_to_world * frame, brdf.w));
    }
    term += 1 + int(head.z);
  }
  vec3 paint = surface_row(face, 0).rgb * texelFetch(values, place, 0).rgb;
  colour = vec4(sum * paint, 1);
}
