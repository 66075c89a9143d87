// Shades a BRDF under a headlight, distant lights and a sky, in the common subset of GLSL and C++: see
// cpu_shading.cpp. `model(u, v)` is the BRDF; `headlight`, the `light_count` lights in world space and
// `sampled_sky(d)` precede this text.

// The R2 offset of a pixel in [0,1)^2 (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences").
vec2 pixel_start(uint x, uint y) {
  uint h = x * 1973u + y * 9277u;
  h = (h ^ 61u) ^ (h >> 16);
  h *= 9u;
  h = h ^ (h >> 4);
  h *= 0x27d4eb2du;
  h = h ^ (h >> 15);
  return vec2(real(h & 0xffffu), real(h >> 16)) / 65536.0;
}

vec3 cosine_direction(vec2 xi) {
  real r = sqrt(xi.x);
  return vec3(r * cos(2 * PI * xi.y), r * sin(2 * PI * xi.y), sqrt(max(0.0, 1 - xi.x)));
}

vec3 lobe_direction(vec3 u, real exponent, vec2 xi) {
  real one_minus_cos = -expm1(log1p(-xi.x) / (exponent + 1));
  real sine = sqrt(one_minus_cos * (2 - one_minus_cos));
  vec3 h = vec3(sine * cos(2 * PI * xi.y), sine * sin(2 * PI * xi.y), 1 - one_minus_cos);
  return 2 * dot(u, h) * h - u;
}

real lobe_pdf(vec3 u, vec3 v, real exponent) {
  vec3 h = normalize(u + v);
  return (exponent + 1) / (2 * PI) * exp(-exponent / 2 * log1p(tan2_of_half(h))) / (4 * max(dot(u, h), 1e-4));
}

// Half of the directions are sampled by the cosine and half by the lobe, weighted by the pdf of their mixture.
vec3 sky_direction(vec3 u, real exponent, vec2 start, int sample) {
  vec2 xi = fract(start + real(sample / 2) * vec2(0.7548776662, 0.5698402910));
  return (sample & 1) == 0 ? cosine_direction(xi) : lobe_direction(u, exponent, xi);
}

vec3 sky_light(vec3 u, vec3 v, mat3 to_world, real exponent) {
  if (v.z <= 1e-4) return vec3(0, 0, 0);
  real pdf = 0.5 * (v.z / PI + lobe_pdf(u, v, exponent));
  return sampled_sky(to_world * v) * (v.z / pdf);
}

// One loop runs over the sky's samples, the headlight and the lights: drivers inline the BRDF wherever it is called,
// so that each further call would make compiling as much longer.
vec3 reflected_light(vec3 u, mat3 to_world, real exponent, vec2 start, int samples, int first_sample) {
  vec3 sum = vec3(0, 0, 0);
  for (int i = 0; i < samples + 1 + light_count; ++i) {
    vec3 v = u;
    vec3 light = vec3(1, 1, 1) * (headlight * u.z);
    if (i < samples) {
      v = sky_direction(u, exponent, start, i + 2 * first_sample);
      light = sky_light(u, v, to_world, exponent) / real(samples);
    } else if (i > samples) {
      v = light_directions[i - samples - 1] * to_world;
      light = light_irradiance[i - samples - 1] * v.z;
    }
    if (v.z > 1e-4 && max(light.x, max(light.y, light.z)) > 0) sum += model(u, v) * light;
  }
  return sum;
}

// Tangent, bitangent and normal in camera space. The angle is that of the tangent about the normal, over 2 pi and
// from 0 to 1.
mat3 frame_about(vec3 n, real turned) {
  real side = n.z >= 0 ? 1 : -1;
  real a = -1 / (side + n.z);
  real b = n.x * n.y * a;
  vec3 x = vec3(1 + side * n.x * n.x * a, side * b, -side * n.x);
  vec3 y = vec3(b, side + n.y * n.y * a, -n.y);
  real angle = (turned - 0.5) * 6.28318531;
  vec3 tangent = x * cos(angle) + y * sin(angle);
  return mat3(tangent, cross(n, tangent), n);
}

// Direction towards the eye in that frame, clamped to the horizon, below which interpolated normals may see it.
vec3 local_eye(vec3 eye, mat3 frame) {
  vec3 u = eye * frame;
  return normalize(vec3(u.x, u.y, max(u.z, 1e-3)));
}

// Direction towards the eye in camera space, from a position of the image in pixels.
vec3 eye_direction(vec2 place, vec2 size, vec2 tangents, bool is_parallel) {
  vec2 aside = (place / size * 2 - vec2(1, 1)) * tangents;
  return is_parallel ? vec3(0, 0, 1) : normalize(vec3(-aside.x, -aside.y, 1));
}
