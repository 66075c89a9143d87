// Computes the light that a point of a surface reflects, in the common subset of GLSL and C++: see
// lit_surface.h. The frame of the point is `tangent`, `bitangent` and `normal`; `brdf_value` and
// `brdf_specular` are the BRDF's, `light_direction` towards and `light_irradiance` of each of `light_count` lights
// theirs, and `environment_radiance` is that of the surroundings, in world space. If
// `environment_is_drawn`, they draw the directions `environment_direction(i)`, i >= 0, with the solid-angle pdf
// `environment_pdf`.

real along(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
vec3 to_local(vec3 d) { return vec3(along(d, tangent), along(d, bitangent), along(d, normal)); }
vec3 to_world(vec3 d) { return tangent * d.x + bitangent * d.y + normal * d.z; }

// The tangent without uv, in the direction of the parallels of a globe.
vec3 tangent_at(vec3 n) {
  real length2 = n.x * n.x + n.z * n.z;
  return length2 > 0 ? vec3(n.z, real(0), -n.x) / sqrt(length2) : vec3(real(1), real(0), real(0));
}
vec3 bitangent_at(vec3 n) {
  vec3 t = tangent_at(n);
  return vec3(n.y * t.z - n.z * t.y, n.z * t.x - n.x * t.z, n.x * t.y - n.y * t.x);
}

// The direction towards the eye in the frame, clamped to the horizon, below which interpolated normals may
// see it.
vec3 local_eye(vec3 to_eye) {
  vec3 u = to_local(to_eye);
  u.z = max(u.z, real(1e-3f));
  return u / sqrt(along(u, u));
}

// Directions are sampled about the normal by cosine, and about the specular direction from three lobes, wide
// to narrow, in turn, so that both diffuse and glossy BRDFs are sampled well. An environment with small bright
// parts draws directions itself, instead of the widest lobe. The pdf is that of the mixture of all four.
real lobe_exponent(int lobe) { return lobe == 1 ? real(8.0f) : lobe == 2 ? real(150.0f) : real(4000.0f); }
real lobe_pdf(real cosine, real n) {
  return cosine > 0 ? (n + 1) / (2 * PI) * exp(n * log(max(cosine, real(1e-6f)))) : real(0);
}
real drawn_pdf(vec3 u, vec3 v) {
  real cosine = v.z * u.z - v.x * u.x - v.y * u.y;
  real sum = max(v.z, real(0)) / PI;
  sum += environment_is_drawn() ? environment_pdf(to_world(v)) : lobe_pdf(cosine, lobe_exponent(1));
  sum += lobe_pdf(cosine, lobe_exponent(2)) + lobe_pdf(cosine, lobe_exponent(3));
  return sum / 4;
}
real part_above_floor(real x) { return x - floor(x); }
// The i-th point of the R2 sequence, which fills the plane evenly, as cosine and azimuth about an axis. The
// sequence is shifted by (shift_a, shift_b), which differs between neighbouring pixels.
vec3 drawn_about(vec3 axis, real n, int i) {
  real a = part_above_floor(shift_a + real(0.7548776662f) * real(i));
  real b = 2 * PI * part_above_floor(shift_b + real(0.5698402910f) * real(i));
  real cosine = exp(log(max(1 - a, real(1e-6f))) / (n + 1));
  real sine = sqrt(max(real(0), 1 - cosine * cosine));
  real s = axis.z < 0 ? real(-1) : real(1);
  real p = -1 / (s + axis.z);
  real q = axis.x * axis.y * p;
  vec3 x = vec3(1 + s * axis.x * axis.x * p, s * q, -s * axis.x);
  vec3 y = vec3(q, s + axis.y * axis.y * p, -axis.y);
  return x * (sine * cos(b)) + y * (sine * sin(b)) + axis * cosine;
}
vec3 drawn_direction(vec3 u, int i) {
  int lobe = i - i / 4 * 4;
  // A cosine lobe of exponent 1 about the normal.
  if (lobe == 0) return drawn_about(vec3(real(0), real(0), real(1)), real(1), i / 4);
  if (lobe == 1 && environment_is_drawn()) return to_local(environment_direction(int(shift_a * 4096) + i / 4));
  return drawn_about(vec3(-u.x, -u.y, u.z), lobe_exponent(lobe), i / 4);
}

// The ideal specular reflection of the environment.
vec3 specular_radiance(vec3 u) {
  return brdf_specular(u) * environment_radiance(to_world(vec3(-u.x, -u.y, u.z)));
}

// The radiance due to the lights, and `weight` times the mean of `count` Monte Carlo estimates of that due to the
// environment. One loop runs over both: drivers inline the BRDF wherever it is called, so that each further call would
// make compiling as much longer.
vec3 reflected_radiance(vec3 u, int first, int count, real weight) {
  vec3 sum = vec3(real(0));
  for (int i = 0; i < light_count + count; ++i) {
    bool is_light = i < light_count;
    vec3 v = is_light ? to_local(light_direction(i)) : drawn_direction(u, first + i - light_count);
    if (v.z > 0) {
      vec3 light = is_light ? light_irradiance(i)
                            : environment_radiance(to_world(v)) * (weight / (real(count) * drawn_pdf(u, v)));
      sum += brdf_value(u, v) * light * v.z;
    }
  }
  return sum;
}
